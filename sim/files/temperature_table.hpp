#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/quantity.hpp"
#include "ephemeris/instant.hpp"

namespace nadir::sim {

/// A temperature over time; between its times it runs linearly.
struct TemperatureTable {
  std::string name;                      ///< of the file, for messages
  std::vector<ephemeris::Instant> time;  ///< ascending
  std::vector<double> kelvin;            ///< as many

  /// @throws InputError for a moment before the first or after the last time
  [[nodiscard]] Kelvin at(const ephemeris::Instant& moment) const;
};

/// A CSV with the columns utc (ISO 8601 with a trailing Z) and temperature_k or temperature_c;
/// lines that start with # and blank ones are passed over, other columns as well.
/// @param column  the one to read, its name ending in _k or _c; empty: temperature_k, or else
///                temperature_c
/// @throws InputError with every mistake of the text, each with line and column: temperatures
///         outside 0 to 6000 K, times that do not ascend
[[nodiscard]] TemperatureTable parse_temperature_table(std::string_view text,
                                                       const std::string& name,
                                                       const std::string& column = {});

/// Reads a file. @throws InputError as above, or if it cannot be read
[[nodiscard]] TemperatureTable read_temperature_table(const std::filesystem::path& file,
                                                      const std::string& column = {});

}  // namespace nadir::sim
