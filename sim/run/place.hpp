#pragma once

#include "core/transform.hpp"
#include "sim/run/terrain_probe.hpp"
#include "sim/scenario/placement_input.hpp"

namespace nadir::sim {

/// The way from an object's axes to scene axes.
/// @throws InputError where it stands on the terrain and there is none below
[[nodiscard]] Affine placed(const PlacementInput& input, const TerrainProbe& terrain);

}  // namespace nadir::sim
