#include <cmath>
#include <numbers>

#include "hard/hard_case.hpp"

// Views that graze the surface: a tenth of a degree above it.

namespace nadir::radiometry::test {
namespace {

const spectral::Lanes visible_view{{0.45_um, 0.65_um}};
const spectral::Lanes thermal_ir_view{{8.5_um, 12.0_um}};
const geometry::Ray grazing = slanted({}, 89.9, 100.0);

TEST_CASE("a Lambertian plane viewed at 89.9 degrees is as bright as from above", "[hard][view]") {
  for (const Method method : both_solvers) {
    SmallScene scene;
    scene.method = method;
    scene.add(geometry::Plane{{}, 1000.0, 1000.0}, scene.material(grey(0.4), Kelvin{0.0}));
    scene.add_body(200.0, 40.0, 0.266, 1000.0);
    scene.sky(80.0);
    const auto seen = hard_measure(scene.build(), visible_view, grazing, 16, 64);
    CAPTURE(name_of(method));
    check_right(seen, 0.4 * (1000.0 * std::sin(degrees(40.0).value) / std::numbers::pi + 80.0));
  }
}

TEST_CASE("a mirror viewed at 89.9 degrees shows the sky near the horizon", "[hard][view]") {
  for (const Method method : both_solvers) {
    SmallScene scene;
    scene.method = method;
    scene.add(geometry::Plane{{}, 1000.0, 1000.0},
              scene.material(scaled(materials::Mirror{}, 0.7), Kelvin{0.0}));
    scene.overcast(70.0);
    const auto seen = hard_measure(scene.build(), visible_view, grazing, 8, 64);
    const double sky = 3.0 / 7.0 * (1.0 + 2.0 * std::cos(degrees(89.9).value)) * 70.0;
    CAPTURE(name_of(method));
    check_right(seen, 0.7 * sky);
  }
}

TEST_CASE("what facets reflect and emit at 89.9 degrees adds up to the black body around them",
          "[hard][view]") {
  // Isothermal: Kirchhoff leaves no other answer. Tolerance: emissivity is read from a table of
  // albedo, whose own noise and steps are stated as 1e-2 of the reflectance at grazing view.
  struct Case {
    const char* name;
    materials::Scattering model;
  };
  const Case cases[] = {
      {"metal", materials::Microfacet{.alpha_x = 0.3,
                                      .alpha_y = 0.3,
                                      .n = spectral::Curve::constant(12.0),
                                      .k = spectral::Curve::constant(55.0)}},
      {"water", materials::CoxMunk{.wind_speed_m_s = 8.0}},
      {"dielectric", materials::Microfacet{.alpha_x = 0.1, .alpha_y = 0.1}},
  };
  for (const Case& c : cases) {
    for (const Method method : both_solvers) {
      SmallScene scene;
      scene.method = method;
      scene.add(geometry::Plane{{}, 1000.0, 1000.0}, scene.material(own_spectra(c.model), 300.0_K));
      scene.sky(0.0, 300.0_K);
      scene.solver = {.initial_sample_count = 32, .mu_samples = 8, .phi_samples = 8};
      const auto seen = hard_measure(scene.build(), thermal_ir_view, grazing, 16, 64);
      CAPTURE(c.name, name_of(method));
      check_right(seen, black_body(thermal_ir_view, 300.0_K), 1e-2);
    }
  }
}

}  // namespace
}  // namespace nadir::radiometry::test
