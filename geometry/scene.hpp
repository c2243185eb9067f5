#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>

#include "core/vec.hpp"

namespace nadir::geometry {

/// Objects may be there at some times only: a scene has up to 32 epochs, one bit each. Bit 0 is the
/// moment of the picture.
inline constexpr std::uint32_t at_the_picture = 1U;
inline constexpr std::uint32_t always = ~0U;

/// A half line in scene axes (local east-north-up, metres, double). `direction` is a unit vector.
struct Ray {
  Vec3 origin;
  Vec3 direction;
  double max_distance = std::numeric_limits<double>::infinity();
  std::uint32_t epochs = at_the_picture;  ///< it meets what is there in any of these
};

/// Where a ray first meets a surface.
struct Hit {
  double distance = 0.0;  ///< from the ray's origin, m, double precision
  Vec3 position;          ///< on the surface, scene axes, m
  Vec3 normal;            ///< geometric unit normal, turned towards the side the ray came from
  Vec2 uv;                ///< barycentric or parametric coordinates on the primitive
  Vec2 texture;           ///< texture coordinates, where the mesh has them
  Vec3 tangent;           ///< unit, in the surface, along growing texture u; 0 without them
  bool mirrored_texture = false;  ///< v grows against cross(normal, tangent)
  std::uint32_t material = 0;     ///< index into the scenario's list of materials
  std::uint32_t object = 0;       ///< which object of the scenario, in the order of the file
  std::uint32_t instance = 0;     ///< number within an instance list, 0 where there is none
  std::uint32_t primitive = 0;    ///< triangle or shape within its mesh
  std::uint64_t facet = 0;        ///< number of the triangle or face in the whole scene, every
                                  ///< instance counted for itself
  bool indirect = false;          ///< seen by way of another surface: details do not show
  bool back_face = false;         ///< the ray came from the side that the normal pointed away from
  double lift = 0.0;              ///< how far leaving_origin lifts a ray off the surface, m
  Vec3 inset{};  ///< how it moves it off an edge of the triangle as well, along the surface, m
};

struct Bounds {
  Vec3 lo, hi;
};

/// How long a facet is along its parameters, in scene axes.
struct FacetSize {
  bool triangle = true;
  double u_m = 0.0;  ///< of a triangle its longest edge; of a face its greatest length along u
  double v_m = 0.0;  ///< of a face: along v
};

/// All that rays can hit, ready to be traced from many threads. Cheap to copy (shared, immutable).
///
/// Embree finds the surface in floats about the scene's centre; distance, position and normal are
/// then computed in double from the surface as it is stored (vertices and instance transforms in
/// float). A hit that double precision puts behind the origin is refused, so that a ray that starts
/// off a surface never meets it again. With S the largest half extent of the scene and u = 2^-23 S:
///   - stored surfaces lie within u/2 of what was given (about 0.06 mm a kilometre of scene);
///   - which surface is found at an edge is decided to within a few u, from any distance;
///   - distance and position are consistent with the stored surface to double precision.
/// Rays that go down and find nothing are tried again, displaced by 2, 4 and 8 u, because float
/// rounding lets one ray in fifty slip through when aimed exactly at a vertex.
class Scene {
 public:
  struct Data;
  explicit Scene(std::shared_ptr<const Data> data);

  /// The first surface along the ray, or none.
  [[nodiscard]] std::optional<Hit> intersect(const Ray& ray) const;
  /// Whether any surface lies on the ray before its max_distance.
  [[nodiscard]] bool occluded(const Ray& ray) const;
  /// Axis-aligned bounds in scene axes; instances count with their prototype's box. Zero if empty.
  [[nodiscard]] Bounds bounds() const;
  /// Triangles and faces of shapes (a box has six, a capped cylinder three), instances counted one
  /// by one: Hit::facet is below this.
  [[nodiscard]] std::uint64_t facets() const;
  [[nodiscard]] FacetSize facet_size(std::uint64_t facet) const;
  /// The hit that a ray straight upon the facet's outward side (or with `back` its other side) at
  /// those parameters (Hit::uv) would have; its distance is 0.
  [[nodiscard]] Hit on_facet(std::uint64_t facet, Vec2 uv, bool back) const;
  /// What the mesh gives vertex by vertex (TriangleMesh::vertex_values), interpolated at a hit; NaN
  /// where it gives nothing.
  [[nodiscard]] double vertex_value(const Hit& hit) const;
  /// Triangles and shapes stored, and those that instances stand for.
  [[nodiscard]] std::uint64_t stored_primitives() const;
  [[nodiscard]] std::uint64_t represented_primitives() const;

 private:
  std::shared_ptr<const Data> data_;
};

/// Origin for a ray that leaves `hit` towards `direction`: lifted off the surface on that side by a
/// few units of float resolution at that place, so that it neither meets the surface that it leaves
/// nor skips one a millimetre away (in a scene of a kilometre: the lift is at most 0.36 mm). From
/// an edge of a triangle it is moved inwards as far: a place that lies exactly in the plane of the
/// neighbour would let rays slip out behind that.
/// Idea: Waechter & Binder, "A Fast and Robust Method for Avoiding Self-Intersection", Ray Tracing
/// Gems (2019), ch. 6; here the lift depends on the place alone, and the double test does the rest.
[[nodiscard]] Vec3 leaving_origin(const Hit& hit, Vec3 direction);

}  // namespace nadir::geometry
