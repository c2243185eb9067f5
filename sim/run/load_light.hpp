#pragma once

#include "atmosphere/atmosphere.hpp"
#include "core/diagnostics.hpp"
#include "ephemeris/illumination.hpp"
#include "sim/run/input_files.hpp"
#include "sim/scenario/scenario.hpp"

namespace nadir::sim {

/// Sun and moon as the scenario's ephemeris or its fixed angles place them.
[[nodiscard]] ephemeris::Illumination load_illumination(const Scenario& scenario, InputFiles& files,
                                                        Diagnostics& diagnostics);

/// The scenario's air, its curves read.
[[nodiscard]] atmosphere::Atmosphere load_atmosphere(const Scenario& scenario, InputFiles& files);

}  // namespace nadir::sim
