#pragma once

#include <filesystem>
#include <string>

#include "core/diagnostics.hpp"
#include "sim/scenario/scenario.hpp"

namespace nadir::sim {

/// Reads and checks a scenario file. What the user should know but what is no mistake (a material
/// that nothing is made of) goes to `diagnostics`.
/// @throws InputError that lists every mistake of the file with line and column
[[nodiscard]] Scenario read_scenario(const std::filesystem::path& file, Diagnostics& diagnostics);

/// The same for a text in memory; paths in it count from the folder of `file`, which need not
/// exist.
[[nodiscard]] Scenario parse_scenario(std::string text, const std::filesystem::path& file,
                                      Diagnostics& diagnostics);

/// Whether the file's root says that it is a material library rather than a scenario.
/// @throws InputError for a file that cannot be read or is not well-formed XML
[[nodiscard]] bool is_material_library(const std::filesystem::path& file);

}  // namespace nadir::sim
