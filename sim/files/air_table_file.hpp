#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "atmosphere/table/air_table.hpp"

// Tables of the air on disk (*.air): a head of text that says what is there, then the numbers.
// docs/air-table-format.md.

namespace nadir::sim {

/// What the file format is, and with it what a kept table means: a part of every cache key.
inline constexpr int air_table_version = 1;

struct AirTableFile {
  atmosphere::AirTable table;
  std::string inputs;  ///< SHA-256 of what it was computed from, or empty: see air_cache
};

/// @throws InputError with file and line: not such a file, another version, cut short, changed
///         (SHA-256 of head and numbers), sizes that do not agree, what check(AirTable) refuses
[[nodiscard]] AirTableFile read_air_table(const std::filesystem::path& file);

/// The same from bytes; `name` stands in messages.
[[nodiscard]] AirTableFile parse_air_table(std::string_view bytes, const std::string& name);

/// The bytes of a file. What is read back is the same to the last bit.
/// @throws InputError for what check(AirTable) refuses
[[nodiscard]] std::string air_table_bytes(const AirTableFile& file);

/// Whole or not at all.
void write_air_table(const std::filesystem::path& destination, const AirTableFile& file);

/// The head's text, for people.
[[nodiscard]] std::string air_table_head(const atmosphere::AirTable& table);

/// The table as text, one value a line: array, indices by the array's axes, value.
[[nodiscard]] std::string air_table_csv(const atmosphere::AirTable& table);

}  // namespace nadir::sim
