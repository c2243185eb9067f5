#pragma once

#include <vector>

#include "core/diagnostics.hpp"
#include "geometry/earth.hpp"
#include "materials/maps/material_map.hpp"
#include "materials/material.hpp"
#include "radiometry/lit_scene.hpp"
#include "sim/run/input_files.hpp"
#include "sim/scenario/scenario.hpp"

namespace nadir::sim {

/// All maps of materials of a scenario, in its order.
/// @param materials  the scenario's, as loaded: contrast maps compare their reflectances
/// @param frame      of the scene
/// @throws InputError with the mistakes of all maps: values without a choice, fractions that do not
///         sum to 1, bands that are not there, rasters without a place
[[nodiscard]] std::vector<materials::MaterialMap> load_maps(
    const Scenario& scenario, const std::vector<materials::Material>& materials,
    const geometry::LocalFrame& frame, InputFiles& files, Diagnostics& diagnostics);

/// Warns of maps and reliefs that do not cover what they are draped over, and of those that follow
/// texture coordinates on surfaces that have none. Looks at the scene from above in about a
/// thousand places.
void check_cover(const Scenario& scenario, const radiometry::SceneDescription& scene,
                 Diagnostics& diagnostics);

}  // namespace nadir::sim
