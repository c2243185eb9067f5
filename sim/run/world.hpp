#pragma once

#include <filesystem>

#include "core/diagnostics.hpp"
#include "radiometry/lit_scene.hpp"
#include "sim/run/input_files.hpp"
#include "sim/run/render.hpp"
#include "sim/scenario/scenario.hpp"

namespace nadir::sim {

/// A scenario with everything that it names read and built, ready to be rendered.
struct World {
  std::filesystem::path file;  ///< of the scenario, for messages
  radiometry::SceneDescription scene;
  Camera camera;
};

/// @throws InputError with the mistakes of all files that the scenario names
[[nodiscard]] World load_world(const Scenario& scenario, InputFiles& files,
                               Diagnostics& diagnostics);

/// Checks that every spectrum serves the camera's bands, as a run would.
/// @throws InputError
void check_spectra(const World& world, const SamplingInput& sampling, Diagnostics& diagnostics);

/// Checks that the images fit into this machine's memory.
/// @throws InputError
void check_memory(const World& world);

}  // namespace nadir::sim
