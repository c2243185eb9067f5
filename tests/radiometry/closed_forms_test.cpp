#include <cmath>
#include <numbers>

#include "radiometry/small_scene.hpp"
#include "support/catch.hpp"

// Scenes whose radiance is known in closed form. Float lanes carry seven digits: 1e-5 leaves room
// for the rounding of some dozens of float products where nothing is random.

namespace nadir::radiometry::test {
namespace {

constexpr double float_rounding = 1e-5;
const spectral::Lanes visible{{0.45_um, 0.55_um, 0.65_um}};
const spectral::Lanes thermal_ir{{8.5_um, 10.9_um, 12.0_um}};

geometry::Plane ground(double size_m = 1000.0) { return {{0.0, 0.0, 0.0}, size_m, size_m}; }

TEST_CASE("a Lambertian plane under the sun alone reflects rho E cos / pi", "[radiometry]") {
  const double zenith_deg = GENERATE(0.0, 35.0, 60.0, 85.0);
  SmallScene scene;
  scene.add(ground(), scene.material(grey(0.3), Kelvin{0.0}));
  // A point-like sun, so that the cosine is that of the disc's centre to 1e-9.
  scene.add_body(120.0, 90.0 - zenith_deg, 1e-4, 1500.0);
  const auto seen = measure(scene.build(), visible, downward(), 4, 4);
  const double expected = 0.3 * 1500.0 * std::cos(degrees(zenith_deg).value) * std::numbers::inv_pi;
  CAPTURE(zenith_deg);
  // At 85 degrees the drawn direction moves the cosine by up to 1e-4 deg * tan(85) = 2e-5.
  for (const Estimate& lane : seen.lanes) CHECK(lane.mean == Approx(expected).epsilon(3e-5));
}

TEST_CASE("a Lambertian plane under sun and uniform sky adds rho L_sky", "[radiometry]") {
  SmallScene scene;
  scene.add(ground(), scene.material(grey(0.25), Kelvin{0.0}));
  scene.add_body(200.0, 40.0, 0.266, 1000.0);
  scene.sky(80.0);
  scene.solver = {.initial_sample_count = 16, .mu_samples = 4, .phi_samples = 8};
  const auto seen = measure(scene.build(), visible, downward(), 16, 16);
  const double expected =
      0.25 * 1000.0 * std::sin(degrees(40.0).value) * std::numbers::inv_pi + 0.25 * 80.0;
  for (const Estimate& lane : seen.lanes) {
    // Only the cosine inside each quad is random; its stratified error is far below the sun's term.
    CHECK(lane.standard_error < 2e-4 * expected);
    CHECK(std::abs(lane.mean - expected) < 4.0 * lane.standard_error + float_rounding * expected);
  }
}

TEST_CASE("the floor of a black tube sees only the opening: L = rho L_sky sin^2(theta_max)",
          "[radiometry]") {
  const double depth_over_radius = GENERATE(0.5, 1.0, 3.0);
  const double sin2 = 1.0 / (1.0 + depth_over_radius * depth_over_radius);
  SmallScene scene;
  const auto black = scene.material(grey(0.0), Kelvin{0.0});
  scene.add(geometry::Disc{{0.0, 0.0, -depth_over_radius}, {0.0, 0.0, 1.0}, 1.0},
            scene.material(grey(1.0), Kelvin{0.0}));
  scene.add(geometry::Cylinder{{0.0, 0.0, -depth_over_radius}, {0.0, 0.0, 0.0}, 1.0, false}, black);
  scene.sky(50.0);
  // Many narrow rings of quads: the opening's edge cuts them, which is all the noise there is.
  scene.solver = {.initial_sample_count = 0, .mu_samples = 16, .phi_samples = 16};
  const auto seen = measure(scene.build(), visible, downward(), 16, 16);
  const double expected = 50.0 * sin2;
  CAPTURE(depth_over_radius);
  for (const Estimate& lane : seen.lanes) {
    CHECK(lane.standard_error < 0.004 * expected);
    CHECK(std::abs(lane.mean - expected) < 4.0 * lane.standard_error + float_rounding * expected);
  }
}

TEST_CASE("a panel emits eps B(T) and reflects (1 - eps) of a cold sky", "[radiometry]") {
  const double temperature_k = GENERATE(250.0, 300.0, 320.0, 350.0);
  const double emissivity = GENERATE(1.0, 0.9);
  SmallScene scene;
  scene.add(ground(2.0), scene.material(grey(1.0 - emissivity), Kelvin{temperature_k}));
  scene.sky(0.0, 250.0_K);
  scene.solver = {.initial_sample_count = 16, .mu_samples = 8, .phi_samples = 8};
  const auto seen = measure(scene.build(), thermal_ir, downward(), 8, 8);
  CAPTURE(temperature_k, emissivity);
  for (int i = 0; i < thermal_ir.count(); ++i) {
    const double emitted = spectral::planck(thermal_ir[i], Kelvin{temperature_k}).value;
    const double sky = spectral::planck(thermal_ir[i], 250.0_K).value;
    const double expected = emissivity * emitted + (1.0 - emissivity) * sky;
    const Estimate& lane = seen.lanes[static_cast<std::size_t>(i)];
    const double noise = std::isfinite(lane.standard_error) ? lane.standard_error : 0.0;
    CHECK(std::abs(lane.mean - expected) < 4.0 * noise + float_rounding * expected);
  }
}

TEST_CASE("a closed furnace approaches Planck as bounces grow, short by rho^(bounces + 2)",
          "[radiometry]") {
  // Each generation that is followed adds a term eps rho^k B; direct-only samples add the last one.
  const int max_bounces = GENERATE(0, 1, 2, 4, 8);
  SmallScene scene;
  scene.add(geometry::Sphere{{0.0, 0.0, 0.0}, 5.0}, scene.material(grey(0.5), 300.0_K));
  scene.solver = {.initial_sample_count = 4,
                  .sample_decay_rate = 2.0,
                  .max_bounces = max_bounces,
                  .mu_samples = 4,
                  .phi_samples = 4};
  const auto seen = measure(scene.build(), thermal_ir, {{0.0, 0.0, 0.0}, {0.0, 0.6, -0.8}}, 16, 16);
  CAPTURE(max_bounces);
  for (int i = 0; i < thermal_ir.count(); ++i) {
    const double expected =
        spectral::planck(thermal_ir[i], 300.0_K).value * (1.0 - std::pow(0.5, max_bounces + 2));
    const Estimate& lane = seen.lanes[static_cast<std::size_t>(i)];
    CHECK(lane.standard_error < 0.01 * expected);
    CHECK(std::abs(lane.mean - expected) < 4.0 * lane.standard_error + float_rounding * expected);
  }
}

TEST_CASE("inside a closed furnace every direction is a black body of its walls", "[radiometry]") {
  SmallScene scene;
  const auto wall = scene.material(grey(0.5), 300.0_K);
  scene.add(geometry::Box{{-2.0, -2.0, -2.0}, {2.0, 2.0, 2.0}}, wall);
  scene.add(geometry::Sphere{{0.5, 0.3, -0.9}, 0.6}, wall);
  scene.solver = {.initial_sample_count = 4,
                  .sample_decay_rate = 2.0,
                  .max_bounces = 10,
                  .mu_samples = 2,
                  .phi_samples = 4};
  const double azimuth_deg = GENERATE(0.0, 77.0, 210.0);
  const Vec3 direction = direction_enu(degrees(azimuth_deg).value, degrees(-35.0).value);
  const auto seen = measure(scene.build(), thermal_ir, {{-1.0, -1.0, 1.0}, direction}, 16, 16);
  CAPTURE(azimuth_deg);
  for (int i = 0; i < thermal_ir.count(); ++i) {
    const double expected = spectral::planck(thermal_ir[i], 300.0_K).value;
    const Estimate& lane = seen.lanes[static_cast<std::size_t>(i)];
    // Twelve generations leave 0.5^12 = 2.4e-4 of the radiance out.
    CHECK(std::abs(lane.mean - expected) < 4.0 * lane.standard_error + 3e-4 * expected);
  }
}

TEST_CASE("the path through uniform air attenuates, scatters and emits", "[radiometry]") {
  SmallScene scene;
  scene.add(ground(2.0), scene.material(grey(0.0), 300.0_K));
  SceneDescription description = scene.build();
  description.atmosphere =
      atmosphere::Uniform{spectral::Curve::constant(0.0),  Kelvin{0.0},
                          spectral::Curve::constant(1.0),  spectral::Curve::constant(0.7),
                          spectral::Curve::constant(0.25), 280.0_K};
  const auto seen = measure(description, thermal_ir, downward(), 4, 1);
  for (int i = 0; i < thermal_ir.count(); ++i) {
    const double expected = 0.7 * spectral::planck(thermal_ir[i], 300.0_K).value + 0.25 +
                            0.3 * spectral::planck(thermal_ir[i], 280.0_K).value;
    CHECK(seen.lanes[static_cast<std::size_t>(i)].mean == Approx(expected).epsilon(float_rounding));
  }
}

TEST_CASE("a surface at 0 K emits nothing", "[radiometry]") {
  SmallScene scene;
  scene.add(ground(2.0), scene.material(grey(0.1), Kelvin{0.0}));
  for (const Estimate& lane : measure(scene.build(), thermal_ir, downward(), 4, 1).lanes) {
    CHECK(lane.mean == 0.0);
  }
}

TEST_CASE("the open sky is seen where nothing is hit", "[radiometry]") {
  SmallScene scene;
  scene.add(ground(2.0), scene.material(grey(0.1), Kelvin{0.0}));
  scene.sky(12.5);
  const auto seen = measure(scene.build(), visible, {{0.0, 0.0, 5.0}, {0.0, 0.0, 1.0}}, 4, 1);
  for (const Estimate& lane : seen.lanes) CHECK(lane.mean == Approx(12.5).epsilon(1e-6));
}

}  // namespace
}  // namespace nadir::radiometry::test
