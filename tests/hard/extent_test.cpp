#include <cmath>
#include <numbers>

#include "hard/hard_case.hpp"

// Far and near, huge and small: what is seen must not depend on the size of numbers.

namespace nadir::radiometry::test {
namespace {

constexpr double extent_pi = std::numbers::pi;
const spectral::Lanes lanes_extent{{0.5_um, 10.0_um}};
constexpr double pixel_rad = 1e-7;

/// From a sensor at `distance_m` and 40 degrees from the zenith of `target`: the ray of the pixel
/// that lies `angle_rad` beside the target's centre, northwards.
geometry::Ray pixel_ray(Vec3 target, double distance_m, double angle_rad) {
  const geometry::Ray centre = slanted(target, 40.0, distance_m);
  const Vec3 travel =
      std::cos(angle_rad) * centre.direction + std::sin(angle_rad) * Vec3{0.0, 1.0, 0.0};
  return {centre.origin, travel};
}

struct Target {
  SceneDescription scene;
  Vec3 centre;
};

/// A level square of a metre, alone or 10 m above ground 500 km wide.
Target one_metre(bool as_mesh, bool in_wide_scene) {
  SmallScene scene;
  const Vec3 c = in_wide_scene ? Vec3{150e3, 90e3, 10.0} : Vec3{};
  const auto material = scene.material(grey(0.5), 300.0_K);
  if (as_mesh) {
    scene.add(two_triangles(c + Vec3{-0.5, -0.5, 0.0}, c + Vec3{0.5, -0.5, 0.0},
                            c + Vec3{0.5, 0.5, 0.0}, c + Vec3{-0.5, 0.5, 0.0}),
              material);
  } else {
    scene.add(geometry::Plane{c, 1.0, 1.0}, material);
  }
  if (in_wide_scene) {
    scene.add(geometry::Plane{{}, 500e3, 500e3}, scene.material(grey(0.1), 290.0_K));
  }
  scene.add_body(270.0, 50.0, 0.266, 1000.0);
  return {scene.build(), c};
}

TEST_CASE("pixels of 1e-7 rad at 800 and 36,000 km see a target of a metre where it is",
          "[hard][extent]") {
  const double distance_m = GENERATE(800e3, 36e6);
  const bool as_mesh = GENERATE(false, true);
  const bool in_wide_scene = GENERATE(false, true);
  const Target target = one_metre(as_mesh, in_wide_scene);
  // Alone the target is stored to 1e-7 m and rays are right to 1e-8 m. In 500 km of scene floats
  // are 0.016 m apart.
  const double edge_m = in_wide_scene ? 0.1 : 1e-5;
  CAPTURE(distance_m, as_mesh, in_wide_scene);
  int wrong = 0, on = 0;
  for (int k = -600; k <= 600; ++k) {
    const double angle = k * pixel_rad * (distance_m > 1e6 ? 0.001 : 0.02);  // parts of a pixel
    const double off = std::abs(distance_m * std::tan(angle));
    const auto hit = target.scene.geometry.intersect(pixel_ray(target.centre, distance_m, angle));
    const bool met = hit && hit->object == 0;
    on += met ? 1 : 0;
    if (std::abs(off - 0.5) > edge_m && met != (off < 0.5)) ++wrong;
  }
  CHECK(wrong == 0);
  CHECK(on > 100);
}

TEST_CASE("a pixel 3.6 m wide of a satellite at 36,000 km gets the target's share of its area",
          "[hard][extent]") {
  const Target target = one_metre(false, false);
  const double distance_m = 36e6;
  int hits = 0;
  for (int i = 0; i < 180; ++i) {
    for (int j = 0; j < 180; ++j) {  // rays 2 cm apart, straight down
      const double x = 0.02 * (i - 89.5), y = 0.02 * (j - 89.5);
      const Vec3 travel = normalised(Vec3{x, y, -distance_m});
      hits += target.scene.geometry.intersect({{0.0, 0.0, distance_m}, travel}) ? 1 : 0;
    }
  }
  CHECK(hits == 2500);
}

TEST_CASE("the radiance of a target of a metre does not depend on the distance", "[hard][extent]") {
  const double distance_m = GENERATE(5.0, 800e3, 36e6);
  const bool in_wide_scene = GENERATE(false, true);
  for (const Method method : both_solvers) {
    Target target = one_metre(true, in_wide_scene);
    target.scene.method = method;
    const auto seen =
        hard_measure(target.scene, lanes_extent, slanted(target.centre, 40.0, distance_m), 16, 64);
    const double reflected = 0.5 * 1000.0 * std::sin(degrees(50.0).value) / extent_pi;
    std::vector<double> expected = black_body(lanes_extent, 300.0_K);
    for (double& value : expected) value = 0.5 * value + reflected;
    CAPTURE(distance_m, in_wide_scene, name_of(method));
    check_right(seen, expected);
  }
}

TEST_CASE("a cavity of a metre and one of 500 km have the same closed form", "[hard][extent]") {
  // Diffuse sphere with a hole of relative area f, isothermal, black surroundings:
  // eps / (1 - rho (1 - f)). Source: Sparrow & Cess, Radiation Heat Transfer (1978), ch. 6.
  const double radius = GENERATE(0.5, 250e3);
  const double rho = 0.5, half_angle = 0.5, hole = 0.5 * (1.0 - std::cos(half_angle));
  for (const Method method : both_solvers) {
    SmallScene scene;
    scene.method = method;
    scene.solver = {.initial_sample_count = 1,
                    .sample_decay_rate = 1.0,
                    .max_bounces = 20,
                    .mu_samples = 4,
                    .phi_samples = 4};
    scene.add(geometry::Sphere{{}, radius}, scene.material(grey(rho), 300.0_K));
    const geometry::Disc lid{
        {0.0, 0.0, radius * std::cos(half_angle)}, {0.0, 0.0, -1.0}, radius * std::sin(half_angle)};
    scene.add(lid, scene.material(grey(0.0), Kelvin{0.0}));
    const auto seen = hard_measure(scene.build(), spectral::Lanes{{8.5_um, 12.0_um}},
                                   {{}, {0.0, 0.6, -0.8}}, 16, 256);
    std::vector<double> expected = black_body(spectral::Lanes{{8.5_um, 12.0_um}}, 300.0_K);
    for (double& value : expected) value *= (1.0 - rho) / (1.0 - rho * (1.0 - hole));
    CAPTURE(radius, name_of(method));
    // 1e-4: the generic solver's last generations (weights below 1e-5).
    check_right(seen, expected, 1e-4);
  }
}

TEST_CASE("the shadow of a wall ends where it must, 100 km from the middle of the scene",
          "[hard][extent]") {
  // A wall 1000 m high, a point-like sun at 45 degrees: the shadow is 1000 m long.
  for (const Method method : both_solvers) {
    SmallScene scene;
    scene.method = method;
    const auto material = scene.material(grey(0.5), Kelvin{0.0});
    const double x = 100e3;
    scene.add(geometry::Plane{{}, 500e3, 500e3}, material);
    scene.add(two_triangles({x, -5e3, -10.0}, {x, 5e3, -10.0}, {x, 5e3, 1000.0}, {x, -5e3, 1000.0}),
              scene.material(grey(0.0), Kelvin{0.0}));
    scene.add_body(270.0, 45.0, 1e-4, 1000.0);  // in the west: the shadow falls eastwards
    scene.solver.min_quad_samples = 0;
    scene.solver.initial_sample_count = 0;
    const SceneDescription description = scene.build();
    const double lit = 0.5 * 1000.0 * std::sqrt(0.5) / extent_pi;
    const auto at = [&](double metres_behind) {
      return hard_measure(description, lanes_extent,
                          {{x + metres_behind, 0.0, 2000.0}, {0.0, 0.0, -1.0}}, 4, 16);
    };
    CAPTURE(name_of(method));
    for (const double inside : {0.1, 1.0, 500.0, 999.5}) check_right(at(inside), 0.0);
    for (const double outside : {-0.1, 1000.5, 5000.0}) check_right(at(outside), lit, 3e-5);
  }
}

TEST_CASE("a lamp of half a metre lights the ground beneath alike in 100 m and 500 km of scene",
          "[hard][extent]") {
  // Shadow rays start lifted off the ground by what the scene's size asks for, and must not take
  // the lamp's own surface for something in the way.
  const double size_m = GENERATE(100.0, 1e4, 5e5);
  const double a = 0.5, h = 3.0;
  for (const Method method : both_solvers) {
    SmallScene scene;
    scene.method = method;
    const Vec3 foot{0.4 * size_m, 0.3 * size_m, 0.0};
    scene.add(geometry::Plane{{}, size_m, size_m}, scene.material(grey(0.5), Kelvin{0.0}));
    scene.add_disc_lamp({foot + Vec3{0.0, 0.0, h}, {0.0, 0.0, -1.0}, a}, 100.0,
                        scene.material(grey(0.0), Kelvin{0.0}));
    const auto seen = hard_measure(scene.build(), lanes_extent, slanted(foot, 40.0, 3.0), 16, 64);
    CAPTURE(size_m, name_of(method));
    // Where the ray meets ground is rounded by up to 1e-8 of the scene's size along it.
    check_right(seen, 0.5 * 100.0 * a * a / (a * a + h * h), 1e-5);
    CHECK(seen.lanes[0].standard_error < 5e-3 * seen.lanes[0].mean);
  }
}

}  // namespace
}  // namespace nadir::radiometry::test
