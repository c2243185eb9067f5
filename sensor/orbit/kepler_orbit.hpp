#pragma once

#include "sensor/orbit/earth_frames.hpp"

namespace nadir::sensor {

/// An orbit by its elements at an epoch, in axes of the true equator of date (TEME).
struct KeplerElements {
  ephemeris::Instant epoch;
  double semi_major_axis_m = 0.0;   ///< > earth's radius
  double eccentricity = 0.0;        ///< [0, 1)
  double inclination_deg = 0.0;     ///< [0, 180]
  double ascending_node_deg = 0.0;  ///< right ascension
  double argument_of_perigee_deg = 0.0;
  double mean_anomaly_deg = 0.0;
};

/// The ellipse, its node, perigee and mean anomaly drifting by the earth's oblateness (J2, secular
/// terms; Vallado 2013, eqs. 9-38 to 9-41).
/// @return ECEF, m and m/s over the turning earth
[[nodiscard]] StateVector orbit_state(const KeplerElements& elements,
                                      const ephemeris::Instant& time);

/// A circular orbit that passes over a place at a moment.
struct Overpass {
  double latitude_deg = 0.0, longitude_deg = 0.0;  ///< geodetic, below the satellite at `time`
  double height_m = 0.0;                           ///< above the ellipsoid there
  double inclination_deg = 0.0;
  bool ascending = false;  ///< northwards there
};
/// @throws InputError where the inclination does not reach the latitude
[[nodiscard]] KeplerElements circular_orbit(const Overpass& overpass,
                                            const ephemeris::Instant& time);

}  // namespace nadir::sensor
