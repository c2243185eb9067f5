#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/vec.hpp"
#include "geometry/scene.hpp"

namespace nadir::radiometry {

/// What the hierarchy knows of a lamp: where it is, and where it may shine.
struct LightTreeItem {
  geometry::Bounds box;
  Vec3 axis{0.0, 0.0, 1.0};  ///< unit
  double spread_rad = 0.0;   ///< intensity is at most `weight` cos(max(0, angle to axis - spread))
  double fade_rad = 0.0;     ///< and 0 where that difference exceeds this, at most pi/2
  double weight = 0.0;       ///< greatest intensity, mean over the lanes; >= 0
};

/// A hierarchy of lamps from which one is drawn for a place on a surface, with a chance that is
/// near its share of the light there and is known exactly.
///
/// Each node bounds its lamps by a sphere and a cone of axes; importance = intensity cos(emission)
/// cos(incidence) / distance^2, the angles taken where the sphere makes them most favourable. So it
/// is 0 only where none of the node's lamps can light the place, and an unbiased estimate may
/// divide by the chance. Nodes have eight children whose importances are computed together: fewer
/// levels are faster, and crude bounds high in the tree decide less. Source: Conty Estevez & Kulla,
/// "Importance Sampling of Many Lights With Adaptive Tree Splitting", Proc. ACM Comput. Graph.
/// Interact. Tech. 1(2), 25 (2018), doi:10.1145/3233305. Deviations: peak intensity instead of
/// power (a narrow beam is brighter than its power says), eight children.
class LightTree {
 public:
  struct Draw {
    std::uint32_t item = 0;
    double probability = 0.0;  ///< > 0
  };

  LightTree() = default;
  /// Items without weight are never drawn.
  explicit LightTree(const std::vector<LightTreeItem>& items);

  [[nodiscard]] bool empty() const noexcept { return nodes_.empty(); }
  /// @param normal  unit; zero where light from all sides counts
  /// @param choice  in [0, 1)
  /// @return none where the part of the hierarchy that `choice` leads to cannot light the place
  [[nodiscard]] std::optional<Draw> draw(Vec3 position, Vec3 normal, double choice) const noexcept;
  /// The chance of `draw` to give that item, 0 included.
  [[nodiscard]] double probability(std::uint32_t item, Vec3 position, Vec3 normal) const noexcept;

 private:
  friend class LightTreeBuilder;
  static constexpr int width = 8;
  template <class T>
  using Row = std::array<T, width>;
  using Importances = Row<float>;

  struct Link {
    std::uint32_t node = 0;
    std::uint8_t slot = 0;
  };
  /// Children side by side, so that the compiler treats four at a time. Places are in double: what
  /// is in float is relative to the point that is lit.
  struct alignas(64) Node {
    Row<double> x{}, y{}, z{};
    Row<float> radius{}, axis_x{}, axis_y{}, axis_z{};
    Row<float> cos_spread{}, sin_spread{}, cos_fade{};
    Row<float> weight{};         // 0 for a slot without child
    Row<std::uint32_t> child{};  // a node, or an item
    Row<bool> is_item{};
    Link parent;
  };

  static float importances(const Node& node, Vec3 position, Vec3 normal,
                           Importances& of_children) noexcept;

  std::vector<Node> nodes_;     // the root first
  std::vector<Link> place_of_;  // by item
  std::vector<bool> is_in_;     // by item: has weight
};

}  // namespace nadir::radiometry
