#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "sim/files/weather_record.hpp"

namespace nadir::sim {

/// Reads a day of NOAA's SURFRAD network: the station's name, its latitude, longitude and height,
/// then a row every one or three minutes of UTC: date and time, and twenty values, each with a flag
/// of quality. A value counts where its flag is 0; -9999.9 is missing. Radiation is the mean of the
/// time between rows, given at its end.
/// Source: README of the SURFRAD daily files, NOAA GML; Augustine et al., Bull. Amer. Meteor. Soc.
/// 81, 2341 (2000).
/// @throws InputError with every mistake, each with line and column
[[nodiscard]] WeatherRecord parse_weather_surfrad(std::string_view text, const std::string& name);

/// The file of another day beside a file of this network (bon95099.dat: station, year, day of the
/// year). Nothing where the name is not of this kind or that day is its own.
/// @param day  since 1970-01-01
[[nodiscard]] std::optional<std::filesystem::path> surfrad_file_of_day(
    const std::filesystem::path& file, long day);

}  // namespace nadir::sim
