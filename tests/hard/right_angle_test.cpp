#include <cmath>
#include <numbers>

#include "hard/hard_case.hpp"

// Sun and view at 90 degrees, and a thousandth of a degree to either side.

namespace nadir::radiometry::test {
namespace {

const spectral::Lanes both{{0.55_um, 10.0_um}};

TEST_CASE("a sun at 89.999, 90 and 90.001 degrees: each higher one is brighter, none breaks",
          "[hard][right_angle]") {
  for (const Method method : both_solvers) {
    double before = std::numeric_limits<double>::infinity();
    for (const double zenith_deg : {89.9, 89.999, 90.0, 90.001, 90.1, 90.2}) {
      SmallScene scene;
      scene.method = method;
      scene.add(geometry::Plane{{}, 1000.0, 1000.0}, scene.material(grey(0.5), Kelvin{0.0}));
      scene.add_body(120.0, 90.0 - zenith_deg, 0.266, 1000.0);
      scene.solver = {.initial_sample_count = 0, .min_quad_samples = 0};
      const auto seen = hard_measure(scene.build(), both, downward(), 8, 256);
      check_sane(seen);
      CAPTURE(name_of(method), zenith_deg, before);
      // The same places on the disc each time: noise is shared.
      CHECK(seen.lanes[0].mean < before);
      CHECK(seen.lanes[0].mean > 0.0);  // the upper limb is up until 90.266
      before = seen.lanes[0].mean;
    }
  }
}

TEST_CASE("a sun wholly below the horizon lights nothing at all", "[hard][right_angle]") {
  for (const Method method : both_solvers) {
    SmallScene scene;
    scene.method = method;
    scene.add(geometry::Plane{{}, 1000.0, 1000.0}, scene.material(grey(0.5), Kelvin{0.0}));
    scene.add_body(120.0, -0.267, 0.266, 1000.0);
    const auto seen = hard_measure(scene.build(), both, downward(), 4, 16);
    for (const Estimate& lane : seen.lanes) CHECK(lane.mean == 0.0);
  }
}

/// A black plane at 300 K under a black sky, looked at from 10 m at an angle from the vertical.
double seen_at(double zenith_deg, Method method) {
  SmallScene scene;
  scene.method = method;
  scene.add(geometry::Plane{{}, 1e7, 1e7}, scene.material(grey(0.0), 300.0_K));
  const double zenith = degrees(zenith_deg).value;
  const geometry::Ray ray{{0.0, 0.0, 10.0}, {std::sin(zenith), 0.0, std::cos(zenith)}};
  const auto seen = hard_measure(scene.build(), both, ray, 2, 1);
  check_sane(seen);
  return seen.lanes[1].mean;
}

TEST_CASE("a view at 90.001 degrees from the zenith sees the ground, at 90 and 89.999 the sky",
          "[hard][right_angle]") {
  const double black = spectral::planck(10.0_um, 300.0_K).value;
  for (const Method method : both_solvers) {
    CHECK(seen_at(90.001, method) == Approx(black).epsilon(1e-6));
    CHECK(seen_at(89.999, method) == 0.0);
    CHECK(seen_at(90.0, method) == 0.0);
  }
}

TEST_CASE("a ray within a surface, along its plane, is told the same whoever asks and whenever",
          "[hard][right_angle]") {
  const double height_m = GENERATE(0.0, 1e-12, -1e-12, 1e-300);
  for (const Method method : both_solvers) {
    SmallScene scene;
    scene.method = method;
    scene.add(two_triangles({-5.0, -5.0, 0.0}, {5.0, -5.0, 0.0}, {5.0, 5.0, 0.0}, {-5.0, 5.0, 0.0}),
              scene.material(grey(0.5), 300.0_K));
    scene.add_body(90.0, 0.0, 0.266, 1000.0);
    scene.sky(1.0);
    const auto seen =
        hard_measure(scene.build(), both, {{-20.0, 0.1, height_m}, {1.0, 0.0, 0.0}}, 4, 4);
    CAPTURE(height_m, name_of(method));
    check_sane(seen);
  }
}

TEST_CASE("mirror and glitter at exactly 90 degrees of incidence stay finite",
          "[hard][right_angle]") {
  for (const Method method : both_solvers) {
    for (const double zenith_deg : {89.999, 89.9999999, 90.0}) {
      SmallScene scene;
      scene.method = method;
      scene.add(geometry::Plane{{}, 1e6, 1e6},
                scene.material(scaled(materials::Mirror{}, 1.0), 300.0_K));
      scene.add_body(90.0, 0.0, 0.266, 1000.0);
      scene.sky(1.0);
      const auto seen = hard_measure(scene.build(), both, slanted({}, zenith_deg, 10.0), 4, 16);
      CAPTURE(zenith_deg, name_of(method));
      check_sane(seen);
    }
  }
}

}  // namespace
}  // namespace nadir::radiometry::test
