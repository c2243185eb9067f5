#pragma once

#include <cstdint>
#include <vector>

#include "core/diagnostics.hpp"
#include "core/transform.hpp"
#include "geometry/scene_builder.hpp"
#include "radiometry/lamps/lamp.hpp"
#include "sim/run/input_files.hpp"
#include "sim/run/terrain_probe.hpp"
#include "sim/scenario/scenario.hpp"

namespace nadir::sim {

/// What an area lamp adds to the scene's geometry.
struct LampSurface {
  geometry::Surface surface;
  Affine placement;
  std::uint32_t object = 0;
};

struct LoadedLamps {
  std::vector<radiometry::Lamp> lamps;
  std::vector<LampSurface> surfaces;  ///< to be added to the scene under their object numbers
};

/// Reads the scenario's photometric files, spectra and lists of lamps and places the lamps. Lamps
/// of one file or one colour share what was read.
/// @param first_object  number of the first surface; each has one of its own, ascending
/// @throws InputError with the mistakes of all lamps
[[nodiscard]] LoadedLamps load_lamps(const Scenario& scenario, const TerrainProbe& terrain,
                                     std::uint32_t first_object, InputFiles& files);

/// Checks that no lamp is shut in by an opaque solid or buried in the terrain: from each, rays in
/// 14 directions; where all of them meet opaque surfaces from behind, the lamp is inside. Where at
/// least four do and none meets a front, it is buried if all of them met the terrain; otherwise a
/// warning tells.
/// @throws InputError at each such lamp, naming the object
void check_lamps(const geometry::Scene& scene, const Scenario& scenario,
                 const std::vector<radiometry::Lamp>& lamps, Diagnostics& diagnostics);

}  // namespace nadir::sim
