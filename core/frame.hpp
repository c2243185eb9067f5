#pragma once

#include <cmath>

#include "core/vec.hpp"

namespace nadir {

/// Right-handed orthonormal axes, given in the coordinates of the surrounding frame.
struct Frame {
  Vec3 x{1.0, 0.0, 0.0}, y{0.0, 1.0, 0.0}, z{0.0, 0.0, 1.0};

  [[nodiscard]] constexpr Vec3 to_local(Vec3 world) const {
    return {dot(world, x), dot(world, y), dot(world, z)};
  }
  [[nodiscard]] constexpr Vec3 to_world(Vec3 local) const {
    return local.x * x + local.y * y + local.z * z;
  }
};

/// Axes about a unit vector z, without a singular direction.
/// Source: Duff et al., "Building an Orthonormal Basis, Revisited", JCGT 6(1), 2017.
[[nodiscard]] inline Frame frame_about(Vec3 z) {
  const double sign = std::copysign(1.0, z.z);
  const double a = -1.0 / (sign + z.z);
  const double b = z.x * z.y * a;
  return {{1.0 + sign * z.x * z.x * a, sign * b, -sign * z.x}, {b, sign + z.y * z.y * a, -z.y}, z};
}

/// Unit vector in local east-north-up axes. Azimuth clockwise from north, elevation above the
/// horizontal plane, both in radians.
[[nodiscard]] inline Vec3 direction_enu(double azimuth_rad, double elevation_rad) {
  const double horizontal = std::cos(elevation_rad);
  return {horizontal * std::sin(azimuth_rad), horizontal * std::cos(azimuth_rad),
          std::sin(elevation_rad)};
}

}  // namespace nadir
