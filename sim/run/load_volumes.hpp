#pragma once

#include <vector>

#include "radiometry/volumes/volume.hpp"
#include "sim/run/input_files.hpp"
#include "sim/run/terrain_probe.hpp"
#include "sim/scenario/scenario.hpp"

namespace nadir::sim {

/// The scenario's volumes, their spectra, tables and grids read. A file that several volumes name
/// is read once.
/// @throws InputError with the mistakes of all files
[[nodiscard]] std::vector<radiometry::Volume> load_volumes(const Scenario& scenario,
                                                           const TerrainProbe& terrain,
                                                           InputFiles& files);

}  // namespace nadir::sim
