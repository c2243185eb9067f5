#pragma once

#include <functional>
#include <optional>

#include "ephemeris/illumination.hpp"
#include "ephemeris/instant.hpp"
#include "geometry/earth.hpp"
#include "sim/run/camera.hpp"

namespace nadir::sim {

/// What products need to place themselves on the earth.
struct ProductGeometry {
  const Camera* camera = nullptr;
  geometry::LocalFrame frame;
  ephemeris::Instant time;         ///< of the scenario: time 0
  ephemeris::Illumination bodies;  ///< sun and moon, for sun angles
  /// The first surface that a line of sight meets, scene axes; none: it meets the sky.
  std::function<std::optional<Vec3>(const geometry::Ray&)> surface;
  double mean_height_m = 0.0;  ///< of the scene's surfaces above the ellipsoid
};

}  // namespace nadir::sim
