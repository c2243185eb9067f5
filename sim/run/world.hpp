#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/diagnostics.hpp"
#include "radiometry/lit_scene.hpp"
#include "sim/plan/camera_plan.hpp"
#include "sim/plan/effect_plan.hpp"
#include "sim/run/input_files.hpp"
#include "sim/run/load_air.hpp"
#include "sim/run/render.hpp"
#include "sim/scenario/scenario.hpp"

namespace nadir::sim {

/// A scenario with everything that it names read and built, ready to be rendered once its air is
/// finished (air_stage).
struct World {
  std::filesystem::path file;  ///< of the scenario, for messages
  radiometry::SceneDescription scene;
  Camera camera;
  std::optional<AirTask> air{};  ///< what is still to be done for the scene's air
  std::shared_ptr<const thermal::HeatSolver> heat{};  ///< null where nothing is to be solved
  std::vector<bool> asks_for_heat{};  ///< by array: whether it needs the temperatures of surfaces
  geometry::LocalFrame frame{geometry::Geodetic{}};  ///< of the scene's axes
  std::vector<std::string> object_names{};           ///< by the number that hits carry
  SceneFacts facts{};                                ///< what effects were decided from
  EffectPlan effects{};                              ///< what is simulated
};

/// @param seed  of the rays by which the heat balance looks about
/// @throws InputError with the mistakes of all files that the scenario names
[[nodiscard]] World load_world(const Scenario& scenario, InputFiles& files,
                               Diagnostics& diagnostics, std::uint64_t seed = 1);

/// The lanes that the camera's arrays need in this world's air; air in layers has them only once it
/// is finished.
/// @throws InputError where a table of the air has no lanes for a band
[[nodiscard]] CameraPlan plan_camera(const World& world, const SamplingInput& sampling);

/// Checks that every spectrum serves the camera's bands, as a run would. The air is not computed.
/// @throws InputError
void check_spectra(const World& world, const SamplingInput& sampling, Diagnostics& diagnostics);

/// What a table of the air that is about to be computed will need.
struct AirDemand {
  std::size_t lanes = 0;
  double bytes = 0.0;
};
/// Checks that what is held of the images, and a table of the air beside it, fit into this
/// machine's memory.
/// @throws InputError
void check_memory(const Camera& camera, const AirDemand& air = {});

}  // namespace nadir::sim
