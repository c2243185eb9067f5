#pragma once
// Private to this folder: from mean elements of a moment to position and velocity.

#include "sensor/orbit/earth_frames.hpp"
#include "sensor/orbit/sgp4_elements.hpp"

namespace nadir::sensor::sgp4 {

/// Long-period terms of J3, Kepler's equation, short-period terms of J2.
///
/// @param mean   at the moment, drag and third bodies in them; inclination in [0, pi]
/// @param terms  of the inclination that the terms of J2 and J3 are to have: of the epoch near the
///               earth, of the moment in deep space
/// @return       TEME, km and km/s
/// @throws PropagationError where the orbit has no semi-latus rectum or lies in the earth
/// Source: Hoots and Roehrich, Spacetrack Report 3 (1980), section 6, "Add the long-period periodic
/// terms" to its end.
[[nodiscard]] StateVector osculating_state(const Elements& mean, const InclinationTerms& terms);

}  // namespace nadir::sensor::sgp4
