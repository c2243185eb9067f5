#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "geometry/earth.hpp"
#include "geometry/scene.hpp"
#include "radiometry/lamps/lamp.hpp"
#include "sim/run/epochs.hpp"
#include "sim/run/input_files.hpp"
#include "sim/run/terrain_probe.hpp"
#include "sim/scenario/scenario.hpp"

namespace nadir::sim {

struct LoadedGeometry {
  geometry::Scene scene;
  TerrainProbe terrain;
  std::vector<radiometry::Lamp> lamps;  ///< area lamps are surfaces of the scene as well
  /// By material that takes its temperature from vertices: the hottest that any mesh gives, K.
  std::map<std::uint32_t, double> hottest_vertex_k{};
};

/// Reads the scenario's meshes, terrain, lists of instances and lamps and builds the scene from
/// them. Nested lists are flattened to one. Area lamps have object numbers of their own, after
/// those of the scenario's geometry.
/// @throws InputError with the mistakes of all files
[[nodiscard]] LoadedGeometry load_geometry(const Scenario& scenario,
                                           const geometry::LocalFrame& frame, const Epochs& epochs,
                                           InputFiles& files);

}  // namespace nadir::sim
