#pragma once

#include <cmath>
#include <filesystem>
#include <memory>

#include "core/diagnostics.hpp"
#include "sensor/camera/projection.hpp"
#include "sensor/orbit/kepler_orbit.hpp"
#include "sensor/platform/flight.hpp"
#include "sim/products/geo_task.hpp"
#include "sim/products/ground_points.hpp"

// Cameras over a real place of the earth, for the tests of what places images on it.

namespace nadir::sim::support {

inline const geometry::Geodetic& site() {
  static const geometry::Geodetic place{45.2, 11.4, 120.0};
  return place;
}

inline spectral::Response green() {
  return spectral::GaussianResponse{Micrometres{0.56}, Micrometres{0.03}};
}

/// A camera with its place on the earth and the writers' view of it.
struct GeoScene {
  Camera camera;
  ProductGeometry geometry;
  ProductContext context;
  Diagnostics diagnostics;

  explicit GeoScene(Camera made)
      : camera{std::move(made)},
        geometry{&camera,
                 geometry::LocalFrame{site()},
                 ephemeris::Instant::parse_utc("2024-06-21T10:12:13.25Z"),
                 {},
                 {},
                 120.0} {
    geometry.bodies = {
        {"sun", normalised(Vec3{0.3, -0.5, 0.8}), Angle{0.0047}, spectral::Curve::constant(1.0)}};
    context.scenario_name = "made";
    context.version = "0";
    context.diagnostics = &diagnostics;
    context.geometry = &geometry;
  }
  GeoScene(const GeoScene&) = delete;
  GeoScene& operator=(const GeoScene&) = delete;

  [[nodiscard]] const sensor::DetectorArray& array() const { return camera.arrays.front(); }
  [[nodiscard]] GeoTask task(const std::filesystem::path& stem = {}) const {
    return {&context, &geometry, &array(), 0, stem};
  }
};

inline sensor::DetectorArray perspective(int samples, int lines, double pitch_m,
                                         double focal_length_m) {
  sensor::DetectorArray array{"frame", samples, lines, sensor::Perspective{focal_length_m},
                              pitch_m, 0.0,     0.0,   {{"green", green()}}};
  return array;
}

/// A drone at 120 m over the site, tilted, with a lens that distorts; off the axis.
inline std::unique_ptr<GeoScene> drone() {
  const geometry::LocalFrame frame{site()};
  Camera camera;
  camera.platform = sensor::Platform{
      sensor::from_euler({15.0, -8.0, 120.0}, Mat3{}, degrees(30.0), degrees(-75.0), degrees(4.0))};
  sensor::DetectorArray array = perspective(1280, 960, 3.75e-6, 5.4e-3);
  array.projection = sensor::Perspective{5.4e-3, {-0.1, 0.08, 5e-4, -3e-4, -0.02}};
  array.offset_x_m = 40e-6;
  array.offset_y_m = -25e-6;
  camera.arrays = {array};
  return std::make_unique<GeoScene>(std::move(camera));
}

/// A line array on a circular orbit, rows ahead of the axis; some 15 m pixels from 705 km.
inline std::unique_ptr<GeoScene> satellite(int samples = 600, int lines = 500) {
  const geometry::LocalFrame frame{site()};
  const auto time = ephemeris::Instant::parse_utc("2024-06-21T10:12:13.25Z");
  sensor::Overpass over;
  over.latitude_deg = site().latitude_deg;
  over.longitude_deg = site().longitude_deg;
  over.height_m = 705e3;
  over.inclination_deg = 98.2;
  const sensor::KeplerElements orbit = sensor::circular_orbit(over, time);
  const auto law = [&](double s) { return sensor::orbit_state(orbit, time + Seconds{s}).position; };
  const double period_s = 2.2e-3;
  sensor::PlatformDescription way;
  way.track = sensor::tabulated(law, frame, -1.0, 1.0);
  sensor::TrackAttitude nadir;
  nadir.roll = degrees(3.0);
  way.attitude = nadir;
  Camera camera;
  camera.platform_name = "made-1";
  camera.platform = sensor::Platform{way, frame, -1.0, 1.0};
  sensor::DetectorArray array = perspective(samples, lines, 18e-6, 0.886);
  array.name = "line";
  array.offset_y_m = 40.0 * 18e-6;
  array.timing.scan = sensor::Pushbroom{-0.5 * (lines - 1) * period_s, period_s};
  camera.arrays = {array};
  return std::make_unique<GeoScene>(std::move(camera));
}

/// Parallel lines of sight straight down, turned against north.
inline std::unique_ptr<GeoScene> orthographic(double pixel_m, double yaw_deg) {
  Camera camera;
  camera.platform = sensor::Platform{sensor::from_euler(
      {30.0, 40.0, 500.0}, Mat3{}, degrees(yaw_deg), degrees(-90.0), degrees(0.0))};
  sensor::DetectorArray array{"map",   200, 150, sensor::Orthographic{},
                              pixel_m, 0.0, 0.0, {{"green", green()}}};
  camera.arrays = {array};
  return std::make_unique<GeoScene>(std::move(camera));
}

}  // namespace nadir::sim::support
