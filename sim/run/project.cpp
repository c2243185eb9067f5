#include "sim/run/project.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "sensor/camera/projection.hpp"
#include "sim/files/number_table.hpp"
#include "sim/products/ground_points.hpp"
#include "sim/run/epochs.hpp"
#include "sim/run/load_camera.hpp"
#include "sim/run/load_geometry.hpp"
#include "sim/scenario/read_scenario.hpp"

namespace nadir::sim {
namespace {

bool lies_inside(const sensor::DetectorArray& array, sensor::ImagePoint image) {
  return image.sample >= 0.0 && image.sample <= array.samples && image.line >= 0.0 &&
         image.line <= array.lines;
}

/// A surface before a place hides it if it is nearer by more than what surfaces are stored to.
bool is_hidden(const geometry::Scene& scene, const geometry::Ray& ray, Vec3 place) {
  const double distance = length(place - ray.origin);
  const auto hit = scene.intersect(ray);
  return hit && hit->distance < distance - std::max(0.01, 1e-6 * distance);
}

Projection place_in_image(const CameraScene& scene, const sensor::DetectorArray& array,
                          Vec3 place) {
  Projection found;
  found.place = place;
  found.geodetic = scene.frame.geodetic(place);
  found.image = sensor::image_of(array, scene.camera.platform, place);
  if (!found.image) return found;
  const auto view = sensor::image_view(array, scene.camera.platform, *found.image);
  found.time_s = view.time_s;
  found.ray = view.ray;
  found.inside = lies_inside(array, *found.image);
  found.hidden = is_hidden(scene.scene, view.ray, place);
  return found;
}

void check_near_image(const sensor::DetectorArray& array, sensor::ImagePoint image) {
  const auto near = [](double value, int size) {
    return std::isfinite(value) && value >= -0.1 * size && value <= 1.1 * size;
  };
  if (near(image.sample, array.samples) && near(image.line, array.lines)) return;
  throw InputError{
      fmt::format("sample {}, line {} lie outside the image of array {}, which has {} "
                  "samples and {} lines",
                  image.sample, image.line, array.name, array.samples, array.lines)};
}

void check_on_earth(const geometry::Geodetic& place) {
  if (!(std::abs(place.latitude_deg) <= 90.0)) {
    throw InputError{fmt::format("latitude {} lies outside -90 to 90 degrees", place.latitude_deg)};
  }
  if (!(std::abs(place.longitude_deg) <= 360.0)) {
    throw InputError{
        fmt::format("longitude {} lies outside -360 to 360 degrees", place.longitude_deg)};
  }
  if (!std::isfinite(place.height_m)) {
    throw InputError{fmt::format("height {} is no number of metres", place.height_m)};
  }
}

Projection image_on_ground(const CameraScene& scene, const sensor::DetectorArray& array,
                           const ImagePlace& asked) {
  check_near_image(array, asked.image);
  if (asked.height_m && !std::isfinite(*asked.height_m)) {
    throw InputError{fmt::format("height {} is no number of metres", *asked.height_m)};
  }
  const sensor::Platform& platform = scene.camera.platform;
  const double time_s = sensor::image_time_s(array, asked.image);
  const double slack_s = 1e-9;  // of times that are sums
  if (!platform.is_fixed() &&
      (time_s < platform.first_s() - slack_s || time_s > platform.last_s() + slack_s)) {
    throw InputError{fmt::format("line {}: the platform has no pose at its time, {} s",
                                 asked.image.line, time_s)};
  }
  const auto view = sensor::image_view(array, platform, asked.image);
  Projection found;
  found.image = asked.image;
  found.inside = lies_inside(array, asked.image);
  found.time_s = view.time_s;
  found.ray = view.ray;
  if (asked.height_m) {
    found.place = at_height(scene.frame, view.ray, *asked.height_m);
  } else if (const auto hit = scene.scene.intersect(view.ray)) {
    found.place = hit->position;
  }
  if (found.place) found.geodetic = scene.frame.geodetic(*found.place);
  return found;
}

std::string names_of(const Camera& camera) {
  std::string names;
  for (const sensor::DetectorArray& array : camera.arrays) {
    names += names.empty() ? "" : ", ";
    names += array.name + " (";
    for (const sensor::Band& band : array.bands) {
      names += (&band == array.bands.data() ? "" : ", ") + band.name;
    }
    names += ")";
  }
  return names;
}

bool has_band(const sensor::DetectorArray& array, const std::string& band) {
  return std::any_of(array.bands.begin(), array.bands.end(),
                     [&](const sensor::Band& one) { return one.name == band; });
}

}  // namespace

CameraScene load_camera_scene(const std::filesystem::path& file, Diagnostics& diagnostics) {
  InputFiles inputs;
  Scenario scenario = read_scenario(file, diagnostics);
  const geometry::LocalFrame frame{scenario.origin};
  LoadedGeometry geometry = load_geometry(scenario, frame, Epochs{scenario}, inputs);
  Camera camera = load_camera(scenario, frame, geometry.terrain, inputs);
  return {std::move(scenario), frame, std::move(geometry.scene), std::move(camera)};
}

const sensor::DetectorArray& find_array(const Camera& camera, const std::string& array,
                                        const std::string& band) {
  const auto fits = [&](const sensor::DetectorArray& one) {
    return (array.empty() || one.name == array) && (band.empty() || has_band(one, band));
  };
  const auto found = std::find_if(camera.arrays.begin(), camera.arrays.end(), fits);
  if (found == camera.arrays.end()) {
    throw InputError{"the camera has no such array or band; it has " + names_of(camera)};
  }
  if (std::find_if(found + 1, camera.arrays.end(), fits) != camera.arrays.end()) {
    throw InputError{"the camera has several arrays, name one with --array: " + names_of(camera)};
  }
  return *found;
}

Projection project(const CameraScene& scene, const sensor::DetectorArray& array,
                   const ProjectionPoint& point) {
  if (const auto* geodetic = std::get_if<geometry::Geodetic>(&point)) {
    check_on_earth(*geodetic);
    return place_in_image(scene, array, scene.frame.enu(*geodetic));
  }
  if (const auto* local = std::get_if<LocalPlace>(&point)) {
    return place_in_image(scene, array, local->enu);
  }
  return image_on_ground(scene, array, std::get<ImagePlace>(point));
}

std::vector<ProjectionPoint> read_projection_points(std::string_view text,
                                                    const std::string& name) {
  const NumberTable table{text,
                          name,
                          {{"latitude_deg", false, -90.0, 90.0},
                           {"longitude_deg", false, -360.0, 360.0},
                           {"height_m"},
                           {"east_m"},
                           {"north_m"},
                           {"up_m"},
                           {"sample"},
                           {"line"}}};
  const auto all = [&](std::initializer_list<const char*> columns) {
    return std::all_of(columns.begin(), columns.end(),
                       [&](const char* column) { return table.has(column); });
  };
  const bool geodetic = all({"latitude_deg", "longitude_deg", "height_m"});
  const bool local = all({"east_m", "north_m", "up_m"}), image = all({"sample", "line"});
  if (int{geodetic} + int{local} + int{image} != 1) {
    throw InputError{InputIssue{{name, table.header().line, 1},
                                "points are given by the columns latitude_deg, longitude_deg and "
                                "height_m, or by east_m, north_m and up_m, or by sample and line "
                                "with or without height_m",
                                std::string{},
                                std::string{table.header().line_text}}};
  }
  std::vector<ProjectionPoint> points;
  for (const NumberTable::Row& row : table.rows()) {
    const auto value = [&](const char* column) { return table.value(row, column, 0.0); };
    if (geodetic) {
      points.emplace_back(
          geometry::Geodetic{value("latitude_deg"), value("longitude_deg"), value("height_m")});
    } else if (local) {
      points.emplace_back(LocalPlace{{value("east_m"), value("north_m"), value("up_m")}});
    } else {
      ImagePlace place{{value("sample"), value("line")}};
      if (table.has("height_m")) place.height_m = value("height_m");
      points.emplace_back(place);
    }
  }
  return points;
}

}  // namespace nadir::sim
