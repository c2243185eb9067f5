#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "sim/files/text_tokens.hpp"

// The head of a table of the air as lines, before anyone asks what they mean.

namespace nadir::sim {

inline const std::string air_table_magic = "nadir air table ";

/// A line "key = value".
struct AirTableEntry {
  std::string_view key;
  Token value;
};

/// The head's lines, without the first and that of its own checksum; what follows is the payload.
struct AirTableLines {
  std::vector<AirTableEntry> entries;
  std::string_view payload;
};

/// @throws InputError for another kind of file, another version, a head that was cut short or
///         changed after it was written
[[nodiscard]] AirTableLines air_table_lines(std::string_view bytes, const std::string& name);

}  // namespace nadir::sim
