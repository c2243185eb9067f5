#pragma once

#include "core/diagnostics.hpp"
#include "ephemeris/illumination.hpp"
#include "sim/run/input_files.hpp"
#include "sim/scenario/scenario.hpp"

namespace nadir::sim {

/// Sun and moon as the scenario's ephemeris or its fixed angles place them.
///
/// An ephemeris that gives no irradiance has the library's sun and the moon of the ROLO model. Only
/// what can light the scene is read: no file for a body more than 18 degrees below the horizon (the
/// site's own dip added), and no modelled moon while a sun that is not dark stands higher than
/// 5 degrees, where the moon adds less than 1e-4. Eclipses darken the sun and the modelled moon.
/// @param diagnostics  hears of an eclipse, and by night of a moon outside the model's phases or
///                     wavelengths
[[nodiscard]] ephemeris::Illumination load_illumination(const Scenario& scenario, InputFiles& files,
                                                        Diagnostics& diagnostics);

}  // namespace nadir::sim
