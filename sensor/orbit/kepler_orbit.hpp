#pragma once

#include "sensor/orbit/earth_frames.hpp"

namespace nadir::sensor {

/// An orbit by its elements at an epoch, in axes of the true equator of date (TEME). They are mean
/// ones: without the periodic terms of J2 (docs/orbits.md says how large those are).
struct KeplerElements {
  ephemeris::Instant epoch;
  double semi_major_axis_m = 0.0;   ///< > earth's radius
  double eccentricity = 0.0;        ///< [0, 1)
  double inclination_deg = 0.0;     ///< [0, 180]
  double ascending_node_deg = 0.0;  ///< right ascension
  double argument_of_perigee_deg = 0.0;
  double mean_anomaly_deg = 0.0;
};

/// The elements themselves.
/// @throws InputError that names every element outside its range, or a perigee inside the earth
[[nodiscard]] KeplerElements checked(const KeplerElements& elements);

/// How an orbit drifts by the earth's oblateness, rad/s.
///
///     node     -3/2 k cos i              k = n J2 (R / p)^2,  p = a (1 - e^2)
///     perigee   3/4 k (4 - 5 sin^2 i)
///     anomaly   n + 3/4 k sqrt(1 - e^2) (2 - 3 sin^2 i),  n = sqrt(mu / a^3)
///
/// Source: Vallado (2013), eqs. 9-38, 9-39, 9-41; constants of WGS84 and EGM96.
struct SecularRates {
  double node = 0.0, perigee = 0.0, mean_anomaly = 0.0;
};
[[nodiscard]] SecularRates secular_rates(const KeplerElements& elements) noexcept;

/// The solution E of Kepler's equation M = E - e sin E, by Newton's rule from above, where it
/// cannot overshoot.
/// @param eccentricity  [0, 1)
/// Accuracy: 1e-14 rad or the rounding of E - e sin E, whichever is more.
[[nodiscard]] Angle eccentric_anomaly(Angle mean_anomaly, double eccentricity) noexcept;

/// The ellipse, its node, perigee and mean anomaly drifting by the earth's oblateness (J2, secular
/// terms).
/// @param elements  as `checked` allows
/// @return ECEF, m and m/s over the turning earth
[[nodiscard]] StateVector orbit_state(const KeplerElements& elements,
                                      const ephemeris::Instant& time);

/// A circular orbit that passes over a place at a moment.
struct Overpass {
  double latitude_deg = 0.0, longitude_deg = 0.0;  ///< geodetic, below the satellite at `time`
  double height_m = 0.0;                           ///< above the ellipsoid there, > 0
  double inclination_deg = 0.0;                    ///< [0, 180]
  bool ascending = false;                          ///< northwards there
};
/// The satellite stands on the place's normal to the ellipsoid at `time`, which is the epoch.
/// @throws InputError where a value is outside its range or the inclination does not reach the
///         satellite's geocentric latitude
[[nodiscard]] KeplerElements circular_orbit(const Overpass& overpass,
                                            const ephemeris::Instant& time);

}  // namespace nadir::sensor
