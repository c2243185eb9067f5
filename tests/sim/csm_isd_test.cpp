#include "sim/products/csm_isd.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

#include "core/error.hpp"
#include "sim/geo_scene.hpp"
#include "sim/products/pose_table.hpp"
#include "sim/scratch_folder.hpp"
#include "support/catch.hpp"

using namespace nadir;
using namespace nadir::sim;
using Json = nlohmann::json;

namespace {

/// Lagrange's polynomial through eight of the even nodes about a place, one number of each.
double blended(const Json& rows, std::size_t component, double place) {
  const auto first = static_cast<std::size_t>(std::floor(place)) - 3;
  double sum = 0.0;
  for (std::size_t i = first; i < first + 8; ++i) {
    double weight = rows.at(i).at(component);
    for (std::size_t j = first; j < first + 8; ++j) {
      if (j != i) {
        weight *=
            (place - static_cast<double>(j)) / (static_cast<double>(i) - static_cast<double>(j));
      }
    }
    sum += weight;
  }
  return sum;
}

std::vector<double> at(const Json& table, const char* key, double et) {
  const Json& times = table.at("ephemeris_times");
  const Json& rows = table.at(key);
  std::vector<double> values;
  for (std::size_t c = 0; c < rows.at(0).size(); ++c) {
    if (rows.size() == 1) {
      values.push_back(rows.at(0).at(c));
      continue;
    }
    const double step = times.at(1).get<double>() - times.at(0).get<double>();
    values.push_back(blended(rows, c, (et - times.at(0).get<double>()) / step));
  }
  return values;
}

/// Line of sight in ECEF as the documented models have it, from the ISD alone (no distortion).
geometry::Ray ray_of(const Json& isd, double sample, double line) {
  const bool broom = isd.at("name_model") == "USGS_ASTRO_LINE_SCANNER_SENSOR_MODEL";
  double et = isd.at("center_ephemeris_time");
  if (broom) {
    const Json& rate = isd.at("line_scan_rate").at(0);
    et += rate.at(1).get<double>() + rate.at(2).get<double>() * (line - rate.at(0).get<double>());
  }
  const double detector_line = broom ? 0.0 : line;
  const Json& centre = isd.at("detector_center");
  const double x = (sample - centre.at("sample").get<double>()) /
                   isd.at("focal2pixel_samples").at(1).get<double>();
  const double y = (detector_line - centre.at("line").get<double>()) /
                   isd.at("focal2pixel_lines").at(2).get<double>();
  const double f = isd.at("focal_length_model").at("focal_length");
  const auto q = at(isd.at("instrument_pointing"), "quaternions", et);
  const auto p = at(isd.at("instrument_position"), "positions", et);
  const Mat3 to_sensor = to_matrix(unit(Quaternion{q[0], q[1], q[2], q[3]}));
  return {Vec3{p[0], p[1], p[2]} * 1000.0, normalised(to_sensor.transposed() * Vec3{x, y, f})};
}

/// The largest distance between the ISD's lines of sight and the camera's, in pixels.
double off_px(const support::GeoScene& scene) {
  const Json isd = Json::parse(csm_isd(scene.task(), 0));
  const Mat3 to_earth = scene_axes_ecef(scene.geometry.frame);
  const sensor::DetectorArray& array = scene.array();
  const double pixel_rad =
      array.pitch_m / std::get<sensor::Perspective>(array.projection).focal_length_m;
  double largest = 0.0;
  for (const auto& image : image_grid(array, {9, 9})) {
    const auto view = sensor::image_view(array, scene.camera.platform, image);
    const auto ray = ray_of(isd, image.sample, image.line);
    const Vec3 origin = scene.geometry.frame.ecef(view.ray.origin);
    const double range =
        length(ground_at(scene.geometry, array, image, 120.0)->place - view.ray.origin);
    const double angle = length(cross(to_earth * view.ray.direction, ray.direction));
    largest = std::max(largest, (angle + length(origin - ray.origin) / range) / pixel_rad);
  }
  return largest;
}

}  // namespace

TEST_CASE("the line scanner's ISD has the camera's lines of sight to a ten-thousandth of a pixel") {
  const auto scene = support::satellite();
  CHECK(off_px(*scene) < 1e-4);
  const Json isd = Json::parse(csm_isd(scene->task(), 0));
  CHECK(isd.at("name_model") == "USGS_ASTRO_LINE_SCANNER_SENSOR_MODEL");
  // The trap: the model looks at the detector's line 0, so that 40 rows ahead are -40.
  CHECK(isd.at("detector_center").at("line").get<double>() == Approx(-40.0).margin(1e-12));
  CHECK(isd.at("detector_center").at("sample").get<double>() == Approx(300.0).margin(1e-12));
  CHECK(isd.at("line_scan_rate").at(0).at(0) == 0.5);
  CHECK(isd.at("image_identifier") == "made_line_green");
  CHECK(isd.at("name_platform") == "made-1");
  CHECK(isd.at("radii").at("semimajor") == 6378.137);
  for (const char* key : {"body_rotation", "sun_position", "optical_distortion", "name_sensor",
                          "reference_height", "starting_ephemeris_time", "image_lines"}) {
    CHECK(isd.contains(key));
  }
}

TEST_CASE("the line scanner's tables go far enough beyond the image for eight points") {
  const auto scene = support::satellite();
  const Json isd = Json::parse(csm_isd(scene->task(), 0));
  const Json& times = isd.at("instrument_position").at("ephemeris_times");
  const double step = times.at(1).get<double>() - times.at(0).get<double>();
  const Json& rate = isd.at("line_scan_rate").at(0);
  const double start = isd.at("starting_ephemeris_time");
  CHECK(start - times.front().get<double>() >= 4.0 * step);
  const double end = start + 500 * rate.at(2).get<double>();
  CHECK(times.back().get<double>() - end >= 4.0 * step);
  // Times of 8e8 s are steps of a power of two apart: exact.
  for (std::size_t i = 1; i < times.size(); ++i) {
    CHECK(times.at(i).get<double>() - times.at(i - 1).get<double>() == step);
  }
}

TEST_CASE("the frame's ISD has the camera's lines of sight") {
  auto scene = support::drone();
  std::get<sensor::Perspective>(scene->camera.arrays[0].projection).distortion = {};
  // Rounding of ECEF places (1e-9 m) seen from 120 m, over 7e-4 rad, is 1e-8 px.
  CHECK(off_px(*scene) < 1e-6);
}

TEST_CASE("distortion goes into the ISD in OpenCV's order") {
  const auto scene = support::drone();
  const Json isd = Json::parse(csm_isd(scene->task(), 0));
  const Json wanted = {-0.1, 0.08, 5e-4, -3e-4, -0.02};
  CHECK(isd.at("optical_distortion").at("radtan").at("coefficients") == wanted);
}

TEST_CASE("cameras that the models cannot say get no ISD but a reason") {
  const auto map = support::orthographic(1.0, 0.0);
  CHECK(write_csm_isds(map->task()).empty());
  REQUIRE(map->diagnostics.messages().size() == 1);
  CHECK(map->diagnostics.messages()[0] ==
        "array map: no CSM image support data: its lines of sight are parallel");
}

TEST_CASE("every module of an array has an ISD of its own, but for those that are turned") {
  const support::ScratchFolder folder;
  const auto scene = support::satellite();
  scene->camera.arrays[0].modules = {
      {0, 250, 9e-6, 0.0, 0.0}, {250, 150, 0.0, 36e-6, 0.0}, {400, 200, 0.0, 0.0, 1e-3}};
  const GeoTask task = scene->task(folder / "line");
  const auto files = write_csm_isds(task);
  REQUIRE(files.size() == 2);
  CHECK(files[1].path.filename() == "line_green_module2_isd.json");
  REQUIRE(scene->diagnostics.messages().size() == 1);
  CHECK(scene->diagnostics.messages()[0] ==
        "array line: no CSM image support data: its module 3 is turned");
  CHECK_THROWS_AS(csm_isd(task, 0, 2), InputError);
  const Json first = Json::parse(csm_isd(task, 0, 0)), second = Json::parse(csm_isd(task, 0, 1));
  CHECK(first.at("image_samples") == 250);
  CHECK(first.at("starting_detector_sample") == 0);
  // Half a pixel to the right, and two rows further ahead than the array's forty.
  CHECK(first.at("detector_center").at("sample").get<double>() == Approx(299.5).margin(1e-9));
  CHECK(second.at("image_identifier") == "made_line_green_module2");
  CHECK(second.at("image_samples") == 150);
  CHECK(second.at("starting_detector_sample") == 250);
  CHECK(second.at("detector_center").at("line").get<double>() == Approx(-42.0).margin(1e-9));
}
