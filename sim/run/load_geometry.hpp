#pragma once

#include "geometry/earth.hpp"
#include "geometry/scene.hpp"
#include "sim/run/input_files.hpp"
#include "sim/run/terrain_probe.hpp"
#include "sim/scenario/scenario.hpp"

namespace nadir::sim {

struct LoadedGeometry {
  geometry::Scene scene;
  TerrainProbe terrain;
};

/// Reads the scenario's meshes, terrain and lists of instances and builds the scene from them.
/// Nested lists are flattened to one.
/// @throws InputError with the mistakes of all files
[[nodiscard]] LoadedGeometry load_geometry(const Scenario& scenario,
                                           const geometry::LocalFrame& frame, InputFiles& files);

}  // namespace nadir::sim
