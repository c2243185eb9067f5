#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "core/diagnostics.hpp"
#include "ephemeris/illumination.hpp"
#include "geometry/scene.hpp"
#include "materials/maps/material_map.hpp"
#include "materials/material.hpp"
#include "sensor/detector_array.hpp"
#include "sim/run/epochs.hpp"
#include "sim/run/input_files.hpp"
#include "sim/scenario/scenario.hpp"
#include "thermal/temperature.hpp"

namespace nadir::sim {

/// Whether any band sees what surfaces emit that are as warm as the sun makes them
/// (radiometry/emission_rule.hpp).
[[nodiscard]] bool sees_heat(const sensor::DetectorArray& array,
                             const ephemeris::Illumination& bodies);

/// What temperatures are made from besides the scenario.
struct HeatScene {
  const geometry::Scene& geometry;
  const std::vector<materials::Material>& materials;
  const std::vector<materials::MaterialMap>& maps;
  const Epochs& epochs;
  const geometry::LocalFrame& frame;
};

struct LoadedTemperatures {
  thermal::TemperatureField field;
  std::shared_ptr<const thermal::HeatSolver> solver;  ///< null where nothing is to be solved
};

/// The source of every material's temperature. Where nobody asks for temperatures those that cost
/// anything are left out, and none of their files is opened.
/// @param asked  whether some product needs temperatures
/// @throws InputError
[[nodiscard]] LoadedTemperatures load_temperatures(const Scenario& scenario, const HeatScene& scene,
                                                   bool asked, InputFiles& files,
                                                   Diagnostics& diagnostics);

}  // namespace nadir::sim
