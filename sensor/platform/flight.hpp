#pragma once

#include <functional>

#include "geometry/earth.hpp"
#include "sensor/platform/track.hpp"

namespace nadir::sensor {

/// Flight along the geodesic that leaves a place at an azimuth, at constant speed over the
/// ellipsoid and constant climb.
struct StraightFlight {
  geometry::Geodetic start;  ///< at time 0
  double azimuth_deg = 0.0;  ///< at the start, clockwise from north
  double speed_m_s = 0.0;    ///< horizontal, along the ellipsoid at the flight's height, > 0
  double climb_m_s = 0.0;    ///< of the height
};
/// Round the vertical axis of a place, in the horizontal plane of that place at its height: a true
/// circle at constant speed. Height above the ellipsoid is radius^2 / (2 R) more than the centre's,
/// R the earth's radius of curvature: 0.08 m at 1 km, 2 m at 5 km.
struct CirclingFlight {
  geometry::Geodetic centre;  ///< its height is the flight's
  double radius_m = 0.0;      ///< > 0
  double speed_m_s = 0.0;     ///< > 0
  double azimuth_deg = 0.0;   ///< from the centre to the platform at time 0
  bool clockwise = true;      ///< seen from above
};

/// On the ellipsoid the flight has gone the integral of v R / (R + h(t)), R the radius of curvature
/// at the start in the direction of flight (Euler's formula). It leaves out how R changes on the
/// way: below (h / R) times 1 % of the distance, 2e-5 at 10 km.
/// @throws InputError for values that are not finite, speeds that are not positive
[[nodiscard]] geometry::Geodetic place_at(const StraightFlight& flight, double time_s);
/// @throws InputError likewise
[[nodiscard]] geometry::Geodetic place_at(const CirclingFlight& flight, double time_s);

/// The position law of anything that moves, ECEF, m.
using PositionLaw = std::function<Vec3(double time_s)>;

/// A law tabulated over a span with a margin of 8 steps beyond either end, at even steps halved
/// until the table agrees with the law at two places of every step.
/// @param tolerance_m  the default has room for moments that are kept to 1e-10 s: 0.8 micrometres
/// of
///                     an orbit
/// @throws InputError where 10^6 steps are not enough, or the span is none
[[nodiscard]] Track tabulated(const PositionLaw& law, const geometry::LocalFrame& frame,
                              double first_s, double last_s, double tolerance_m = 1e-5);

}  // namespace nadir::sensor
