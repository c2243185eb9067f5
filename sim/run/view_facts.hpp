#pragma once

#include "geometry/scene.hpp"
#include "sim/run/camera.hpp"

namespace nadir::sim {

/// Where an array looks, from 17 x 17 lines of sight over it, corners included.
struct ViewFacts {
  Vec3 axis{0.0, 0.0, -1.0};     ///< mean line of sight, scene axes
  double half_angle_rad = 0.0;   ///< of the cone about it that holds all lines of sight
  double air_mass = 1.0;         ///< secant of the flattest to the vertical, at most 40
  bool misses_surfaces = false;  ///< some line of sight meets none
  /// Ground area across the line of sight that a pixel's light comes from at the least, m^2: at the
  /// nearest that the scene's bounds come to the camera. 0: nothing is known.
  double least_pixel_m2 = 0.0;
};
[[nodiscard]] ViewFacts view_facts(const geometry::Scene& scene, const sensor::Platform& platform,
                                   const sensor::DetectorArray& array);

/// Greatest cosine of the angle between a line of sight and a direction.
[[nodiscard]] double greatest_cosine(const ViewFacts& view, Vec3 direction) noexcept;

/// How far the image moves during an exposure, pixels: 0 where nothing moves or the exposure is a
/// moment, infinity otherwise.
[[nodiscard]] double smear_pixels(const sensor::Platform& platform,
                                  const sensor::DetectorArray& array) noexcept;

}  // namespace nadir::sim
