#pragma once

#include "sim/run/input_files.hpp"
#include "sim/run/render.hpp"
#include "sim/run/terrain_probe.hpp"

namespace nadir::sim {

/// The scenario's platform and camera, its responses read.
/// @param terrain  where heights that count from the terrain come from; may be empty
[[nodiscard]] Camera load_camera(const Scenario& scenario, const geometry::LocalFrame& frame,
                                 const TerrainProbe& terrain, InputFiles& files);

}  // namespace nadir::sim
