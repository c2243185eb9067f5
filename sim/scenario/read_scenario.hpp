#pragma once

#include <filesystem>

#include "core/diagnostics.hpp"
#include "sim/scenario/scenario.hpp"

namespace nadir::sim {

/// Reads and checks a scenario file.
/// @throws InputError that lists every mistake of the file with line and column
[[nodiscard]] Scenario read_scenario(const std::filesystem::path& file, Diagnostics& diagnostics);

}  // namespace nadir::sim
