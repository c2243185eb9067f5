#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace nadir::sim {

/// One-sided power spectral densities of the shaking about a camera's axes.
struct JitterFile {
  std::vector<double> frequencies_hz;      ///< > 0, ascending
  std::vector<double> density_rad2_hz[3];  ///< about x, y, z, one a frequency; empty: none
};

/// Reads a table of `frequency_hz` and one or more of `x_rad2_hz`, `y_rad2_hz`, `z_rad2_hz`; at
/// least two rows.
/// @throws InputError with every mistake of the file (20 in full), each with line and column
[[nodiscard]] JitterFile read_jitter_file(const std::filesystem::path& file);
/// The same from text; `name` stands in messages.
[[nodiscard]] JitterFile parse_jitter_file(std::string_view text, const std::string& name);

}  // namespace nadir::sim
