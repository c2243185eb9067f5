#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/transform.hpp"
#include "geometry/scene.hpp"

namespace nadir::geometry {

/// Bounds of nothing: merging with them changes nothing.
inline constexpr Bounds no_bounds{
    {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity(),
     std::numeric_limits<double>::infinity()},
    {-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity(),
     -std::numeric_limits<double>::infinity()}};

[[nodiscard]] inline Bounds merged(const Bounds& a, const Bounds& b) {
  return {{std::min(a.lo.x, b.lo.x), std::min(a.lo.y, b.lo.y), std::min(a.lo.z, b.lo.z)},
          {std::max(a.hi.x, b.hi.x), std::max(a.hi.y, b.hi.y), std::max(a.hi.z, b.hi.z)}};
}
[[nodiscard]] inline Bounds merged(const Bounds& a, Vec3 point) {
  return merged(a, Bounds{point, point});
}
[[nodiscard]] inline Vec3 centre_of(const Bounds& b) { return 0.5 * (b.lo + b.hi); }

/// The largest coordinate of a vector, without sign.
[[nodiscard]] inline double largest(Vec3 v) {
  return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

/// The axis-aligned bounds of a box after an affine map.
[[nodiscard]] inline Bounds transformed(const Bounds& b, const Affine& map) {
  const Vec3 centre = map.point(centre_of(b)), half = 0.5 * (b.hi - b.lo);
  const Vec3 x = half.x * map.linear.x, y = half.y * map.linear.y, z = half.z * map.linear.z;
  const Vec3 reach{std::abs(x.x) + std::abs(y.x) + std::abs(z.x),
                   std::abs(x.y) + std::abs(y.y) + std::abs(z.y),
                   std::abs(x.z) + std::abs(y.z) + std::abs(z.z)};
  return {centre - reach, centre + reach};
}

}  // namespace nadir::geometry
