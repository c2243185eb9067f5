#include "sim/products/csm_isd.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/error.hpp"
#include "sim/files/atomic_file.hpp"
#include "sim/products/ground_points.hpp"
#include "sim/products/pose_table.hpp"
#include "sim/products/product_checks.hpp"

namespace nadir::sim {
namespace {

using Json = nlohmann::ordered_json;

constexpr double mm_per_m = 1e3, km_per_m = 1e-3;
constexpr double astronomical_unit_km = 149597870.7;  // IAU 2012
constexpr int inertial_frame = 1;                     // NAIF's number of J2000
constexpr int camera_frame = -999001;                 // of no mission
constexpr int earth_frame = 10013;                    // NAIF's number of IAU_EARTH

Json json_of(Vec3 v) { return {v.x, v.y, v.z}; }

/// Why the model cannot say what an array does, or nothing.
std::string hindrance(const sensor::DetectorArray& array, const sensor::Platform& platform) {
  if (std::holds_alternative<sensor::Orthographic>(array.projection)) {
    return "its lines of sight are parallel";
  }
  if (!std::holds_alternative<sensor::Perspective>(array.projection)) {
    return "its lines of sight come from a table";
  }
  if (std::holds_alternative<sensor::Whiskbroom>(array.timing.scan)) return "it is a whiskbroom";
  if (std::holds_alternative<sensor::RollingShutter>(array.timing.scan) && !platform.is_fixed()) {
    return "its rolling shutter moves";
  }
  return {};
}

/// A part of the image that one model can say: all of it, or what a module shows. A module that is
/// not turned is an array of its own offset from the axis; samples count in the whole array.
struct Part {
  sensor::DetectorArray array;
  int first_sample = 0, samples = 0;
  std::string name;  ///< in file names and identifiers
};

Part part_of(const sensor::DetectorArray& array, std::size_t module) {
  Part part{array, 0, array.samples, {}};
  if (array.modules.empty()) return part;
  const sensor::Module& cut = array.modules.at(module);
  part.array.modules.clear();
  part.array.offset_x_m += cut.offset_x_m;
  part.array.offset_y_m += cut.offset_y_m;
  part.first_sample = cut.first_sample;
  part.samples = cut.samples;
  part.name = fmt::format("_module{}", module + 1);
  return part;
}

std::size_t part_count(const sensor::DetectorArray& array) {
  return std::max<std::size_t>(array.modules.size(), 1);
}

bool is_turned(const sensor::DetectorArray& array, std::size_t module) {
  return !array.modules.empty() && array.modules.at(module).rotation_rad != 0.0;
}

/// Seconds of terrestrial time since J2000: ephemeris time but for its yearly 2 ms.
double ephemeris_seconds(const ephemeris::Instant& time) {
  const ephemeris::TtDate date = time.tt();
  return (date.day - 2451545.0) * 86400.0 + date.fraction * 86400.0;
}

/// The times of one ISD: those after the scenario's, and their like in ephemeris time.
struct Clock {
  double middle_s = 0.0, middle_et = 0.0;
  [[nodiscard]] double et(double time_s) const { return middle_et + (time_s - middle_s); }
};

/// The middle is moved to a whole number of 1/1024 s of ephemeris time, so that table times, by
/// steps of a power of two from it, are exact although they count 1e9 s.
Clock clock_about(const ephemeris::Instant& scenario_time, double middle_s) {
  const double zero_et = ephemeris_seconds(scenario_time);
  const double middle_et = std::round((zero_et + middle_s) * 1024.0) / 1024.0;
  return {middle_et - zero_et, middle_et};
}

void add_table_ends(Json& json, const char* prefix, const std::vector<double>& times) {
  const std::string name{prefix};
  json[name + "_table_start_time"] = times.front();
  json[name + "_table_end_time"] = times.back();
  json[name + "_table_original_size"] = times.size();
}

std::vector<double> times_of(const PoseTable& table, const Clock& clock) {
  std::vector<double> times;
  for (std::size_t i = 0; i < table.positions_m.size(); ++i) {
    times.push_back(clock.et(table.first_s + table.step_s * static_cast<double>(i)));
  }
  return times;
}

Json position_json(const PoseTable& table, const std::vector<double>& times) {
  Json json, positions, velocities;
  for (const Vec3& p : table.positions_m) positions.push_back(json_of(p * km_per_m));
  for (const Vec3& v : table.velocities_m_s) velocities.push_back(json_of(v * km_per_m));
  add_table_ends(json, "spk", times);
  json["ephemeris_times"] = times;
  json["positions"] = positions;
  json["velocities"] = velocities;
  json["reference_frame"] = inertial_frame;
  return json;
}

/// Quaternions, scalar first, that turn the reference's components of a vector into the camera's.
Json pointing_json(const PoseTable& table, const std::vector<double>& times) {
  Json json, quaternions, rates;
  for (const Quaternion& camera_to_earth : table.camera_to_earth) {
    const Quaternion q = conjugate(camera_to_earth);
    quaternions.push_back({q.w, q.x, q.y, q.z});
  }
  for (const Vec3& rate : table.angular_velocities_rad_s) rates.push_back(json_of(rate));
  json["time_dependent_frames"] = {camera_frame, inertial_frame};
  add_table_ends(json, "ck", times);
  json["ephemeris_times"] = times;
  json["quaternions"] = quaternions;
  json["angular_velocities"] = rates;
  json["reference_frame"] = inertial_frame;
  json["constant_frames"] = {camera_frame, camera_frame};
  json["constant_rotation"] = {1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0};
  return json;
}

/// The reference turns with the earth already.
Json no_rotation_json(const std::vector<double>& times) {
  std::vector<double> ends{times.front()};
  if (times.size() > 1) ends.push_back(times.back());
  Json json, quaternions, rates;
  for (std::size_t i = 0; i < ends.size(); ++i) {
    quaternions.push_back({1.0, 0.0, 0.0, 0.0});
    rates.push_back({0.0, 0.0, 0.0});
  }
  json["time_dependent_frames"] = {earth_frame, inertial_frame};
  add_table_ends(json, "ck", ends);
  json["ephemeris_times"] = ends;
  json["quaternions"] = quaternions;
  json["angular_velocities"] = rates;
  json["reference_frame"] = inertial_frame;
  return json;
}

Json sun_json(const ProductGeometry& geometry, const Clock& clock) {
  Vec3 direction{0.0, 0.0, 1.0};  // over the scene, where it has no sun
  for (const ephemeris::LightSource& body : geometry.bodies) {
    if (body.name == "sun") direction = body.direction_enu;
  }
  const Vec3 sun = scene_axes_ecef(geometry.frame) * direction * astronomical_unit_km;
  Json json;
  add_table_ends(json, "spk", {clock.middle_et});
  json["ephemeris_times"] = {clock.middle_et};
  json["positions"] = Json::array({json_of(sun)});
  json["velocities"] = Json::array({json_of(Vec3{})});
  json["reference_frame"] = inertial_frame;
  return json;
}

/// What both models have: the camera's inside.
void add_interior(Json& json, const Part& part, const BandFigures& band) {
  const sensor::DetectorArray& array = part.array;
  const auto& lens = std::get<sensor::Perspective>(array.projection);
  const double width_mm = array.pitch_m * mm_per_m, height_mm = array.height_m() * mm_per_m;
  const bool broom = std::holds_alternative<sensor::Pushbroom>(array.timing.scan);
  json["detector_sample_summing"] = 1;
  json["detector_line_summing"] = 1;
  json["focal_length_model"] = {{"focal_length", lens.focal_length_m * mm_per_m}};
  // The line scanner evaluates the detector's line at 0: the offset alone puts it off the axis.
  json["detector_center"] = {
      {"line", (broom ? 0.0 : 0.5 * array.lines) - array.offset_y_m / array.height_m()},
      {"sample", 0.5 * array.samples - array.offset_x_m / array.pitch_m}};
  json["focal2pixel_lines"] = {0.0, 0.0, 1.0 / height_mm};
  json["focal2pixel_samples"] = {0.0, 1.0 / width_mm, 0.0};
  const sensor::Distortion& d = lens.distortion;
  json["optical_distortion"]["radtan"]["coefficients"] = {d.k1, d.k2, d.p1, d.p2, d.k3};
  json["starting_detector_line"] = 0;
  json["starting_detector_sample"] = part.first_sample;
  json["naif_keywords"] = Json::object();
  json["band_name"] = band.name;
  json["band_center_um"] = band.centre_um;
  json["band_fwhm_um"] = band.fwhm_um;
}

void add_heading(Json& json, const GeoTask& task, const Part& part, const BandFigures& band) {
  const Camera& camera = *task.geometry->camera;
  const auto named = [](const std::string& name, const char* otherwise) {
    return name.empty() ? std::string{otherwise} : name;
  };
  json["isis_camera_version"] = 1;
  json["image_identifier"] =
      fmt::format("{}_{}_{}{}", task.context->scenario_name, part.array.name, band.name, part.name);
  json["image_lines"] = part.array.lines;
  json["image_samples"] = part.samples;
  json["name_platform"] = named(camera.platform_name, "nadir platform");
  json["name_sensor"] = named(camera.instrument_name, "nadir camera");
  const double height_m = task.geometry->mean_height_m;
  json["reference_height"] = {
      {"maxheight", height_m + 1000.0}, {"minheight", height_m - 1000.0}, {"unit", "m"}};
  json["radii"] = {{"semimajor", 6378.137}, {"semiminor", 6356.752314245}, {"unit", "km"}};
}

/// Size of a pixel in the middle of the image, as an angle and on the ground.
PoseSpan span_of(const GeoTask& task, double first_s, double last_s) {
  const auto& lens = std::get<sensor::Perspective>(task.array->projection);
  PoseSpan span{first_s, last_s};
  span.pixel_rad = std::min(task.array->pitch_m, task.array->height_m()) / lens.focal_length_m;
  const auto middle =
      ground_at(*task.geometry, *task.array, {0.5 * task.array->samples, 0.5 * task.array->lines});
  const auto view = sensor::image_view(*task.array, task.geometry->camera->platform,
                                       {0.5 * task.array->samples, 0.5 * task.array->lines});
  span.pixel_m = middle ? span.pixel_rad * length(middle->place - view.ray.origin) : 1.0;
  return span;
}

struct Poses {
  PoseTable table;
  Clock clock;
};

Poses add_frame_times(Json& json, const GeoTask& task) {
  const auto* shutter = std::get_if<sensor::GlobalShutter>(&task.array->timing.scan);
  const double middle_s = shutter != nullptr
                              ? shutter->centre_s
                              : sensor::image_time_s(*task.array, {0.0, 0.5 * task.array->lines});
  const Clock clock{middle_s, ephemeris_seconds(task.geometry->time) + middle_s};
  json["name_model"] = "USGS_ASTRO_FRAME_SENSOR_MODEL";
  json["center_ephemeris_time"] = clock.middle_et;
  return {single_pose(*task.geometry, middle_s), clock};
}

Poses add_line_times(Json& json, const GeoTask& task, const sensor::Pushbroom& broom) {
  const double half_s = 0.5 * broom.line_period_s;
  PoseSpan span = span_of(task, broom.first_line_s - half_s,
                          broom.first_line_s + task.array->lines * broom.line_period_s - half_s);
  const Clock clock = clock_about(task.geometry->time, 0.5 * (span.first_s + span.last_s));
  span.middle_s = clock.middle_s;
  json["name_model"] = "USGS_ASTRO_LINE_SCANNER_SENSOR_MODEL";
  json["interpolation_method"] = "lagrange";
  // A line's coordinate, its time less the centre's, and the time from line to line.
  json["line_scan_rate"] =
      Json::array({{0.5, broom.first_line_s - clock.middle_s, broom.line_period_s}});
  json["starting_ephemeris_time"] = clock.et(span.first_s);
  json["center_ephemeris_time"] = clock.middle_et;
  return {pose_table(*task.geometry, span), clock};
}

struct Isd {
  Json json;
  double error_px = 0.0;
};

Isd isd_of(const GeoTask& whole, std::size_t band, std::size_t module) {
  const std::string reason = hindrance(*whole.array, whole.geometry->camera->platform);
  if (!reason.empty()) throw InputError{"no CSM image support data: " + reason};
  if (is_turned(*whole.array, module)) {
    throw InputError{"no CSM image support data: the module is turned"};
  }
  const Part part = part_of(*whole.array, module);
  GeoTask task = whole;
  task.array = &part.array;
  const BandFigures figures = band_figures(part.array).at(band);
  Isd isd;
  add_heading(isd.json, task, part, figures);
  const auto* broom = std::get_if<sensor::Pushbroom>(&task.array->timing.scan);
  const Poses poses =
      broom != nullptr ? add_line_times(isd.json, task, *broom) : add_frame_times(isd.json, task);
  isd.error_px = poses.table.error_px;
  const std::vector<double> times = times_of(poses.table, poses.clock);
  isd.json["body_rotation"] = no_rotation_json(times);
  isd.json["instrument_pointing"] = pointing_json(poses.table, times);
  add_interior(isd.json, part, figures);
  isd.json["instrument_position"] = position_json(poses.table, times);
  isd.json["sun_position"] = sun_json(*task.geometry, poses.clock);
  return isd;
}

std::string text_of(const Isd& isd) { return isd.json.dump(2) + "\n"; }

}  // namespace

std::string csm_isd(const GeoTask& task, std::size_t band, std::size_t module) {
  return text_of(isd_of(task, band, module));
}

std::vector<ProductFile> write_csm_isds(const GeoTask& task) {
  const std::string reason = hindrance(*task.array, task.geometry->camera->platform);
  if (!reason.empty()) {
    task.warn("no CSM image support data: " + reason);
    return {};
  }
  std::vector<ProductFile> written;
  double error_px = 0.0;
  for (std::size_t module = 0; module < part_count(*task.array); ++module) {
    if (is_turned(*task.array, module)) {
      task.warn(fmt::format("no CSM image support data: its module {} is turned", module + 1));
      continue;
    }
    const std::string part = part_of(*task.array, module).name;
    for (std::size_t band = 0; band < task.array->bands.size(); ++band) {
      const std::string name = product_file_name(task.array->bands[band].name);
      const auto file = task.with("_" + name + part + "_isd.json");
      const Isd isd = isd_of(task, band, module);
      write_file(file, text_of(isd));
      written.push_back(task.record("CSM ISD", file));
      error_px = std::max(error_px, isd.error_px);
    }
  }
  if (error_px > 1e-3) {
    task.warn(fmt::format("its motion is too rough for the CSM's table of poses: {:.2g} pixels",
                          error_px));
  }
  return written;
}

}  // namespace nadir::sim
