#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <utility>
#include <vector>

#include "core/transform.hpp"
#include "geometry/scene.hpp"
#include "geometry/scene_builder.hpp"
#include "thermal/solve/heat_model.hpp"

// Small scenes and days for tests of the heat balance.

namespace nadir::thermal::test {

inline constexpr double day_s = 86400.0;

/// Where and when: 45 degrees north at an equinox or so, the picture at a local solar hour.
struct Day {
  double picture_hour = 20.0;
  double declination_deg = 10.0;
  double latitude_deg = 45.0;

  [[nodiscard]] double hour(double time_s) const { return picture_hour + time_s / 3600.0; }
  /// To the sun, east-north-up. Textbook spherical astronomy (Duffie & Beckman, ch. 1).
  [[nodiscard]] Vec3 sun(double time_s) const {
    const double angle = (hour(time_s) - 12.0) * std::numbers::pi / 12.0;
    const double d = declination_deg * std::numbers::pi / 180.0;
    const double l = latitude_deg * std::numbers::pi / 180.0;
    return {-std::cos(d) * std::sin(angle),
            std::cos(l) * std::sin(d) - std::sin(l) * std::cos(d) * std::cos(angle),
            std::sin(l) * std::sin(d) + std::cos(l) * std::cos(d) * std::cos(angle)};
  }
};

inline SunTrack sun_track(const Day& day, double interval_s = 600.0, double days = 1.0) {
  SunTrack track;
  const auto moments = static_cast<int>(std::lround(days * day_s / interval_s));
  for (int i = -moments; i <= 0; ++i) {
    track.time_s.push_back(i * interval_s);
    track.direction.push_back(day.sun(i * interval_s));
    track.epoch.push_back(geometry::at_the_picture);
  }
  return track;
}

/// A fine day, the same again and again.
inline Weather fine_weather(const Day& day, double days = 1.0) {
  Weather weather;
  const auto add = [](TimeSeries& series, double time_s, double value) {
    series.time_s.push_back(time_s);
    series.value.push_back(value);
  };
  const auto moments = static_cast<int>(std::lround(days * 144.0));
  for (int i = -moments; i <= 0; ++i) {
    const double t = 600.0 * i, z = std::max(0.0, day.sun(t).z);
    const double warmth = std::cos((day.hour(t) - 15.0) * std::numbers::pi / 12.0);
    add(weather.air_temperature_k, t, 290.0 + 6.0 * warmth);
    add(weather.vapour_pressure_hpa, t, 10.0);
    add(weather.pressure_hpa, t, 1000.0);
    add(weather.wind_speed_m_s, t, 2.0 + warmth);
    add(weather.direct_normal_w_m2, t, z > 0.0 ? 900.0 * std::pow(z, 0.25) : 0.0);
    add(weather.diffuse_horizontal_w_m2, t, 100.0 * std::sqrt(z));
    add(weather.sky_long_wave_w_m2, t, 310.0 + 15.0 * warmth);
  }
  return weather;
}

/// Nothing changes and no sun shines.
inline Weather still_weather(double air_k, double sky_long_wave_w_m2) {
  Weather weather;
  weather.air_temperature_k = {{0.0}, {air_k}};
  weather.vapour_pressure_hpa = {{0.0}, {10.0}};
  weather.pressure_hpa = {{0.0}, {1000.0}};
  weather.wind_speed_m_s = {{0.0}, {2.0}};
  weather.direct_normal_w_m2 = {{0.0}, {0.0}};
  weather.diffuse_horizontal_w_m2 = {{0.0}, {0.0}};
  weather.sky_long_wave_w_m2 = {{0.0}, {sky_long_wave_w_m2}};
  return weather;
}

/// Half a metre of dry ground.
inline HeatMaterial soil() {
  HeatMaterial material;
  material.layers.layers = {{{0.8, 1600.0, 1000.0}, 0.5, 0.0}};
  return material;
}
/// A millimetre of painted steel with weather on both sides.
inline HeatMaterial sheet() {
  HeatMaterial material;
  material.layers.layers = {{{45.0, 7800.0, 480.0}, 0.001, 0.0}};
  material.layers.back = OpenBack{};
  return material;
}

inline constexpr std::uint32_t of_soil = 0, of_sheet = 1, of_wall = 2;

/// Soil (0), sheet (1) and a wall whose temperature nobody solves (2).
inline HeatModel model_of(const Day& day) {
  HeatModel model;
  model.weather = fine_weather(day);
  model.sun = sun_track(day);
  model.materials = {soil(), sheet(), std::nullopt};
  model.surroundings = {{0.2, 0.95, OfItsHeatBalance{}},
                        {0.3, 0.90, OfItsHeatBalance{}},
                        {0.3, 0.92, FollowsAir{0.0}}};
  model.settings.exposure.sky_rays = 32;
  return model;
}

// ---- geometry -----------------------------------------------------------------------------------

/// A rectangle of two triangles from a corner along two sides; its outward side is that of
/// cross(u, v).
struct Rectangle {
  Vec3 corner, u, v;
};

inline geometry::Surface surface(const Rectangle& r, std::uint32_t material,
                                 std::uint32_t epochs = geometry::always) {
  geometry::TriangleMesh mesh;
  mesh.positions = {r.corner, r.corner + r.u, r.corner + r.u + r.v, r.corner + r.v};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  return {std::move(mesh), {material}, epochs};
}
/// Level, seen from above, about the origin.
inline Rectangle ground(double half_m = 50.0) {
  return {{-half_m, -half_m, 0.0}, {2.0 * half_m, 0.0, 0.0}, {0.0, 2.0 * half_m, 0.0}};
}
inline geometry::Scene scene_of(const std::vector<geometry::Surface>& surfaces) {
  geometry::SceneBuilder builder;
  std::uint32_t object = 0;
  for (const auto& one : surfaces) builder.add(one, {}, object++);
  return builder.build();
}

inline geometry::Hit looking(const geometry::Scene& scene, Vec3 from, Vec3 to) {
  return scene.intersect({from, normalised(to - from)}).value();
}
/// What a camera overhead sees.
inline geometry::Hit from_above(const geometry::Scene& scene, double x, double y) {
  return looking(scene, {x, y, 500.0}, {x, y, 0.0});
}

}  // namespace nadir::thermal::test
