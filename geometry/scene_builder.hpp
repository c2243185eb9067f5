#pragma once

#include <cstdint>
#include <memory>
#include <variant>
#include <vector>

#include "core/transform.hpp"
#include "geometry/mesh.hpp"
#include "geometry/scene.hpp"
#include "geometry/shapes.hpp"

namespace nadir::geometry {

/// Something to hit, in its own axes, with a material for every part.
struct Surface {
  std::variant<TriangleMesh, Shape> form;
  std::vector<std::uint32_t> part_materials;  ///< for each part of a mesh; one entry for a shape
  std::uint32_t epochs = always;              ///< when it is there (Ray::epochs)
};

/// Gathers what the scenario describes and hands it to Embree.
///
/// A prototype is geometry that is stored once and placed many times. Distributions' Embree knows
/// one level of instances, so the caller flattens nested lists into one list of placements first.
/// Mirroring placements keep outward sides outward. Triangles without area are stored but never
/// hit.
class SceneBuilder {
 public:
  struct State;
  SceneBuilder();
  ~SceneBuilder();
  SceneBuilder(SceneBuilder&&) noexcept;
  SceneBuilder& operator=(SceneBuilder&&) noexcept;

  /// Places a surface once, its coordinates taken to scene axes by `placement` (baked in double).
  /// @throws InputError for non-finite vertices, indices out of range, parts without a material,
  ///         a mesh without triangles, texture coordinates or vertex values for some vertices only
  ///         or not finite,
  ///         degenerate shapes and singular placements.
  void add(const Surface& surface, const Affine& placement, std::uint32_t object);
  /// Stores surfaces once and places them many times. Same errors.
  void add_instances(const std::vector<Surface>& prototype, const std::vector<Affine>& placements,
                     std::uint32_t object);
  /// Builds the acceleration structure. The builder is empty afterwards.
  /// @throws std::runtime_error when Embree fails, for want of memory as a rule, or when it was
  ///         built without ray masks and a surface is there in some epochs only.
  [[nodiscard]] Scene build();

 private:
  std::unique_ptr<State> state_;
};

}  // namespace nadir::geometry
