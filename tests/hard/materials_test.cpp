#include <cmath>
#include <numbers>

#include "hard/hard_case.hpp"

// Surfaces at the ends of what a surface can be: all but lossless, all but a mirror.

namespace nadir::radiometry::test {
namespace {

constexpr double materials_pi = std::numbers::pi;
const spectral::Lanes thermal_ir_materials{{8.5_um, 12.0_um}};
const spectral::Lanes visible_materials{{0.45_um, 0.65_um}};

/// One full sample a hit and as many generations as a path has: what the generic solver can do
/// about many bounces without its rays multiplying.
materials::SolverSettings single_file(int max_bounces) {
  return {.initial_sample_count = 1,
          .sample_decay_rate = 1.0,
          .max_bounces = max_bounces,
          .mu_samples = 2,
          .phi_samples = 4};
}

/// A tube three radii deep with a floor, open to a sky as warm as its walls.
SmallScene bowl(double reflectance) {
  SmallScene scene;
  const auto wall = scene.material(grey(reflectance), 300.0_K);
  scene.add(geometry::Disc{{0.0, 0.0, -3.0}, {0.0, 0.0, 1.0}, 1.0}, wall);
  scene.add(geometry::Cylinder{{0.0, 0.0, -3.0}, {}, 1.0, false}, wall);
  scene.sky(0.0, 300.0_K);
  return scene;
}

TEST_CASE(
    "path: a bowl as warm as the sky is a black body for reflectance 0, 0.999999 and 1 "
    "with 200 bounces",
    "[hard][materials]") {
  const double reflectance = GENERATE(0.0, 0.999999, 1.0);
  SmallScene scene = bowl(reflectance);
  scene.method = Method::path;
  scene.path_max_bounces = 200;
  const auto seen = hard_measure(scene.build(), thermal_ir_materials, downward(), 16, 256);
  CAPTURE(reflectance, seen.counters.bounce_limit_stops);
  // 1e-3 is promised; what 200 bounces leave inside the bowl is below 1e-6.
  check_right(seen, black_body(thermal_ir_materials, 300.0_K), 1e-4);
  CHECK(seen.lanes[0].standard_error < 1e-4 * seen.lanes[0].mean);
}

TEST_CASE("generic: the same bowl is short by what the thresholds cut, up to a tenth where white",
          "[hard][materials]") {
  // The weight falls with every cosine, not with what is lost: in white walls 1e-5 is reached after
  // about twenty bounces, when this share of the light has not left yet. It is the method's own:
  // measured 7.1 +- 0.9 % at reflectance 1, 2.1 +- 0.4 % at 0.9, none at 0.5.
  const double reflectance = GENERATE(0.0, 0.999999, 1.0);
  SmallScene scene = bowl(reflectance);
  scene.solver = single_file(200);
  const auto seen = hard_measure(scene.build(), thermal_ir_materials, downward(), 16, 1024);
  CAPTURE(reflectance, seen.counters.full_weight_downgrades);
  check_sane(seen);
  CHECK((seen.counters.full_weight_downgrades > 0) == (reflectance > 0.0));
  CHECK(seen.counters.bounce_limit_stops == 0);
  for (std::size_t i = 0; i < 2; ++i) {
    const double expected = black_body(thermal_ir_materials, 300.0_K)[i];
    const double noise = 4.0 * seen.lanes[i].standard_error + 1e-5 * expected;
    CAPTURE(seen.lanes[i].mean / expected, seen.lanes[i].standard_error / expected);
    CHECK(seen.lanes[i].mean < expected + noise);
    CHECK(seen.lanes[i].mean > (reflectance > 0.0 ? 0.9 * expected : expected - noise));
  }
}

TEST_CASE("a closed furnace cut off at 200 bounces is short by rho^201", "[hard][materials]") {
  const double reflectance = GENERATE(0.9, 0.99);
  SmallScene scene;
  scene.method = Method::path;
  scene.path_max_bounces = 200;
  scene.add(geometry::Sphere{{}, 5.0}, scene.material(grey(reflectance), 300.0_K));
  const auto seen =
      hard_measure(scene.build(), thermal_ir_materials, {{}, {0.0, 0.6, -0.8}}, 16, 256);
  std::vector<double> expected = black_body(thermal_ir_materials, 300.0_K);
  for (double& value : expected) value *= 1.0 - std::pow(reflectance, 201.0);
  CAPTURE(reflectance);
  check_right(seen, expected);
}

TEST_CASE("white walls without an opening are dark after 200 bounces, not lit by rounding",
          "[hard][materials]") {
  for (const Method method : both_solvers) {
    SmallScene scene;
    scene.method = method;
    scene.path_max_bounces = 200;
    scene.solver = single_file(200);
    scene.add(geometry::Box{{-1.0, -2.0, -3.0}, {1.0, 2.0, 3.0}},
              scene.material(grey(1.0), 300.0_K));
    scene.sky(1e9);
    const auto seen =
        hard_measure(scene.build(), thermal_ir_materials, {{}, {0.0, 0.6, -0.8}}, 4, 64);
    CAPTURE(name_of(method));
    for (const Estimate& lane : seen.lanes) CHECK(lane.mean == 0.0);
  }
}

TEST_CASE("a furnace with mirror walls is a black body of its walls", "[hard][materials]") {
  for (const Method method : both_solvers) {
    SmallScene scene;
    scene.method = method;
    // 0.9^110 = 1e-5 is where the generic solver stops.
    scene.solver = single_file(200);
    scene.add(geometry::Box{{-1.0, -2.0, -3.0}, {1.0, 2.0, 3.0}},
              scene.material(scaled(materials::Mirror{}, 0.9), 300.0_K));
    const auto seen =
        hard_measure(scene.build(), thermal_ir_materials, {{}, {0.48, 0.6, -0.64}}, 16, 512);
    CAPTURE(name_of(method));
    check_right(seen, black_body(thermal_ir_materials, 300.0_K), 3e-5);
  }
}

TEST_CASE("an ideal mirror shows sun and sky by the law of reflection", "[hard][materials]") {
  for (const Method method : both_solvers) {
    SmallScene scene;
    scene.method = method;
    scene.add(geometry::Plane{{}, 100.0, 100.0},
              scene.material(scaled(materials::Mirror{}, 0.6), Kelvin{0.0}));
    scene.add_body(90.0, 30.0, 0.266, 1000.0);
    scene.sky(10.0);
    const SceneDescription description = scene.build();
    const double sine = std::sin(degrees(0.266).value);
    const double sun = 1000.0 / (materials_pi * sine * sine);
    CAPTURE(name_of(method));
    // Seen from the west at 60 degrees from the zenith the sun's image is there, half a degree
    // beside it there is sky.
    check_right(hard_measure(description, visible_materials, slanted({}, 60.0, 5.0), 4, 8),
                0.6 * (sun + 10.0));
    check_right(hard_measure(description, visible_materials, slanted({}, 60.5, 5.0), 4, 8),
                0.6 * 10.0);
  }
}

TEST_CASE("a metal of roughness 1e-4 shows the sun's image less the facets that look past it",
          "[hard][materials]") {
  // Seen along the normal with the sun overhead the facets that look into the disc tilt by less
  // than half its radius r: GGX gives them tan^2(r / 2) / (alpha^2 + tan^2(r / 2)) of all.
  const double alpha = 1e-4, r = degrees(0.266).value;
  const double n = 1.4, k = 7.6, tangent = std::tan(0.5 * r);
  const double fresnel = ((n - 1.0) * (n - 1.0) + k * k) / ((n + 1.0) * (n + 1.0) + k * k);
  const double share = tangent * tangent / (alpha * alpha + tangent * tangent);
  for (const Method method : both_solvers) {
    SmallScene scene;
    scene.method = method;
    const materials::Microfacet metal{.alpha_x = alpha,
                                      .alpha_y = alpha,
                                      .n = spectral::Curve::constant(n),
                                      .k = spectral::Curve::constant(k)};
    scene.add(geometry::Plane{{}, 100.0, 100.0}, scene.material(own_spectra(metal), Kelvin{0.0}));
    scene.add_body(0.0, 90.0, 0.266, 1000.0);
    const auto seen = hard_measure(scene.build(), visible_materials, downward(), 16, 1024);
    const double sun = 1000.0 / (materials_pi * std::sin(r) * std::sin(r));
    CAPTURE(name_of(method));
    check_right(seen, fresnel * share * sun);
    CHECK(seen.lanes[0].standard_error < 2e-3 * seen.lanes[0].mean);
  }
}

TEST_CASE("a furnace of metal of roughness 1e-4 is a black body of its walls",
          "[hard][materials]") {
  // Tolerance: emissivity comes from a table of albedo, good to 2e-3 for so smooth a metal, and
  // the light that meets the wall ten times at all angles multiplies it: measured below 1 %.
  for (const Method method : both_solvers) {
    SmallScene scene;
    scene.method = method;
    scene.solver = single_file(60);
    const materials::Microfacet metal{.alpha_x = 1e-4,
                                      .alpha_y = 1e-4,
                                      .n = spectral::Curve::constant(2.0),
                                      .k = spectral::Curve::constant(3.0)};
    scene.add(geometry::Sphere{{}, 2.0}, scene.material(own_spectra(metal), 300.0_K));
    const auto seen = hard_measure(scene.build(), thermal_ir_materials,
                                   {{0.5, 0.0, 0.0}, {0.0, 0.6, -0.8}}, 16, 512);
    CAPTURE(name_of(method));
    check_right(seen, black_body(thermal_ir_materials, 300.0_K), 1e-2);
  }
}

TEST_CASE("emissivity of an all but perfect reflector keeps its digits", "[hard][materials]") {
  // 1 - 0.999999 must be what the float lanes of reflectance lack of 1: otherwise a closed furnace
  // of such walls is 1.3 % off Planck. Float steps below 1 are 6e-8: 0.1 % of 1e-6 cannot be had by
  // rounding both alone, only by taking one from the other.
  Diagnostics diagnostics;
  const auto bound = materials::bind(grey(0.999999), thermal_ir_materials, diagnostics);
  const materials::Albedo albedo = materials::albedo(bound.scattering, {0.0, 0.0, 1.0});
  const double absorbed = 1.0 - static_cast<double>(albedo.reflectance[0]);
  CHECK(static_cast<double>(bound.own_emissivity[0]) == Approx(absorbed).epsilon(1e-3));
}

}  // namespace
}  // namespace nadir::radiometry::test
