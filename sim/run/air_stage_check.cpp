#include "sim/run/air_stage_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "atmosphere/paths/spherical_path.hpp"
#include "sim/plan/camera_plan.hpp"
#include "sim/run/check_air_bodies.hpp"
#include "sim/run/load_air.hpp"
#include "spectral/coverage.hpp"

namespace nadir::sim {
namespace {

using atmosphere::AirTable;

// A table's light is that of its ground's height: 100 m of height are 1 % of the air.
constexpr double same_height_m = 100.0;

void require_cover(const spectral::Curve& curve, const spectral::Lanes& lanes,
                   const std::string& what) {
  static_cast<void>(spectral::at_all(curve, lanes, what));
}

/// A camera under a surface that it sees from below, with nothing under it.
bool under_ground(const geometry::Scene& scene, Vec3 eye) {
  const auto above = scene.intersect({eye, {0.0, 0.0, 1.0}});
  return above && above->back_face && !scene.intersect({eye, {0.0, 0.0, -1.0}});
}

void check_camera(const Scenario& scenario, const geometry::Scene& scene, const Camera& camera,
                  double ground_m) {
  const Vec3 eye = middle_pose(camera).position;
  const double height_m = height_above_sea_m(eye, ground_m);
  if (height_m < ground_m) {
    refuse_at(
        scenario.platform.where,
        fmt::format("the camera lies {:.1f} m below the height of the site, which is that of the "
                    "ground under the air",
                    ground_m - height_m),
        "set the site's height to the lowest ground of the scene");
  }
  if (under_ground(scene, eye)) {
    refuse_at(scenario.platform.where, "the camera lies inside the ground");
  }
}

void check_place(const AirTable& table, double site_height_m, const SourceLocation& where) {
  if (std::abs(table.ground_m - site_height_m) <= same_height_m) return;
  refuse_at(where,
            fmt::format("the table of the air was made for ground {:.0f} m above the sea, the "
                        "site lies at {:.0f} m",
                        table.ground_m, site_height_m));
}

/// Eyes between a table's views get a blend of them, others the nearest view.
void warn_of_height(const AirTable& table, double height_m, const SourceLocation& where,
                    Diagnostics& diagnostics) {
  if (table.views.empty()) return;
  const double lo = table.views.front().height_m, hi = table.views.back().height_m;
  const double looked_up_m = std::min(height_m, table.top_m);
  if (looked_up_m >= lo - same_height_m && looked_up_m <= hi + same_height_m) return;
  warn_at(
      where,
      fmt::format("the table of the air was made for a camera {} m above the sea; this one at "
                  "{:.0f} m gets the air before it of the nearest of these heights",
                  lo == hi ? fmt::format("{:.0f}", lo) : fmt::format("{:.0f} to {:.0f}", lo, hi),
                  height_m),
      diagnostics);
}

/// A body moved to where it is seen through the air.
void lift(ephemeris::LightSource& body, const ephemeris::AirAtSite& air) {
  const Vec3 towards = body.direction_enu;
  const Angle elevation{std::asin(std::clamp(towards.z, -1.0, 1.0))};
  const Angle seen{elevation.value + ephemeris::refraction(elevation, air).value};
  const double level = std::hypot(towards.x, towards.y);
  if (level == 0.0) return;
  const double scale = std::cos(seen.value) / level;
  body.direction_enu = {towards.x * scale, towards.y * scale, std::sin(seen.value)};
}

}  // namespace

double height_above_sea_m(Vec3 place, double ground_m) noexcept {
  const double radius = atmosphere::earth_radius_m + ground_m;
  // hypot(x, y, radius + z) - radius, without losing the small difference of large numbers.
  const double level = place.x * place.x + place.y * place.y;
  const double centre = std::hypot(place.x, place.y, radius + place.z);
  return ground_m + (level + place.z * (2.0 * radius + place.z)) / (centre + radius);
}

void fit_air(const Scenario& scenario, const LoadedGeometry& geometry,
             const atmosphere::Atmosphere& air, ephemeris::Illumination& bodies,
             const Camera& camera, AirTask& task, Diagnostics& diagnostics) {
  const bool computed = std::holds_alternative<ComputedSky>(scenario.illumination);
  if (!task.layered) {
    const auto& table = *std::get<atmosphere::Tabulated>(air).table;
    check_place(table, scenario.origin.height_m, task.where);
    const CameraPlan plan = plan_camera(camera.arrays, scenario.sampling.wavelengths_per_band);
    check_air_bodies(table, bodies, wavelength_range(plan), task.where);
    check_camera(scenario, geometry.scene, camera, table.ground_m);
    warn_of_height(table, height_above_sea_m(middle_pose(camera).position, table.ground_m),
                   task.where, diagnostics);
    return;
  }
  LayeredTask& layered = *task.layered;
  const double ground_m = layered.air.ground_height_m;
  check_camera(scenario, geometry.scene, camera, ground_m);
  layered.settings.observer_height_m = height_above_sea_m(middle_pose(camera).position, ground_m);
  if (!layered.refraction || !computed) return;
  const ephemeris::AirAtSite at_site = air_at_site(layered.air);
  for (ephemeris::LightSource& body : bodies) lift(body, at_site);
}

void check_air_spectra(const AirTask& task, const spectral::Lanes& lanes) {
  at_element(task.where, [&] {
    if (task.ground.reflectance) {
      require_cover(*task.ground.reflectance, lanes, "the reflectance of the ground about");
    }
  });
}

}  // namespace nadir::sim
