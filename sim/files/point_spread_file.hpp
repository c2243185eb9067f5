#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "sensor/optics/point_spread.hpp"

namespace nadir::sim {

/// Reads the text of a point spread table as docs/formats.md, section Point spread tables,
/// describes it.
/// @param name  of the file, for messages
/// @throws InputError with every mistake, each with line and column; weights that do not sum to 1
///         within 1e-3 are one
[[nodiscard]] sensor::TabulatedSpread parse_point_spread(std::string_view text,
                                                         const std::string& name);

/// Reads a file. @throws InputError if it cannot be read or has mistakes
[[nodiscard]] sensor::TabulatedSpread read_point_spread(const std::filesystem::path& file);

}  // namespace nadir::sim
