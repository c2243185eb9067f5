#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "core/error.hpp"
#include "hard/hard_case.hpp"
#include "support/floating_point_traps.hpp"

// Scenes of nothing, of one triangle, and of triangles as small and as large as they come.

namespace nadir::radiometry::test {
namespace {

const spectral::Lanes both_scene{{0.55_um, 10.0_um}};

TEST_CASE("a scene of nothing shows the sky, and a sun where one stands", "[hard][scene]") {
  for (const Method method : both_solvers) {
    SmallScene scene;
    scene.method = method;
    scene.sky(2.0);
    scene.add_body(0.0, 50.0, 0.266, 1000.0);
    const SceneDescription empty = scene.build();
    CHECK_FALSE(empty.geometry.intersect(downward()).has_value());
    CHECK_FALSE(empty.geometry.occluded(downward()));
    CAPTURE(name_of(method));
    check_right(hard_measure(empty, both_scene, {{}, {0.0, 0.0, 1.0}}, 4, 1), 2.0);
    const double half = std::sin(0.5 * degrees(0.266).value);
    const double disc = 1000.0 / (4.0 * std::numbers::pi * half * half);
    const Vec3 to_sun = direction_enu(0.0, degrees(50.0).value);
    check_right(hard_measure(empty, both_scene, {{}, to_sun}, 4, 1), 2.0 + disc);
  }
}

TEST_CASE("a scene of one triangle: Lambert's radiance inside, the sky outside", "[hard][scene]") {
  for (const Method method : both_solvers) {
    for (const double size_m : {1e-3, 1.0, 1e5}) {
      SmallScene scene;
      scene.method = method;
      geometry::TriangleMesh one;
      one.positions = {{0.0, 0.0, 0.0}, {size_m, 0.0, 0.0}, {0.0, size_m, 0.0}};
      one.triangles = {{0, 1, 2}};
      scene.add(one, scene.material(grey(0.5), Kelvin{0.0}));
      scene.sky(2.0);
      const SceneDescription built = scene.build();
      const auto at = [&](double x, double y) {
        return hard_measure(built, both_scene, {{x * size_m, y * size_m, 10.0}, {0.0, 0.0, -1.0}},
                            4, 4);
      };
      CAPTURE(name_of(method), size_m);
      check_right(at(0.25, 0.25), 1.0, 2e-5);  // flat and open: 0.5 times the sky
      check_right(at(0.999, 0.0005), 1.0, 2e-5);
      for (const Estimate& lane : at(0.6, 0.6).lanes) CHECK(lane.mean == Approx(2.0).epsilon(1e-6));
    }
  }
}

TEST_CASE("a triangle without area is never hit and breaks nothing beside it", "[hard][scene]") {
  SmallScene scene;
  const std::uint32_t material = scene.material(grey(0.0), 300.0_K);
  geometry::TriangleMesh mesh;
  mesh.positions = {{-5.0, -5.0, 0.0}, {5.0, -5.0, 0.0}, {0.0, 5.0, 0.0},
                    {0.0, 0.0, 1.0},   {1.0, 0.0, 1.0},  {2.0, 0.0, 1.0}};
  mesh.triangles = {{0, 1, 2}, {3, 4, 5}, {3, 3, 3}, {3, 4, 4}};  // a line, a point, an edge
  scene.add(mesh, material);
  const SceneDescription built = scene.build();
  const auto hit = built.geometry.intersect({{0.5, 0.0, 10.0}, {0.0, 0.0, -1.0}});
  REQUIRE(hit.has_value());
  CHECK(hit->position.z == Approx(0.0).margin(1e-6));
  CHECK(hit->primitive == 0);
  check_right(hard_measure(built, both_scene, {{0.5, 0.0, 10.0}, {0.0, 0.0, -1.0}}, 4, 1),
              black_body(both_scene, 300.0_K));
}

TEST_CASE("a triangle of a micrometre and one of 1000 km in one scene are both hit where they are",
          "[hard][scene]") {
  SmallScene scene;
  const std::uint32_t ground = scene.material(grey(0.0), 280.0_K);
  scene.add(two_triangles({-5e5, -5e5, 0.0}, {5e5, -5e5, 0.0}, {5e5, 5e5, 0.0}, {-5e5, 5e5, 0.0}),
            ground);
  const std::uint32_t tiny = scene.material(grey(0.0), 320.0_K);
  // Vertices are floats about the scene's centre, here the origin: a micrometre has all its digits.
  geometry::TriangleMesh one;
  one.positions = {{0.0, 0.0, 50.0}, {1e-6, 0.0, 50.0}, {0.0, 1e-6, 50.0}};
  one.triangles = {{0, 1, 2}};
  scene.add(one, tiny);
  const SceneDescription built = scene.build();
  const auto at = [&](double x, double y) {
    return built.geometry.intersect({{x, y, 100.0}, {0.0, 0.0, -1.0}});
  };
  CHECK(at(4.9e5, -4.9e5)->material == ground);
  CHECK(at(1.0, 1.0)->material == ground);
  CHECK(at(4.9e5, -4.9e5)->distance == Approx(100.0).epsilon(1e-9));
}

TEST_CASE("vertices that are not numbers, or beyond what floats hold, are refused",
          "[hard][scene]") {
  const double infinite = std::numeric_limits<double>::infinity();
  for (const double bad : {std::nan(""), infinite, -infinite, 1e39}) {
    CAPTURE(bad);
    std::optional<support::WithoutTraps> without;
    if (std::isnan(bad)) without.emplace();  // the very comparison is invalid
    const auto build = [&] {
      SmallScene scene;
      geometry::TriangleMesh mesh;
      mesh.positions = {{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {0.0, bad, 0.0}};
      mesh.triangles = {{0, 1, 2}};
      scene.add(mesh, scene.material(grey(0.5), 300.0_K));
      return scene.build();
    };
    CHECK_THROWS_AS(build(), InputError);
  }
}

TEST_CASE("reflectance and emissivity of exactly 0 and 1 keep their furnace", "[hard][scene]") {
  const double reflectance = GENERATE(0.0, 1e-30, 0.5, 1.0 - 1e-7, 1.0);
  for (const Method method : both_solvers) {
    SmallScene scene;
    scene.method = method;
    scene.add(geometry::Plane{{}, 100.0, 100.0}, scene.material(grey(reflectance), 300.0_K));
    scene.sky(0.0, 300.0_K);  // as warm as the ground: a black body, whatever the reflectance
    CAPTURE(reflectance, name_of(method));
    const auto seen = hard_measure(scene.build(), spectral::Lanes{{10.0_um}}, downward(), 8, 64);
    check_right(seen, spectral::planck(10.0_um, 300.0_K).value, 1e-4);
  }
}

TEST_CASE("a pane of transmittance 1 is not there", "[hard][scene]") {
  for (const Method method : both_solvers) {
    SmallScene scene;
    scene.method = method;
    materials::Material pane = scaled(materials::ClearSheet{}, 0.0);
    pane.transmittance = spectral::Curve::constant(1.0);
    scene.add(geometry::Plane{{0.0, 0.0, 5.0}, 50.0, 50.0}, scene.material(pane, 300.0_K));
    scene.add(geometry::Plane{{}, 100.0, 100.0}, scene.material(grey(0.0), 300.0_K));
    CAPTURE(name_of(method));
    const auto seen = hard_measure(scene.build(), spectral::Lanes{{10.0_um}}, downward(), 8, 64);
    check_right(seen, spectral::planck(10.0_um, 300.0_K).value, 1e-4);
  }
}

TEST_CASE("a night pixel 1e-9 as bright as its neighbour keeps six digits", "[hard][scene]") {
  // Two walls back to back, one in the sun, one lit by a moon 1e-9 as bright.
  for (const Method method : both_solvers) {
    SmallScene scene;
    scene.method = method;
    scene.add(geometry::Plane{{0.0, 0.0, 0.0}, 1.0, 1.0}, scene.material(grey(0.5), Kelvin{0.0}));
    scene.add(geometry::Plane{{3.0, 0.0, 0.0}, 1.0, 1.0}, scene.material(grey(5e-10), Kelvin{0.0}));
    scene.add_body(120.0, 40.0, 0.266, 1500.0);
    scene.solver = {.initial_sample_count = 0, .min_quad_samples = 0};
    const SceneDescription built = scene.build();
    const auto bright = hard_measure(built, both_scene, downward(), 4, 64);
    const auto dark = hard_measure(built, both_scene, {{3.0, 0.0, 10.0}, {0.0, 0.0, -1.0}}, 4, 64);
    CAPTURE(name_of(method));
    const double sunlit = 0.5 / std::numbers::pi * 1500.0 * std::sin(degrees(40.0).value);
    check_right(bright, sunlit);
    // The generic solver leaves out a target of weight below 1e-7 (docs/radiometry.md).
    if (method == Method::path) check_right(dark, 1e-9 * sunlit);
    check_sane(dark);
    for (const Estimate& lane : dark.lanes) CHECK(lane.mean <= 1.01e-9 * sunlit);
  }
}

}  // namespace
}  // namespace nadir::radiometry::test
