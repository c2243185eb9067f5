#include <cmath>
#include <numbers>

#include "atmosphere/synthetic_air.hpp"
#include "radiometry/small_scene.hpp"
#include "support/catch.hpp"

// The disc of sun or moon before the sensor's own eye: only the air between the two dims it.

namespace nadir::radiometry::test {
namespace {

const spectral::Lanes one_lane_disc_seen{{0.55_um}};
constexpr double irradiance = 1000.0, radius_deg = 0.266;

double disc_radiance() {
  const double sine = std::sin(degrees(radius_deg).value);
  return irradiance / (std::numbers::pi * sine * sine);
}

/// Air of one extinction, in which the table says that 0.8 of the sun comes to the ground.
atmosphere::SyntheticAir air_of(std::vector<double> view_heights_m) {
  atmosphere::SyntheticAir air;
  air.extinction = atmosphere::constant(2e-5);
  air.view_heights_m = std::move(view_heights_m);
  return air;
}

SceneDescription scene_of(const atmosphere::Atmosphere& air, Method method) {
  const atmosphere::SyntheticAir made;
  SmallScene scene;
  scene.method = method;
  scene.add(geometry::Plane{{0.0, 0.0, 0.0}, 10.0, 10.0}, scene.material(grey(0.5), Kelvin{0.0}));
  scene.add_body(to_degrees(Angle{made.body_azimuth_rad}),
                 90.0 - to_degrees(Angle{made.body_zenith_rad}), radius_deg, irradiance);
  SceneDescription built = scene.build();
  built.atmosphere = air;
  return built;
}

atmosphere::Tabulated tabulated(const atmosphere::SyntheticAir& air) {
  return {std::make_shared<const atmosphere::AirTable>(air.table()), {{0.0F}, {0.0F}}};
}

double share_seen(const atmosphere::Atmosphere& air, Method method, double height_m) {
  const SceneDescription scene = scene_of(air, method);
  const geometry::Ray ray{{0.0, 0.0, height_m}, scene.illumination.front().direction_enu};
  return measure(scene, one_lane_disc_seen, ray, 1, 1).lanes[0].mean / disc_radiance();
}

}  // namespace

TEST_CASE("the sensor sees sun and moon through the air that lies before it", "[radiometry][air]") {
  const atmosphere::SyntheticAir air = air_of({1500.0});
  for (const Method method : {Method::generic, Method::path}) {
    // From orbit nothing does. Float lanes: 1e-6.
    CHECK(share_seen(tabulated(air), method, 700e3) == Approx(1.0).epsilon(1e-6));
    // At a view's height, the whole way up from there.
    const atmosphere::PathPoint eye{1500.0, std::cos(air.body_zenith_rad)};
    const double way_m = atmosphere::way_up_to_m(eye, air.top_m);
    const double depth = 2e-5 * atmosphere::air_measure_m(eye.height_m, air.top_m, way_m);
    CHECK(std::exp(-depth) < 0.9);
    CHECK(share_seen(tabulated(air), method, 1500.0) == Approx(std::exp(-depth)).epsilon(1e-5));
  }
}

TEST_CASE("surfaces, and sensors in air without paths, get the sun that comes to the ground",
          "[radiometry][air]") {
  Diagnostics diagnostics;
  const SceneDescription scene = scene_of(tabulated(air_of({1500.0})), Method::generic);
  const LitScene lit{scene, one_lane_disc_seen, diagnostics};
  REQUIRE(lit.targets().size() == 1);
  const Target& sun = lit.targets().front();
  CHECK(sun.outside[0] == Approx(disc_radiance()).epsilon(1e-6));
  CHECK(sun.radiance[0] == Approx(0.8 * disc_radiance()).epsilon(1e-6));
  const auto one = spectral::Curve::constant(1.0), none = spectral::Curve::constant(0.0);
  const atmosphere::Uniform uniform{none, Kelvin{0.0}, spectral::Curve::constant(0.6),
                                    one,  none,        Kelvin{0.0}};
  for (const Method method : {Method::generic, Method::path}) {
    CHECK(share_seen(tabulated(air_of({})), method, 1500.0) == Approx(0.8).epsilon(1e-6));
    CHECK(share_seen(uniform, method, 1500.0) == Approx(0.6).epsilon(1e-6));
    CHECK(share_seen(atmosphere::None{}, method, 1500.0) == Approx(1.0).epsilon(1e-6));
  }
}

}  // namespace nadir::radiometry::test
