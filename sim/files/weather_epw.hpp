#pragma once

#include <string>
#include <string_view>

#include "sim/files/weather_record.hpp"

namespace nadir::sim {

/// Reads an EnergyPlus weather file: eight lines of header that begin with LOCATION and end with
/// DATA PERIODS, then 35 columns. Local standard time, hours 1 to 24 at their end; radiation is the
/// mean (Wh/m2) of the time before. Horizontal infrared radiation is the sky's long-wave; where it
/// is 0, as converters leave it that had none, it counts as missing.
/// Source: EnergyPlus Auxiliary Programs, "EPW data dictionary".
/// @throws InputError with every mistake, each with line and column
[[nodiscard]] WeatherRecord parse_weather_epw(std::string_view text, const std::string& name);

}  // namespace nadir::sim
