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

/// How long before the scenario's moment its weather begins, or has its last hole that load_weather
/// does not bridge: more than three hours without a row, or without a value that is needed. 0 where
/// it does not reach the moment; infinity where it reaches all of `longest_s` back, as a clear sky
/// and a whole typical year do. load_weather covers every history up to this (a second of slack is
/// in it); what else is wrong with a file it tells itself.
/// @param longest_s  so far back is looked: of SURFRAD's daily files, no more are read
/// @throws InputError for a file that cannot be read
[[nodiscard]] double weather_reaches_back_s(const Scenario& scenario, InputFiles& files,
                                            double longest_s = 10.0 * 86400.0);

}  // namespace nadir::sim
