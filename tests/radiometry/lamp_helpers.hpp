#pragma once

#include <algorithm>
#include <cstdint>
#include <numbers>

#include "radiometry/lamps/bound_lamps.hpp"

// What the tests of lamps share: lamps of one flux at two wavelengths, and what a plane gets from
// them.

namespace nadir::test {

inline constexpr double pi = std::numbers::pi;
inline const Vec3 up{0.0, 0.0, 1.0};

inline spectral::Lanes two_lanes() { return spectral::Lanes{{Micrometres{0.5}, Micrometres{0.6}}}; }

inline radiometry::Lamp point_lamp(Vec3 place, double flux, radiometry::CosinePower shape = {}) {
  return {.name = "point",
          .form = radiometry::PointLamp{.position = place, .shape = shape},
          .flux = spectral::Curve::constant(flux)};
}
/// A lamp that shines down from `place`, in the given shape.
template <class Shape>
radiometry::Lamp area_lamp(Shape shape, Vec3 place, double flux, std::uint32_t object = 0) {
  return {.name = "area",
          .form = radiometry::AreaLamp{shape, place, {1.0, 0.0, 0.0}, {0.0, -1.0, 0.0}, object},
          .flux = spectral::Curve::constant(flux)};
}

/// Irradiance on the plane through `place`, by the midpoint rule over n x n points of the lamp.
inline double irradiance(const radiometry::BoundLamps& lamps, Vec3 place, Vec3 normal, int n = 64) {
  double sum = 0.0;
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      const auto s = lamps.sample(place, normal, 0.5, {(i + 0.5) / n, (j + 0.5) / n});
      if (s)
        sum += static_cast<double>(s->irradiance[0]) * std::max(0.0, dot(s->direction, normal));
    }
  }
  return sum / (n * n);
}

}  // namespace nadir::test
