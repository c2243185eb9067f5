#pragma once

#include <filesystem>

#include "atmosphere/gases/band_tables.hpp"

namespace nadir::sim {

/// Reads the figures of the gases of the air: gas_sets.csv, gas_bands.txt, gas_continua.txt and
/// standard_profiles.csv of a folder (of the shipped library: library/atmosphere).
/// docs/air-gases.md describes the files.
/// @throws InputError with file and line for what is missing or malformed
[[nodiscard]] atmosphere::BandTables read_band_tables(const std::filesystem::path& folder);

}  // namespace nadir::sim
