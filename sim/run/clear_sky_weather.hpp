#pragma once

#include "core/diagnostics.hpp"
#include "sim/run/input_files.hpp"
#include "sim/scenario/scenario.hpp"
#include "thermal/weather/weather.hpp"

namespace nadir::sim {

/// Weather of a clear sky at the scenario's site, every ten minutes: the sun where the ephemeris
/// puts it, its light from the scenario's air, the air's own day as stated.
///
/// Air in layers: broadband fluxes of that air (atmosphere/broadband). Uniform air: its figures for
/// all heights of the sun, with a warning, and a long-wave sky that does not follow the air. A
/// table from elsewhere knows a few wavelengths only: the US standard atmosphere with rural haze
/// stands in, with a warning. No air: the sun as it is outside, and a cold sky. Eclipses are not
/// counted.
/// @param history_s  how long before the picture it must reach
/// @throws InputError  for a sun at fixed angles, and whatever the air's files or the day's figures
///                     are refused for; located
[[nodiscard]] thermal::Weather clear_sky_weather_of(const Scenario& scenario,
                                                    const ClearSkyInput& input, double history_s,
                                                    InputFiles& files, Diagnostics& diagnostics);

}  // namespace nadir::sim
