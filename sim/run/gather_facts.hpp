#pragma once

#include <optional>
#include <vector>

#include "atmosphere/atmosphere.hpp"
#include "materials/material.hpp"
#include "sim/plan/scene_facts.hpp"
#include "sim/run/camera.hpp"
#include "sim/run/load_air.hpp"
#include "sim/run/load_geometry.hpp"
#include "sim/scenario/scenario.hpp"

namespace nadir::sim {

/// What has been read by the time that effects are decided. The files of sun and moon, grids of
/// volumes, weather and temperatures are not among it, and the air is not solved.
struct FactsSources {
  const std::vector<materials::Material>& materials;
  const LoadedGeometry& geometry;
  const Camera& camera;
  const atmosphere::Atmosphere& air;  ///< as load_atmosphere gives it
  const std::optional<AirTask>& air_task;
};

/// What the planner has to know of a scenario; docs/effects.md says where each figure comes from.
/// Reads no file. Costs some milliseconds: the ephemeris, and 289 lines of sight an array.
[[nodiscard]] SceneFacts gather_facts(const Scenario& scenario, const FactsSources& sources);

}  // namespace nadir::sim
