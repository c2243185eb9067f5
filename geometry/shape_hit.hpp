#pragma once

#include <cstdint>
#include <optional>

#include "core/transform.hpp"
#include "core/vec.hpp"
#include "geometry/scene.hpp"
#include "geometry/shapes.hpp"

namespace nadir::geometry {

/// Where a line meets a shape, in the shape's own axes.
struct ShapeHit {
  double t = 0.0;          ///< parameter along the line
  Vec3 position;           ///< snapped onto the surface, m
  Vec3 normal;             ///< outward unit normal; disc and plane: their positive side
  Vec2 uv;                 ///< see first_hit
  std::uint32_t face = 0;  ///< of a box -x, +x, -y, +y, -z, +z; of a cylinder side, base, top
};

/// The first point origin + t direction of the shape with 0 < t <= t_max, all in double.
///
/// `direction` need not be a unit vector (it comes through instance transforms). Closed shapes
/// are cut as convex bodies, so that a line from inside always finds its way out.
/// uv: sphere (azimuth / 2 pi, angle from +z / pi); disc and caps (r / R, azimuth / 2 pi); box
/// faces and plane (fractions of the sides); cylinder (azimuth / 2 pi, fraction of the height).
/// Accuracy: a few 1e-16 of the larger of shape size and distance. The quadratic is solved after
/// Haines et al., "Precision Improvements for Ray/Sphere Intersection", Ray Tracing Gems (2019),
/// ch. 7.
[[nodiscard]] std::optional<ShapeHit> first_hit(const Shape& shape, Vec3 origin, Vec3 direction,
                                                double t_max);

[[nodiscard]] std::uint32_t faces_of(const Shape& shape);

/// The place of a face at the parameters that first_hit gives it; its t is 0.
[[nodiscard]] ShapeHit on_face(const Shape& shape, std::uint32_t face, Vec2 uv);

/// The greatest length of the placed face's derivative to u and to v, m: whatever part of the
/// parameters' range a piece of it takes, it is no longer than that part of this.
[[nodiscard]] FacetSize face_size(const Shape& shape, std::uint32_t face, const Mat3& placement);

/// Tight bounds of the shape after `placement`.
[[nodiscard]] Bounds bounds_of(const Shape& shape, const Affine& placement);

/// @throws InputError for sizes that are not finite and positive.
void validate(const Shape& shape);

}  // namespace nadir::geometry
