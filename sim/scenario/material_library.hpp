#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "sim/scenario/issues.hpp"
#include "sim/scenario/scenario.hpp"

namespace nadir::sim {

/// A material of a library: what it lacks (temperature, solver settings) the scenario gives.
using LibraryMaterial = MaterialInput;

/// Reads and checks a material library; adds its mistakes, which name the library, to `issues`.
/// Nothing where the file cannot be taken apart at all.
[[nodiscard]] std::optional<std::vector<LibraryMaterial>> read_library(
    const std::filesystem::path& file, Issues& issues);

/// Reads and checks a material library.
/// @throws InputError that lists every mistake of the file with line and column
[[nodiscard]] std::vector<LibraryMaterial> read_material_library(const std::filesystem::path& file);

/// Surfaces reflect, transmit and emit at most everything: tells of numbers that sum to more.
/// @return the mistake, or empty
[[nodiscard]] std::string energy_mistake(const MaterialInput& material);

}  // namespace nadir::sim
