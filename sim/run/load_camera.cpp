#include "sim/run/load_camera.hpp"

#include "sim/run/error_list.hpp"
#include "sim/run/load_camera_arrays.hpp"
#include "sim/run/load_platform.hpp"
#include "sim/scenario/sensor_file.hpp"

namespace nadir::sim {

Camera load_camera(const Scenario& scenario, const geometry::LocalFrame& frame,
                   const TerrainProbe& terrain, InputFiles& files) {
  const CameraInput& input = scenario.camera;
  if (input.sensor_file) files.note(*input.sensor_file);
  ErrorList errors;
  CameraArrays loaded = load_arrays(input, files, errors);
  Camera camera;
  errors.attempt("camera", scenario.file.string(), [&] {
    const sensor::TimeSpan span =
        loaded.arrays.empty() ? sensor::TimeSpan{} : span_of(loaded.arrays);
    camera.platform = load_platform(scenario, frame, terrain, files, span);
  });
  errors.throw_if_any();
  camera.arrays = std::move(loaded.arrays);
  camera.electronics = std::move(loaded.electronics);
  const std::string& own_name = scenario.platform.name;
  camera.platform_name = own_name.empty() ? input.platform_name : own_name;
  camera.instrument_name = input.name;
  return camera;
}

SensorSheetInput load_sensor_file(const std::filesystem::path& file, InputFiles& files,
                                  Diagnostics& diagnostics) {
  const SensorInput input = read_sensor_file(files.note(file));
  ErrorList errors;
  CameraArrays loaded = load_arrays(input.camera, files, errors);
  errors.throw_if_any();
  constexpr double from_north = 0.0, straight_down_deg = -90.0;
  const sensor::Pose pose =
      sensor::from_euler({0.0, 0.0, input.nominal_height_m}, Mat3{}, degrees(from_north),
                         degrees(straight_down_deg), degrees(0.0));
  if (input.source.empty()) {
    diagnostics.warn(file.string() + ": the sensor file does not say where its figures come from");
  }
  return {Camera{sensor::Platform{pose}, std::move(loaded.arrays), std::move(loaded.electronics),
                 input.camera.platform_name, input.name},
          input.title, input.source, input.nominal_height_m, input.ground_speed_m_s};
}

}  // namespace nadir::sim
