#include <array>
#include <cmath>
#include <memory>
#include <numbers>

#include "hard/hard_case.hpp"

// Volumes of optical depth 1e-8 and 1e3: neither lost beside 1 nor infinite.

namespace nadir::radiometry::test {
namespace {

constexpr double pi = std::numbers::pi;
using spectral::Curve;
const spectral::Lanes visible{{0.45_um, 0.65_um}};
const spectral::Lanes thermal_ir{{8.5_um, 12.0_um}};

constexpr double thickness_m = 10.0;

/// A slab from 1 to 11 m, a kilometre wide, with coefficients that are alike at all wavelengths.
Volume slab(double absorption_depth, double scattering_depth, bool gridded) {
  Volume volume{"slab",
                geometry::Region{geometry::Box{{-500.0, -500.0, 1.0}, {500.0, 500.0, 11.0}}, {}},
                {Curve::constant(absorption_depth / thickness_m),
                 Curve::constant(scattering_depth / thickness_m), materials::HenyeyGreenstein{}},
                nullptr,
                300.0_K,
                {}};
  if (gridded) {
    volume.density =
        std::make_shared<const ScalarGrid>(ScalarGrid{2, 2, 2, std::vector<float>(8, 1.0F)});
  }
  return volume;
}

TEST_CASE("a slab of optical depth 1e-8 emits 1e-8 of Planck, one of 1e3 all of it",
          "[hard][depth]") {
  const double depth = GENERATE(1e-8, 1.0, 1e3);
  const bool gridded = GENERATE(false, true);
  for (const Method method : both_solvers) {
    SmallScene scene;
    scene.method = method;
    scene.add(geometry::Plane{{}, 100.0, 100.0}, scene.material(grey(0.0), Kelvin{0.0}));
    scene.volumes.push_back(slab(depth, 0.0, gridded));
    const auto seen = hard_measure(scene.build(), thermal_ir, downward(50.0), 4, 4);
    std::vector<double> expected = black_body(thermal_ir, 300.0_K);
    for (double& value : expected) value *= -std::expm1(-depth);
    CAPTURE(depth, gridded, name_of(method));
    check_right(seen, expected);
  }
}

TEST_CASE("what is behind a slab of optical depth 1e-8 is all seen, behind one of 1e3 nothing",
          "[hard][depth]") {
  const double depth = GENERATE(1e-8, 1e3);
  const bool gridded = GENERATE(false, true);
  for (const Method method : both_solvers) {
    SmallScene scene;
    scene.method = method;
    scene.add(geometry::Plane{{}, 100.0, 100.0}, scene.material(grey(0.0), 6000.0_K));
    Volume cold = slab(depth, 0.0, gridded);
    cold.temperature = Kelvin{0.0};
    scene.volumes.push_back(cold);
    const auto seen = hard_measure(scene.build(), thermal_ir, downward(50.0), 4, 4);
    std::vector<double> expected = black_body(thermal_ir, 6000.0_K);
    for (double& value : expected) value *= std::exp(-depth);
    CAPTURE(depth, gridded, name_of(method));
    check_right(seen, expected);
  }
}

TEST_CASE("a slab of optical depth 1e-8 scatters sunlight once: tau E / 4 pi", "[hard][depth]") {
  // Light of less than 1e-6 of a ray's weight is below what the generic solver looks at: there the
  // slab has to be thicker than that.
  const bool gridded = GENERATE(false, true);
  for (const Method method : both_solvers) {
    SmallScene scene;
    scene.method = method;
    const double depth = method == Method::path ? 1e-8 : 2e-6;
    scene.add(geometry::Plane{{}, 100.0, 100.0}, scene.material(grey(0.0), Kelvin{0.0}));
    scene.volumes.push_back(slab(0.0, depth, gridded));
    scene.add_body(90.0, 60.0, 0.266, 1000.0);
    const auto seen = hard_measure(scene.build(), visible, downward(50.0), 16, 64);
    CAPTURE(gridded, name_of(method));
    check_right(seen, depth * 1000.0 / (4.0 * pi));
    if (!gridded) CHECK(seen.lanes[0].standard_error < 1e-4 * seen.lanes[0].mean);
  }
}

TEST_CASE("path: a cloud that absorbs nothing cannot be told from an even sky around it",
          "[hard][depth]") {
  // Every path comes out sooner or later with all that it carried. What is random is only how
  // roulette deals with the two paths into which the first segment splits: where it is thin or
  // opaque one of the two is all there is.
  const double depth = GENERATE(1e-8, 1.0, 1e3);
  SmallScene scene;
  scene.method = Method::path;
  scene.volumes.push_back(slab(0.0, depth, false));
  scene.volumes.front().region =
      geometry::Region{geometry::Box{{-5.0, -5.0, 1.0}, {5.0, 5.0, 11.0}}, {}};
  scene.sky(7.0);
  const auto seen = hard_measure(scene.build(), visible, downward(50.0), 8, 32);
  CAPTURE(depth, seen.counters.volume_events);
  // Thousands of float products by numbers that are 1 but for rounding.
  check_right(seen, 7.0, 1e-4);
  CHECK(seen.lanes[0].standard_error < (depth == 1.0 ? 0.03 : 5e-4) * 7.0);
}

TEST_CASE("generic: the same cloud stays between dark and the sky", "[hard][depth]") {
  // It scatters light once in every segment and stops at the bounce limit: what is scattered more
  // often is missing. Thin clouds are right to tau.
  const double depth = GENERATE(1e-8, 1.0, 1e3);
  SmallScene scene;
  scene.volumes.push_back(slab(0.0, depth, false));
  scene.volumes.front().region =
      geometry::Region{geometry::Box{{-5.0, -5.0, 1.0}, {5.0, 5.0, 11.0}}, {}};
  scene.sky(7.0);
  const auto seen = hard_measure(scene.build(), visible, downward(50.0), 8, 32);
  CAPTURE(depth, seen.lanes[0].mean);
  check_sane(seen);
  CHECK(seen.lanes[0].mean < 7.0 * (1.0 + 1e-5));
  if (depth < 1e-6) check_right(seen, 7.0);
}

TEST_CASE("a cloud as warm as everything around it is a black body at any depth", "[hard][depth]") {
  const double depth = GENERATE(1e-8, 1e3);
  for (const Method method : both_solvers) {
    SmallScene scene;
    scene.method = method;
    scene.add(geometry::Plane{{}, 100.0, 100.0}, scene.material(grey(0.0), 300.0_K));
    scene.volumes.push_back(slab(0.5 * depth, 0.5 * depth, false));
    scene.sky(0.0, 300.0_K);
    scene.solver.max_bounces = 40;
    const auto seen = hard_measure(scene.build(), thermal_ir, downward(50.0), 16, 256);
    CAPTURE(depth, name_of(method));
    // 1e-4: the generic solver's thresholds at half the weight a scattering.
    check_right(seen, black_body(thermal_ir, 300.0_K), 1e-4);
  }
}

// Chandrasekhar, Radiative Transfer (1950), sec. 17 and table XI: H functions of isotropic
// scattering. Reflection of a parallel beam of irradiance E by an endless depth:
// L = w E / 4 pi  mu0 / (mu + mu0)  H(mu) H(mu0).
TEST_CASE("path: a cloud of optical depth 1e3 reflects by Chandrasekhar's H functions",
          "[hard][depth]") {
  struct Case {
    double view_deg;  // from the zenith
    double mu;
    std::array<double, 3> h;  // at albedo 0.5, 0.9, 0.99
  };
  const std::array<double, 3> albedo{0.5, 0.9, 0.99}, h_sun{1.187735, 1.556034, 1.848601};
  const Case cases[] = {{0.0, 1.0, {1.251260, 1.850099, 2.472793}},
                        {60.0, 0.5, {1.187735, 1.556034, 1.848601}},
                        {84.26083, 0.1, {1.072369, 1.172143, 1.224875}}};
  const double mu0 = 0.5, sun = 1000.0;
  const spectral::Lanes three{{1.0_um, 2.0_um, 3.0_um}};
  const auto curve = [](double a, double b, double c) {
    return Curve{{1.0, 2.0, 3.0}, {a, b, c}, spectral::Outside::reject};
  };
  SmallScene scene;
  scene.method = Method::path;
  scene.volumes.push_back(
      {"cloud",
       geometry::Region{geometry::Box{{-2e3, -2e3, -1e3}, {2e3, 2e3, 0.0}}, {}},
       {curve(0.5, 0.1, 0.01), curve(0.5, 0.9, 0.99), materials::HenyeyGreenstein{}},
       nullptr,
       Kelvin{0.0},
       {}});
  scene.add_body(0.0, 30.0, 1e-3, sun);
  const SceneDescription description = scene.build();
  for (const Case& c : cases) {
    const auto seen =
        hard_measure(description, three, slanted({0.0, 0.0, 0.0}, c.view_deg, 50.0), 16, 512);
    std::vector<double> expected;
    for (std::size_t i = 0; i < 3; ++i) {
      expected.push_back(albedo[i] * sun / (4.0 * pi) * mu0 / (c.mu + mu0) * c.h[i] * h_sun[i]);
    }
    CAPTURE(c.view_deg);
    check_right(seen, expected, 3e-5);  // six digits of the table, the sun's disc
    for (std::size_t i = 0; i < 3; ++i) {
      CHECK(seen.lanes[i].standard_error < 0.03 * seen.lanes[i].mean);
    }
  }
}

}  // namespace
}  // namespace nadir::radiometry::test
