#pragma once

#include <vector>

#include "radiometry/effect.hpp"
#include "sim/run/camera.hpp"
#include "sim/scenario/scenario.hpp"

namespace nadir::sim {

/// Takes everything out of a scenario that only serves effects which no detector array has, so that
/// what loads it later opens no file for them: lamps, volumes, light of sun and moon (their places
/// stay), eclipses, the air, its light of the night, point spreads, jitter without memory, and
/// weather and layers of surfaces where they need not be solved: these then have the air's
/// temperature (air_temperature_k).
/// The air also stays where clear-sky weather is made from it for surfaces that are solved.
/// Refraction goes only where the scenario says off: where it moves the picture by less than 0.1
/// pixel, lines of sight are straight anyhow, but sun and moon are where they are seen.
/// @param any  what some array has
void drop_effects(Scenario& scenario, radiometry::EffectSet any);

/// Takes out of a loaded camera what single arrays do not have: point spread, motion during the
/// exposure (which the detector still counts), noise and fixed pattern of the numbers.
/// @param by_array  one set an array
void drop_effects(Camera& camera, const std::vector<radiometry::EffectSet>& by_array);

/// What a surface has that is not solved: the middle of the stated clear-sky day; otherwise the
/// air's temperature at the ground as its profile (AFGL's, by name) or uniform air has it;
/// otherwise 288.15 K. No file is read for it.
[[nodiscard]] double air_temperature_k(const Scenario& scenario);

}  // namespace nadir::sim
