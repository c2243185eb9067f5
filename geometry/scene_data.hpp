#pragma once
// Private to this folder: what a built scene holds.

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/transform.hpp"
#include "geometry/bounds.hpp"
#include "geometry/embree.hpp"
#include "geometry/scene.hpp"
#include "geometry/shapes.hpp"

namespace nadir::geometry {

/// A shape and the way between its own axes and those of its Embree scene.
struct PlacedShape {
  Shape shape;
  Affine to_scene, from_scene;
  Bounds padded;  ///< for Embree: with room for the rounding of rays
};

/// One Embree geometry that is not an instance: a mesh, or one shape.
struct Item {
  const float* vertices = nullptr;                ///< three floats each, in Embree's own buffer
  const std::uint32_t* triangles = nullptr;       ///< three indices each, likewise
  std::vector<std::uint32_t> triangle_materials;  ///< empty where all have the first material
  std::vector<std::array<float, 2>> texture;      ///< by vertex; empty where the mesh has none
  std::vector<float> vertex_values;               ///< likewise
  std::uint64_t first_facet = 0;  ///< in the scene; in a prototype: among those of one instance
  std::uint32_t material = 0;
  std::uint32_t object = 0;
  bool mirrored = false;  ///< the placement turned the winding round
  std::optional<PlacedShape> shape;

  [[nodiscard]] std::uint32_t material_of(std::uint32_t primitive) const {
    return triangle_materials.empty() ? material : triangle_materials[primitive];
  }
};

/// Its instances follow one another, in the scene's list and in the numbers of their facets.
struct Prototype {
  embree::SceneHandle scene;
  std::vector<Item> items;
  std::uint64_t facets = 0;          ///< of one instance
  std::uint64_t first_facet = 0;     ///< of the first instance, in the scene
  std::uint64_t first_instance = 0;  ///< in the scene's list
};

/// A placement. Its transform is Embree's, from prototype axes (about the prototype's centre) to
/// scene axes (about the scene's centre), in float: kept here as well it would cost every tree
/// another 48 bytes.
struct Instance {
  std::uint32_t prototype = 0;
  std::uint32_t object = 0;
  std::uint32_t number = 0;
  bool mirrored = false;
};

struct Scene::Data {
  embree::Device device;
  embree::SceneHandle top;
  std::vector<Item> items;          ///< geometry i of the top scene
  std::vector<Instance> instances;  ///< geometry items.size() + i of the top scene
  std::vector<Prototype> prototypes;
  Bounds bounds;        ///< scene axes
  Bounds padded;        ///< about the centre, with room for float rounding
  Vec3 centre;          ///< scene axes
  double extent = 0.0;  ///< largest half extent, m
  std::uint64_t stored = 0, represented = 0, facets = 0;

  [[nodiscard]] Affine placement(const Instance& instance) const {
    const auto index = items.size() + static_cast<std::size_t>(&instance - instances.data());
    std::array<float, 12> c{};  // columns
    rtcGetGeometryTransform(rtcGetGeometry(top.get(), static_cast<unsigned>(index)), 0.0F,
                            RTC_FORMAT_FLOAT3X4_COLUMN_MAJOR, c.data());
    return {{{c[0], c[1], c[2]}, {c[3], c[4], c[5]}, {c[6], c[7], c[8]}}, {c[9], c[10], c[11]}};
  }
};

/// One unit of float rounding at a coordinate of 1.
inline constexpr double float_step = 0x1.0p-23;

/// Size of float rounding for rays about `point` (from the scene's centre): that of its
/// coordinates, but no less than near the middle of the scene, where other vertices than the
/// nearest set the rounding.
[[nodiscard]] inline double rounding_at(const Scene::Data& data, Vec3 point) {
  return float_step * std::max(largest(point), data.extent / 32.0);
}

/// Callbacks through which Embree meets a shape; the user pointer is its Item.
void attach_shape_callbacks(RTCGeometry geometry, const Item* item);

}  // namespace nadir::geometry
