#pragma once

#include "core/quantity.hpp"
#include "core/transform.hpp"
#include "core/vec.hpp"
#include "ephemeris/instant.hpp"

namespace nadir::sensor {

/// Position and velocity; which axes and units, the function says.
struct StateVector {
  Vec3 position, velocity;
};

/// Earth's rate of turning, rad/s. Source: Vallado, "Fundamentals of Astrodynamics" (2013), 3.7.
inline constexpr double earth_rate_rad_s = 7.29211514670698e-5;

/// Greenwich mean sidereal time (IAU 1982), in [0, 2 pi).
///
///     67310.54841 s + (876600 h + 8640184.812866 s) T + 0.093104 s T^2 - 6.2e-6 s T^3
///
/// T: Julian centuries of UT1 from J2000. Source: Aoki et al., Astron. Astrophys. 105, 359 (1982).
/// Accuracy: 1e-12 rad against ERFA's eraGmst82 (a test).
[[nodiscard]] Angle mean_sidereal_time(ephemeris::Ut1Date ut1) noexcept;

/// From the true equator and mean equinox of date (TEME, what SGP4 gives) to the earth-fixed axes
/// (ECEF; polar motion, at most 10 m, left out): a turn by Greenwich mean sidereal time (IAU 1982).
/// The velocity becomes the one over the turning earth. Units are kept, of lengths whichever and of
/// times seconds.
/// Source: Vallado et al., AIAA 2006-6753, appendix C.
[[nodiscard]] StateVector ecef_from_teme(const StateVector& teme, const ephemeris::Instant& time);
[[nodiscard]] StateVector teme_from_ecef(const StateVector& ecef, const ephemeris::Instant& time);

/// From the axes of the sky, GCRF (and ICRF: they are parallel), to the earth-fixed ones.
///
///     R3(era) C(x, y, s): precession and nutation IAU 2006/2000A, earth rotation angle; polar
///     motion left out
///
/// The axis' own motion in the sky, 8e-12 rad/s, is left out of the velocity: 0.06 mm/s at 7000 km.
/// Accuracy: 1e-13 rad against ERFA's eraC2t06a (a test).
/// Source: IERS Conventions (2010), sections 5.4.4 and 5.4.5.
[[nodiscard]] StateVector ecef_from_gcrf(const StateVector& gcrf, const ephemeris::Instant& time);
/// The same from the mean equator and equinox of J2000 (EME2000), 0.02 arcsec from GCRF.
[[nodiscard]] StateVector ecef_from_eme2000(const StateVector& eme2000,
                                            const ephemeris::Instant& time);

}  // namespace nadir::sensor
