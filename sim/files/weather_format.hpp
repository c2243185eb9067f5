#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "sim/files/weather_record.hpp"

namespace nadir::sim {

enum class WeatherLayout { csv, tmy3, epw, surfrad };

/// Which format a text is in, by its first lines.
/// @throws InputError naming the file where it is none of them
[[nodiscard]] WeatherLayout weather_layout_of(std::string_view text, const std::string& name);

/// Reads weather in the given layout, or the one its content shows.
/// @throws InputError as the formats' readers do
[[nodiscard]] WeatherRecord parse_weather(std::string_view text, const std::string& name,
                                          std::optional<WeatherLayout> layout);

}  // namespace nadir::sim
