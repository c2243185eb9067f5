#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "sensor/camera/view_table.hpp"

namespace nadir::sim {

/// Reads the text of a view table: lines of sight of pixels on a grid, as docs/formats.md, section
/// View tables, describes it.
/// @param name  of the file, for messages
/// @throws InputError with every mistake, each with line and column
[[nodiscard]] sensor::ViewTable parse_view_table(std::string_view text, const std::string& name);

/// Reads a file. @throws InputError if it cannot be read or has mistakes
[[nodiscard]] sensor::ViewTable read_view_table(const std::filesystem::path& file);

}  // namespace nadir::sim
