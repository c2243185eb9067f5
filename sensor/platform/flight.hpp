#pragma once

#include <functional>
#include <vector>

#include "geometry/earth.hpp"
#include "sensor/platform/track.hpp"

namespace nadir::sensor {

/// Flight along the geodesic that leaves a place at an azimuth, at constant speed over the
/// ellipsoid and constant climb.
struct StraightFlight {
  geometry::Geodetic start;  ///< at time 0
  double azimuth_deg = 0.0;  ///< at the start, clockwise from north
  double speed_m_s = 0.0;    ///< along the ellipsoid at the flight's height, > 0
  double climb_m_s = 0.0;    ///< of the height
};
/// Round a vertical axis at constant height.
struct CirclingFlight {
  geometry::Geodetic centre;  ///< its height is the flight's
  double radius_m = 0.0;      ///< > 0
  double speed_m_s = 0.0;     ///< > 0
  double azimuth_deg = 0.0;   ///< from the centre to the platform at time 0
  bool clockwise = true;      ///< seen from above
};

[[nodiscard]] geometry::Geodetic place_at(const StraightFlight& flight, double time_s);
[[nodiscard]] geometry::Geodetic place_at(const CirclingFlight& flight, double time_s);

/// The position law of anything that moves, ECEF, m.
using PositionLaw = std::function<Vec3(double time_s)>;

/// A law tabulated over a span with some margin, so finely that the table is within `tolerance_m`
/// of the law.
[[nodiscard]] Track tabulated(const PositionLaw& law, const geometry::LocalFrame& frame,
                              double first_s, double last_s, double tolerance_m = 1e-6);

}  // namespace nadir::sensor
