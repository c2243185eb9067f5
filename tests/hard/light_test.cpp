#include <cmath>
#include <numbers>

#include "hard/hard_case.hpp"
#include "support/quadrature.hpp"

// Suns and lamps at the ends of what they can be.

namespace nadir::radiometry::test {
namespace {

constexpr double light_pi = std::numbers::pi;
const spectral::Lanes visible_light{{0.45_um, 0.65_um}};

/// Irradiance of a level plane by the part of a disc that is above the horizon, for a disc that
/// gives 1 on a plane normal to it: the sum over circles of equal elevation a,
/// integral 2 p(a) sin a cos a da, with the half width p: cos p = (cos r - sin e sin a) / (cos e
/// cos a).
double level_irradiance(double elevation_deg, double radius_deg) {
  const long double e = degrees(elevation_deg).value, r = degrees(radius_deg).value;
  const auto circle = [&](long double a) {
    const long double cosine =
        (std::cos(r) - std::sin(e) * std::sin(a)) / (std::cos(e) * std::cos(a));
    const long double half_width = std::acos(std::min(1.0L, std::max(-1.0L, cosine)));
    return 2.0L * half_width * std::sin(a) * std::cos(a);
  };
  const long double sum = support::integrate(circle, std::max(0.0L, e - r), e + r);
  return static_cast<double>(sum / (std::numbers::pi_v<long double> * std::sin(r) * std::sin(r)));
}

TEST_CASE("a disc on the horizon lights a plane by a segment of the circle: r - sin r cos r",
          "[hard][light]") {
  // The half cap seen from above is the segment that the cap's plane cuts off the unit circle.
  const double r = degrees(0.266).value;
  const double segment = (r - std::sin(r) * std::cos(r)) / (light_pi * std::sin(r) * std::sin(r));
  CHECK(level_irradiance(0.0, 0.266) == Approx(segment).epsilon(1e-8));
  CHECK(level_irradiance(40.0, 0.266) == Approx(std::sin(degrees(40.0).value)).epsilon(1e-9));
}

TEST_CASE(
    "a sun half a degree from the zenith, grazing, and cut in half by the horizon lights a "
    "plane by the part of its disc that is up",
    "[hard][light]") {
  const double zenith_deg = GENERATE(0.5, 89.9, 90.0);
  for (const Method method : both_solvers) {
    SmallScene scene;
    scene.method = method;
    scene.add(geometry::Plane{{}, 1000.0, 1000.0}, scene.material(grey(0.5), Kelvin{0.0}));
    scene.add_body(120.0, 90.0 - zenith_deg, 0.266, 1000.0);
    scene.solver = {.initial_sample_count = 0, .min_quad_samples = 0};
    const auto seen = hard_measure(scene.build(), visible_light, downward(), 16, 256);
    const double expected = 0.5 * 1000.0 / light_pi * level_irradiance(90.0 - zenith_deg, 0.266);
    CAPTURE(zenith_deg, name_of(method));
    check_right(seen, expected);
    // 4096 stratified places on the disc; the cosine over it is as uneven as can be at 90 degrees.
    CHECK(seen.lanes[0].standard_error < 0.002 * expected);
  }
}

TEST_CASE("a wall that faces a sun on the horizon gets the half of its disc that is up",
          "[hard][light]") {
  for (const Method method : both_solvers) {
    SmallScene scene;
    scene.method = method;
    scene.add(geometry::Disc{{}, {0.0, -1.0, 0.0}, 1.0}, scene.material(grey(1.0), Kelvin{0.0}));
    scene.add_body(180.0, 0.0, 0.266, 1000.0);
    scene.solver = {.initial_sample_count = 0, .min_quad_samples = 0};
    const auto seen =
        hard_measure(scene.build(), visible_light, {{0.0, -5.0, 0.0}, {0.0, 1.0, 0.0}}, 16, 256);
    CAPTURE(name_of(method));
    // 2.2e-5: the share of the path solver's walks, pdf x solid angle of the disc, none of which
    // happens to meet the disc among so few.
    check_right(seen, 500.0 / light_pi, 3e-5);
  }
}

TEST_CASE("a lamp 1e9 times as bright as the sky is seen, lights, and leaves the sky its share",
          "[hard][light]") {
  // A disc of radius a, h above the ground, shines down: form factor a^2 / (a^2 + h^2).
  const double a = 0.1, h = 5.0, lamp = 1e9;
  const double factor = a * a / (a * a + h * h);
  for (const Method method : both_solvers) {
    SmallScene scene;
    scene.method = method;
    const auto black = scene.material(grey(0.0), Kelvin{0.0});
    scene.add(geometry::Plane{{}, 1000.0, 1000.0}, scene.material(grey(0.3), Kelvin{0.0}));
    scene.add(geometry::Plane{{-60.0, 0.0, 1.0}, 10.0, 10.0},
              scene.material(scaled(materials::Mirror{}, 0.5), Kelvin{0.0}));
    scene.add_disc_lamp({{0.0, 0.0, h}, {0.0, 0.0, -1.0}, a}, lamp, black);
    scene.sky(1.0);
    const SceneDescription description = scene.build();
    CAPTURE(name_of(method));
    SECTION("seen from below it shows its own radiance") {
      const auto seen =
          hard_measure(description, visible_light, {{0.0, 0.0, 1.0}, {0.0, 0.0, 1.0}}, 4, 4);
      check_right(seen, lamp);
    }
    SECTION("from behind it is dark") {
      check_right(hard_measure(description, visible_light, downward(10.0), 4, 4), 0.0);
    }
    SECTION("the ground below it gets its form factor") {
      const auto seen = hard_measure(description, visible_light, downward(1.0), 16, 64);
      check_right(seen, 0.3 * (lamp * factor + (1.0 - factor)));
      CHECK(seen.lanes[0].standard_error < 1e-4 * seen.lanes[0].mean);
    }
    SECTION("a mirror shows it as bright as half of it is, the sky beside it as half of that") {
      // Lamp and mirror meet the ray's image: mirrored in z = 1 the lamp stands at z = 2 - h.
      const Vec3 on_mirror{-60.0, 0.0, 1.0};
      const Vec3 image = normalised(Vec3{0.0, 0.0, 2.0 - h} - on_mirror);
      const auto seen =
          hard_measure(description, visible_light, {on_mirror - 3.0 * image, image}, 4, 16);
      check_right(seen, 0.5 * lamp);
      const Vec3 beside = normalised(Vec3{0.0, 0.0, 2.5 - h} - on_mirror);
      check_right(
          hard_measure(description, visible_light, {on_mirror - 3.0 * beside, beside}, 4, 16), 0.5);
    }
  }
}

TEST_CASE("a sun seen through a pane and by the ground beneath counts once, however wide its disc",
          "[hard][light]") {
  // Shadow ray and straight ray both go through a clear pane: only one of them may count. A disc of
  // 30 degrees is met by many rays. Pane of transmittance t and reflectance 0, ground rho, black
  // sky: rho t E / pi.
  for (const Method method : both_solvers) {
    SmallScene scene;
    scene.method = method;
    materials::Material pane = scaled(materials::ClearSheet{}, 0.0);
    pane.transmittance = spectral::Curve::constant(0.8);
    scene.add(geometry::Disc{{}, {0.0, 0.0, 1.0}, 1.0}, scene.material(grey(0.5), Kelvin{0.0}));
    scene.add(geometry::Plane{{0.0, 0.0, 2.0}, 1000.0, 1000.0}, scene.material(pane, Kelvin{0.0}));
    scene.add_body(0.0, 90.0, 30.0, 1000.0);
    scene.solver = {.initial_sample_count = 16, .sample_decay_rate = 1.0, .mu_samples = 4};
    const auto seen = hard_measure(scene.build(), visible_light, downward(1.0), 16, 64);
    CAPTURE(name_of(method));
    check_right(seen, 0.5 * 0.8 * 1000.0 / light_pi);
    CHECK(seen.lanes[0].standard_error < 0.02 * seen.lanes[0].mean);
  }
}

TEST_CASE("a sun seen through a pane that is half frosted counts in full", "[hard][light]") {
  // Shadow rays stop at a mixture of clear and frosted, so straight rays must bring it all: much
  // noise, but no loss.
  const auto part = [](double weight, const materials::Material& m) {
    return materials::Mixture::Part{weight, std::make_shared<const materials::Material>(m)};
  };
  materials::Material clear = scaled(materials::ClearSheet{}, 0.0);
  clear.transmittance = spectral::Curve::constant(1.0);
  for (const Method method : both_solvers) {
    SmallScene scene;
    scene.method = method;
    const auto pane = own_spectra(materials::Mixture{{part(0.5, clear), part(0.5, grey(0.0))}});
    scene.add(geometry::Disc{{}, {0.0, 0.0, 1.0}, 1.0}, scene.material(grey(0.5), Kelvin{0.0}));
    scene.add(geometry::Plane{{0.0, 0.0, 2.0}, 1000.0, 1000.0}, scene.material(pane, Kelvin{0.0}));
    scene.add_body(0.0, 90.0, 30.0, 1000.0);
    scene.solver = {.initial_sample_count = 32, .sample_decay_rate = 1.0, .mu_samples = 4};
    const auto seen = hard_measure(scene.build(), visible_light, downward(1.0), 16, 128);
    CAPTURE(name_of(method));
    check_right(seen, 0.5 * 0.5 * 1000.0 / light_pi);
    CHECK(seen.lanes[0].standard_error < 0.1 * seen.lanes[0].mean);
  }
}

}  // namespace
}  // namespace nadir::radiometry::test
