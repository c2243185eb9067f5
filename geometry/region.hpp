#pragma once

#include <optional>
#include <variant>

#include "core/transform.hpp"
#include "geometry/scene.hpp"
#include "geometry/shapes.hpp"

namespace nadir::geometry {

/// A closed shape that fills space: what volumes occupy. Its own axes, m.
using RegionShape = std::variant<Box, Sphere, Cylinder>;  // a cylinder counts as capped

/// Part of a ray, in distances from its origin, m.
struct Interval {
  double begin = 0.0, end = 0.0;
};

/// A region in scene axes. Convex, so that a ray has at most one part inside.
class Region {
 public:
  /// @throws InputError for empty shapes and placements that are singular or not finite
  Region(const RegionShape& shape, const Affine& placement);

  /// The part of the ray inside, cut to [0, ray.max_distance]; none where it is empty.
  [[nodiscard]] std::optional<Interval> crossing(const Ray& ray) const noexcept;
  [[nodiscard]] bool contains(Vec3 point) const noexcept;
  /// In the shape's own axes, scaled so that a box is [0, 1]^3 (what a grid is looked up by), a
  /// sphere has radius 1 about 0, and a cylinder radius 1 about the z axis from z = 0 to 1.
  [[nodiscard]] Vec3 to_own_axes(Vec3 point) const noexcept { return from_scene_.point(point); }
  /// The same for a direction; distances along a ray are the same in both axes.
  [[nodiscard]] Vec3 direction_to_own_axes(Vec3 direction) const noexcept {
    return from_scene_.vector(direction);
  }
  [[nodiscard]] const RegionShape& shape() const noexcept { return shape_; }
  [[nodiscard]] Bounds bounds() const noexcept;

 private:
  RegionShape shape_;
  Affine to_scene_, from_scene_;  // of the unit shape
};

}  // namespace nadir::geometry
