#pragma once

#include "core/quantity.hpp"

namespace nadir::ephemeris {

/// The air at the observer, for refraction. The defaults are those of the standard atmosphere at
/// sea level.
struct AirAtSite {
  double pressure_hpa = 1013.25;
  double temperature_c = 15.0;
};

/// How much the air lifts a body that is seen at an apparent elevation: light of 0.55 um, dry air.
///
///     R = 1.00253 57.3164" cot(h + 4.2206 / (h + 15.1115 / (h + 5.9431))),      h in degrees,
///         times (P / 1013.25 hPa)^(1 + 0.095 e) (288.15 K / T)^(1 + e),
///         e = 1 / (1.47 + 0.55 h + 0.172 h^2)
///
/// The first line without its factor is the Pulkovo tables' (15 C, 1013.25 hPa, 0.59 um) to 0.3
/// arcsec from 0 to 90 degrees, as fitted at
/// hp41programs.yolasite.com/refraction.php; the factor is the ratio of the refractivities at 0.55
/// and 0.59 um (P. E. Ciddor, Appl. Opt. 35, 1566, 1996). The exponents, which the low sky needs,
/// are fitted to integrals along rays through a standard atmosphere (refraction_test.cpp holds the
/// integral): -30 to 40 C.
///
/// @param apparent_elevation  above -2 degrees
/// @return                    radians, >= 0; near the horizon formula and integral part, by 2 %
///                            there
[[nodiscard]] Angle refraction_at_apparent(Angle apparent_elevation,
                                           const AirAtSite& air = {}) noexcept;

/// How much the air lifts a body that stands at a geometric elevation: the R above that takes the
/// body to elevation + R.
///
/// @param elevation  geometric, -pi/2 to pi/2
/// @return           radians, >= 0. Below -1 degree, where nothing of the sun shows over a level
///                   horizon, it falls linearly to 0 at -2 degrees.
///
/// Continuous; elevation + R rises with elevation everywhere. Within 0.05 arcmin of tables down to
/// 5 degrees (docs/ephemeris.md); the real air at the horizon varies by minutes.
[[nodiscard]] Angle refraction(Angle elevation, const AirAtSite& air = {}) noexcept;

}  // namespace nadir::ephemeris
