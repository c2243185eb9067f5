#pragma once

#include "atmosphere/atmosphere.hpp"
#include "core/diagnostics.hpp"
#include "ephemeris/illumination.hpp"
#include "sim/run/input_files.hpp"
#include "sim/scenario/scenario.hpp"

namespace nadir::sim {

/// Sun and moon as the scenario's ephemeris or its fixed angles place them.
[[nodiscard]] ephemeris::Illumination load_illumination(const Scenario& scenario,
                                                        InputFiles& files);

/// The scenario's air, its curves read.
[[nodiscard]] atmosphere::Atmosphere load_atmosphere(const Scenario& scenario, InputFiles& files);

/// Figures of air are given for one sun and do not darken when it sets: tells of a night whose sky
/// still shines in the visible.
void warn_of_bright_night(const Scenario& scenario, const ephemeris::Illumination& bodies,
                          const atmosphere::Atmosphere& air, Diagnostics& diagnostics);

}  // namespace nadir::sim
