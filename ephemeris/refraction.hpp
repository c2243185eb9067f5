#pragma once

#include "core/quantity.hpp"

namespace nadir::ephemeris {

/// The air at the observer, for refraction. The defaults are those of the formula's author.
struct AirAtSite {
  double pressure_hpa = 1010.0;
  double temperature_c = 10.0;
};

/// How much the air lifts a body that stands at a geometric elevation.
///
///     R = 1.02' / tan(h + 10.3 / (h + 5.11)) P / 1010 283 / (273 + T),  h in degrees
///
/// @param elevation  geometric, -pi/2 to pi/2
/// @return           radians, >= 0. Below -1 degree, where nothing of the sun shows over a level
///                   horizon, it falls linearly to 0 at -2 degrees.
///
/// Continuous; elevation + R rises with elevation everywhere. Accuracy: the author's, within 4
/// arcsec of a standard atmosphere above 0 degrees; the real air at the horizon varies by minutes.
/// Source: T. Saemundsson, Sky and Telescope 72, 70 (1986); Meeus, Astronomical Algorithms, 2nd
/// ed., eq. 16.4, with its constant that makes the zenith exactly 0.
[[nodiscard]] Angle refraction(Angle elevation, const AirAtSite& air = {}) noexcept;

}  // namespace nadir::ephemeris
