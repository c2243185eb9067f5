#pragma once

#include "core/diagnostics.hpp"
#include "sim/run/input_files.hpp"
#include "sim/scenario/scenario.hpp"
#include "thermal/weather/weather.hpp"

namespace nadir::sim {

/// The weather of a file over the hours before the scenario's moment, checked against its site and
/// its sun; what the file lacks is derived (docs/weather.md). Of SURFRAD's daily files those of the
/// other days are read that lie beside the one that is named.
/// @param history_s  how long before the picture it must reach
/// @throws InputError as load_weather does
[[nodiscard]] thermal::Weather file_weather(const Scenario& scenario, const WeatherFileInput& input,
                                            double history_s, InputFiles& files,
                                            Diagnostics& diagnostics);

/// How far before the picture the file has weather, as weather_reaches_back_s tells it.
/// @param longest_s  infinity is returned where it has this
[[nodiscard]] double file_weather_reaches_back_s(const Scenario& scenario,
                                                 const WeatherFileInput& input, double longest_s,
                                                 InputFiles& files);

}  // namespace nadir::sim
