#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "sensor/orbit/sgp4.hpp"

namespace nadir::sim {

/// Reads one satellite from a file of two-line element sets (docs/orbits.md). A set may have a line
/// with the satellite's name before it; blank lines and lines that start with # are passed over.
/// @param satellite  its name or catalogue number; empty: the file has just one
/// @throws InputError without a place, but with the file's name: a satellite that is not there.
///         With file, line and column: one that is there more than once, lines without their
///         partner, wrong checksums, fields that are no numbers or out of range, sets that are not
///         for SGP4
[[nodiscard]] sensor::TwoLineElements read_two_line_elements(const std::filesystem::path& file,
                                                             const std::string& satellite = {});
/// The same from text; `name` stands in messages.
[[nodiscard]] sensor::TwoLineElements parse_two_line_elements(std::string_view text,
                                                              const std::string& name,
                                                              const std::string& satellite = {});

}  // namespace nadir::sim
