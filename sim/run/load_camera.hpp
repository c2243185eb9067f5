#pragma once

#include <filesystem>
#include <string>

#include "core/diagnostics.hpp"
#include "geometry/earth.hpp"
#include "sim/run/camera.hpp"
#include "sim/run/input_files.hpp"
#include "sim/run/terrain_probe.hpp"
#include "sim/scenario/scenario.hpp"

namespace nadir::sim {

/// The scenario's platform and camera, its responses, point spreads and view tables read.
/// @param terrain  where heights that count from the terrain come from; may be empty
/// @throws InputError with every mistake that was found
[[nodiscard]] Camera load_camera(const Scenario& scenario, const geometry::LocalFrame& frame,
                                 const TerrainProbe& terrain, InputFiles& files);

/// A sensor file by itself, as data sheets need it.
struct SensorSheetInput {
  /// Stands still at its nominal height over the origin and looks straight down, image top north.
  Camera camera;
  std::string title, source;
  double height_m = 0.0;
  double ground_speed_m_s = 0.0;  ///< of the nadir point, image down; 0: not known
};

/// @throws InputError with every mistake of the file and of those that it names
[[nodiscard]] SensorSheetInput load_sensor_file(const std::filesystem::path& file,
                                                InputFiles& files, Diagnostics& diagnostics);

}  // namespace nadir::sim
