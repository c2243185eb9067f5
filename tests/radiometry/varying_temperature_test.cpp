#include "radiometry/emission_rule.hpp"
#include "radiometry/small_scene.hpp"
#include "support/catch.hpp"

// Surfaces whose temperature differs from place to place.

namespace nadir::radiometry::test {
namespace {

const spectral::Lanes thermal_ir_varying_temperature{{3.7_um, 8.5_um, 10.9_um, 12.0_um}};

/// From 280 K at x = -50 m to 320 K at x = 50 m, linear in between.
thermal::MappedTemperature warm_in_the_east() {
  thermal::MappedTemperature map;
  map.frame.origin = {-100.0, 50.0};
  map.frame.step = {100.0, -100.0};
  map.frame.columns = 2;
  map.frame.rows = 1;
  map.kelvin = {280.0F, 320.0F};
  return map;
}

Measured look_down_at(const SceneDescription& scene, const spectral::Lanes& lanes, double x_m) {
  return measure(scene, lanes, {{x_m, 0.0, 10.0}, {0.0, 0.0, -1.0}}, 4, 4);
}

// The table of Planck's function is good to 1e-4 (planck_table.hpp).
TEST_CASE("a surface emits at the temperature of the place that is seen", "[radiometry]") {
  const Method method = GENERATE(Method::generic, Method::path);
  const double reflectance = 0.2, x_m = GENERATE(-50.0, -12.5, 30.0);
  SmallScene scene;
  scene.method = method;
  scene.add(geometry::Plane{{}, 200.0, 100.0},
            scene.material(grey(reflectance), warm_in_the_east()));
  const Measured seen = look_down_at(scene.build(), thermal_ir_varying_temperature, x_m);
  const Kelvin there{300.0 + 0.4 * x_m};
  for (int lane = 0; lane < thermal_ir_varying_temperature.count(); ++lane) {
    const double expected =
        (1.0 - reflectance) * spectral::planck(thermal_ir_varying_temperature[lane], there).value;
    CHECK(seen.lanes[static_cast<std::size_t>(lane)].mean == Approx(expected).epsilon(2e-4));
  }
}

TEST_CASE("glossy surfaces, too, emit at the temperature of their place", "[radiometry]") {
  materials::Material metal;
  metal.name = "metal";
  metal.scattering =
      materials::Mirror{spectral::Curve::constant(2.0), spectral::Curve::constant(3.0)};
  SmallScene scene;
  scene.add(geometry::Plane{{}, 200.0, 100.0}, scene.material(metal, warm_in_the_east()));
  const auto built = scene.build();
  const double cold = look_down_at(built, thermal_ir_varying_temperature, -50.0).lanes[2].mean;
  const double warm = look_down_at(built, thermal_ir_varying_temperature, 50.0).lanes[2].mean;
  const auto black = [](double kelvin) { return spectral::planck(10.9_um, Kelvin{kelvin}).value; };
  CHECK(warm / cold == Approx(black(320.0) / black(280.0)).epsilon(2e-4));
}

TEST_CASE("a neighbour's own temperature is what a mirror shows", "[radiometry]") {
  SmallScene scene;
  scene.solver = {.initial_sample_count = 32, .mu_samples = 4, .phi_samples = 8};
  scene.add(geometry::Plane{{}, 20.0, 20.0}, scene.material(grey(1.0), Kelvin{0.0}));
  thermal::MappedTemperature warm = warm_in_the_east();
  warm.kelvin = {310.0F, 310.0F};
  // A black ceiling far wider than it is high fills the white floor's hemisphere but for 1e-4.
  scene.add(geometry::Plane{{0.0, 0.0, 5.0}, 1000.0, 1000.0}, scene.material(grey(0.0), warm));
  const Measured seen = measure(scene.build(), thermal_ir_varying_temperature,
                                {{0.0, 0.0, 4.0}, {0.0, 0.0, -1.0}}, 4, 16);
  const double black = spectral::planck(10.9_um, 310.0_K).value;
  CHECK(seen.lanes[2].mean == Approx(black).epsilon(1e-3));
}

TEST_CASE("where emission is lost in what is reflected no temperature is asked for",
          "[radiometry]") {
  SmallScene scene;
  scene.add(geometry::Plane{{}, 200.0, 100.0}, scene.material(grey(0.3), warm_in_the_east()));
  scene.add_body(0.0, 60.0, 0.266, 1500.0);
  const auto built = scene.build();
  Diagnostics diagnostics;
  const auto asks = [&](Micrometres wavelength) {
    return LitScene{built, spectral::Lanes{{wavelength}}, diagnostics}.emission_varies();
  };
  CHECK_FALSE(asks(0.55_um));
  CHECK_FALSE(asks(0.86_um));
  CHECK(asks(3.7_um));
  CHECK(asks(10.9_um));
}

// 1500 W m^-2 um^-1 times 1e-6 / pi is 4.8e-4; B(400 K) passes that between 1.46 and 1.47 um.
TEST_CASE("what is seen to emit depends on the light", "[radiometry]") {
  const SpectralIrradiance sun{1500.0}, none{0.0};
  CHECK_FALSE(emission_counts(thermal::warmest_under_the_sun, 1.4_um, sun));
  CHECK(emission_counts(thermal::warmest_under_the_sun, 1.6_um, sun));
  CHECK(emission_counts(thermal::warmest_under_the_sun, 0.95_um, none));
  CHECK_FALSE(emission_counts(thermal::warmest_under_the_sun, 0.7_um, none));
  CHECK(faintest_emission(none) == Approx(1e-10).epsilon(1e-12));
}

}  // namespace
}  // namespace nadir::radiometry::test
