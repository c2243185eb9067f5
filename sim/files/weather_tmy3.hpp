#pragma once

#include <string>
#include <string_view>

#include "sim/files/weather_record.hpp"

namespace nadir::sim {

/// Reads a typical meteorological year in NREL's TMY3 layout: the station's line (id, name, state,
/// hours ahead of UTC, latitude, longitude, height; a leading # and what follows behind are passed
/// over), names of columns, one row an hour. Columns are found by their names, so that files with
/// some of them left out are read as well. Local standard time, 01:00 to 24:00 at the end of each
/// hour; radiation is the hour's mean.
/// Source: Wilcox & Marion, Users Manual for TMY3 Data Sets, NREL/TP-581-43156 (2008).
/// @throws InputError with every mistake, each with line and column
[[nodiscard]] WeatherRecord parse_weather_tmy3(std::string_view text, const std::string& name);

}  // namespace nadir::sim
