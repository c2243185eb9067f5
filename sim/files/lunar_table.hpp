#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "ephemeris/lunar_reflectance.hpp"

namespace nadir::sim {

/// The bands of the moon's reflectance: a spectrum file of the quantity `parameter` with the
/// columns a0 to a3, b1 to b3, d1 to d3 and smoothing, each full. `path` only stands in messages.
/// @throws InputError with the mistakes of the file, or the first column that is missing or has
/// gaps
[[nodiscard]] ephemeris::LunarModel parse_lunar_model(std::string_view text,
                                                      const std::string& path);

/// Reads a file. @throws InputError as above, or if it cannot be opened
[[nodiscard]] ephemeris::LunarModel read_lunar_model(const std::filesystem::path& path);

}  // namespace nadir::sim
