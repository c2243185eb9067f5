#pragma once

#include <string>
#include <string_view>

#include "sim/files/weather_record.hpp"

namespace nadir::sim {

/// Reads weather as a CSV whose header states units and time zone (docs/weather.md): the column
/// `utc`, or `local` with its offset; quantities with the unit in the column's name; the station's
/// place and how long radiation was averaged in lines `# key: value` above the header.
/// @throws InputError with every mistake, each with line and column: unknown columns, keys or
///         units, a quantity twice, times that do not ascend, values that no weather has
[[nodiscard]] WeatherRecord parse_weather_csv(std::string_view text, const std::string& name);

}  // namespace nadir::sim
