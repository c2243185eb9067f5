#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "core/diagnostics.hpp"
#include "ephemeris/illumination.hpp"
#include "geometry/scene.hpp"
#include "materials/maps/material_map.hpp"
#include "materials/material.hpp"
#include "sensor/camera/detector_array.hpp"
#include "sim/run/epochs.hpp"
#include "sim/run/input_files.hpp"
#include "sim/scenario/scenario.hpp"
#include "thermal/temperature.hpp"

namespace nadir::sim {

/// How warm what is solved may be expected to become: 400 K, or more where a scenario heats it
/// itself.
[[nodiscard]] Kelvin warmest_solved(const Scenario& scenario);
/// Whether any band sees a surface of that temperature emit (radiometry/emission_rule.hpp).
[[nodiscard]] bool sees_heat(const sensor::DetectorArray& array,
                             const ephemeris::Illumination& bodies, Kelvin warmest);

/// What temperatures are made from besides the scenario.
struct HeatScene {
  const geometry::Scene& geometry;
  const std::vector<materials::Material>& materials;
  const std::vector<materials::MaterialMap>& maps;
  const Epochs& epochs;
  const geometry::LocalFrame& frame;
  const std::map<std::uint32_t, double>& hottest_vertex_k;  ///< by material
};

struct LoadedTemperatures {
  thermal::TemperatureField field;
  std::shared_ptr<const thermal::HeatSolver> solver;  ///< null where nothing is to be solved
};

/// The source of every material's temperature. Where nobody asks for temperatures nothing is solved
/// and no weather read; what is stated, in rasters and tables too, is read: it may glow.
/// @param asked  whether some product needs temperatures that are solved, or the air's
/// @param seed   of the rays by which the heat balance looks about
/// @throws InputError
[[nodiscard]] LoadedTemperatures load_temperatures(const Scenario& scenario, const HeatScene& scene,
                                                   bool asked, std::uint64_t seed,
                                                   InputFiles& files, Diagnostics& diagnostics);

}  // namespace nadir::sim
