#pragma once

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

/// From the true equator and mean equinox of date (TEME, what SGP4 gives) to the earth-fixed axes
/// (ECEF; polar motion, at most 10 m, left out): a turn by Greenwich mean sidereal time (IAU 1982).
/// The velocity becomes the one over the turning earth. Units are kept.
/// Source: Vallado et al., AIAA 2006-6753, appendix C.
[[nodiscard]] StateVector ecef_from_teme(const StateVector& teme, const ephemeris::Instant& time);
[[nodiscard]] StateVector teme_from_ecef(const StateVector& ecef, const ephemeris::Instant& time);

}  // namespace nadir::sensor
