#pragma once
// Private to this folder: what a SceneBuilder has gathered, checked, in double.

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/transform.hpp"
#include "geometry/bounds.hpp"
#include "geometry/scene_builder.hpp"
#include "geometry/shape_hit.hpp"

namespace nadir::geometry {

/// A surface in the axes of what holds it: the scene, or a prototype.
struct GatheredItem {
  std::vector<Vec3> positions;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<std::array<float, 2>> texture;      ///< by position, or empty
  std::vector<float> vertex_values;               ///< likewise
  std::vector<std::uint32_t> triangle_materials;  ///< empty where all have the first material
  std::uint32_t material = 0;
  std::uint32_t object = 0;
  std::uint32_t epochs = always;
  bool mirrored = false;
  std::optional<Shape> shape;
  Affine placement;  ///< of the shape; a mesh has it in its positions
  Bounds bounds = no_bounds;

  [[nodiscard]] std::uint64_t primitives() const { return shape ? 1 : triangles.size(); }
  [[nodiscard]] std::uint64_t facets() const { return shape ? faces_of(*shape) : triangles.size(); }
};

struct GatheredPrototype {
  std::vector<GatheredItem> items;
  std::vector<Affine> placements;
  std::uint32_t object = 0;
  Bounds bounds = no_bounds;
};

struct SceneBuilder::State {
  std::vector<GatheredItem> items;
  std::vector<GatheredPrototype> prototypes;
};

/// Checks a surface and takes it to the axes of `placement`.
[[nodiscard]] GatheredItem gather(const Surface& surface, const Affine& placement,
                                  std::uint32_t object);

/// Hands everything to Embree.
[[nodiscard]] Scene assemble(const SceneBuilder::State& state);

}  // namespace nadir::geometry
