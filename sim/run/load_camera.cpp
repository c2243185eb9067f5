#include "sim/run/load_camera.hpp"

#include "sim/run/error_list.hpp"
#include "sim/run/read_curves.hpp"

namespace nadir::sim {
namespace {

constexpr double metres_per_um = 1e-6;
constexpr double metres_per_mm = 1e-3;

Vec3 place(const std::variant<geometry::Geodetic, Vec3>& position, bool on_terrain,
           const geometry::LocalFrame& frame, const TerrainProbe& terrain) {
  if (const auto* geodetic = std::get_if<geometry::Geodetic>(&position)) {
    return frame.enu(*geodetic);
  }
  const Vec3 local = std::get<Vec3>(position);
  return on_terrain ? terrain.lifted(local) : local;
}

sensor::Pose pose_of(const PlatformInput& platform, const geometry::LocalFrame& frame,
                     const TerrainProbe& terrain) {
  const Vec3 position = place(platform.position, platform.on_terrain, frame, terrain);
  // Angles and "up" are those of the axes in which the position is given.
  const auto* geodetic = std::get_if<geometry::Geodetic>(&platform.position);
  const Mat3 local = geodetic != nullptr ? frame.axes_at(*geodetic) : Mat3{};
  if (const auto* aim = std::get_if<PlatformInput::LookAt>(&platform.attitude)) {
    const Vec3 target = place(aim->target, aim->on_terrain, frame, terrain);
    return sensor::look_at(position, target, local, degrees(aim->roll_deg));
  }
  const auto& angles = std::get<PlatformInput::Euler>(platform.attitude);
  return sensor::from_euler(position, local, degrees(angles.yaw_deg), degrees(angles.pitch_deg),
                            degrees(angles.roll_deg));
}

spectral::Response response_of(const BoxBand& box, InputFiles& /*files*/) {
  return spectral::BoxResponse{Micrometres{box.lo_um}, Micrometres{box.hi_um}};
}
spectral::Response response_of(const GaussianBand& gaussian, InputFiles& /*files*/) {
  return spectral::GaussianResponse{Micrometres{gaussian.centre_um}, Micrometres{gaussian.fwhm_um}};
}
spectral::Response response_of(const TabulatedBand& table, InputFiles& files) {
  return spectral::TabulatedResponse{read_curve(
      files.note(table.file), table.column, SpectrumQuantity::response, spectral::Outside::zero)};
}

sensor::DetectorArray load_array(const ArrayInput& input, const CameraInput& camera,
                                 const std::string& scenario_file, InputFiles& files,
                                 ErrorList& errors) {
  sensor::DetectorArray array;
  array.name = input.name;
  array.samples = input.samples;
  array.lines = input.lines;
  if (camera.orthographic) {
    array.projection = sensor::Orthographic{};
    array.pitch_m = input.ground_pitch_m;
    array.offset_x_m = input.offset_x_m;
    array.offset_y_m = input.offset_y_m;
  } else {
    array.projection = sensor::Perspective{camera.focal_length_mm * metres_per_mm};
    array.pitch_m = input.pitch_um * metres_per_um;
    array.offset_x_m = input.offset_x_um * metres_per_um;
    array.offset_y_m = input.offset_y_um * metres_per_um;
  }
  for (const BandInput& band : input.bands) {
    errors.attempt("band " + band.name + " of array " + input.name, scenario_file, [&] {
      const auto response =
          std::visit([&](const auto& r) { return response_of(r, files); }, band.response);
      spectral::check(response);
      array.bands.push_back({band.name, response});
    });
  }
  return array;
}

}  // namespace

Camera load_camera(const Scenario& scenario, const geometry::LocalFrame& frame,
                   const TerrainProbe& terrain, InputFiles& files) {
  Camera camera;
  ErrorList errors;
  const std::string file = scenario.file.string();
  errors.attempt("camera", file, [&] { camera.pose = pose_of(scenario.platform, frame, terrain); });
  for (const ArrayInput& array : scenario.camera.arrays) {
    camera.arrays.push_back(load_array(array, scenario.camera, file, files, errors));
  }
  errors.throw_if_any();
  return camera;
}

}  // namespace nadir::sim
