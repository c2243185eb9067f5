#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "atmosphere/table/air_table.hpp"
#include "sim/files/air_runs.hpp"
#include "sim/files/uvspec_output.hpp"

namespace nadir::sim {

enum class AirSource { tape7, modtran_csv, uvspec };

/// What to make a table of.
struct AirImport {
  AirSource from = AirSource::tape7;
  /// In the order that `geometry` and `azimuth_deg` follow. For uvspec its outputs: the input is
  /// the file beside with the ending .inp.
  std::vector<std::filesystem::path> files;
  std::filesystem::path geometry;   ///< a CSV table, a row a run; for MODTRAN's CSV required
  std::vector<double> azimuth_deg;  ///< from the sun: one for all runs, or one a run
  AirRunSettings settings;
  UvspecSettings uvspec;
};

/// A CSV table with the columns `height_m`, `zenith_deg` (both required; of the direction looked
/// in, at the eye), `azimuth_deg` (from the sun) and `length_m` (without it: to ground or space).
[[nodiscard]] std::vector<RunGeometry> read_run_geometry(const std::filesystem::path& file);

/// @throws InputError
[[nodiscard]] atmosphere::AirTable import_air(const AirImport& wanted);

}  // namespace nadir::sim
