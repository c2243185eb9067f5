#pragma once

#include "core/diagnostics.hpp"
#include "sim/run/input_files.hpp"
#include "sim/scenario/scenario.hpp"
#include "thermal/weather/weather.hpp"

namespace nadir::sim {

/// The weather at the scenario's site over the hours before its moment: from its file, or that of a
/// clear sky.
/// @param history_s  how long before the picture it must reach
/// @throws InputError for a file that cannot be read, does not cover those hours, has gaps there or
///         values that cannot be, was measured on the other hemisphere or is off by hours; located
///         in the file, or at the scenario's element
[[nodiscard]] thermal::Weather load_weather(const Scenario& scenario, double history_s,
                                            InputFiles& files, Diagnostics& diagnostics);

}  // namespace nadir::sim
