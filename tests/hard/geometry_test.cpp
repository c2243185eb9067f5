#include <cmath>
#include <numbers>

#include "geometry/scene_helpers.hpp"
#include "hard/hard_case.hpp"

// Surfaces that touch, stretch and meet edge on.

namespace nadir::radiometry::test {
namespace {

constexpr double geometry_pi = std::numbers::pi;
const spectral::Lanes visible_geometry{{0.45_um, 0.65_um}};
const spectral::Lanes thermal_ir_geometry{{8.5_um, 12.0_um}};

geometry::TriangleMesh level_square(double half, double z) {
  return two_triangles({-half, -half, z}, {half, -half, z}, {half, half, z}, {-half, half, z});
}

/// Two sheets of a kilometre, the lower one 1 mm beneath.
SmallScene two_sheets(bool as_mesh) {
  SmallScene scene;
  const auto upper = scene.material(grey(0.2), Kelvin{0.0});
  const auto lower = scene.material(grey(0.8), Kelvin{0.0});
  if (as_mesh) {
    scene.add(level_square(500.0, 0.0), upper);
    scene.add(level_square(500.0, -1e-3), lower);
  } else {
    scene.add(geometry::Plane{{}, 1000.0, 1000.0}, upper);
    scene.add(geometry::Plane{{0.0, 0.0, -1e-3}, 1000.0, 1000.0}, lower);
  }
  scene.add_body(140.0, 40.0, 0.266, 1000.0);
  return scene;
}

TEST_CASE("of two sheets 1 mm apart the upper is seen from above and the lower is never lit",
          "[hard][geometry]") {
  const bool as_mesh = GENERATE(false, true);
  for (const Method method : both_solvers) {
    SmallScene scene = two_sheets(as_mesh);
    scene.method = method;
    const SceneDescription description = scene.build();
    CAPTURE(as_mesh, name_of(method));
    for (const double x : {0.0, 123.456, -321.0, 440.0}) {
      const double lit = 0.2 * 1000.0 * std::sin(degrees(40.0).value) / geometry_pi;
      const Vec3 place{x, 0.7 * x, 0.0};
      check_right(hard_measure(description, visible_geometry, slanted(place, 30.0, 900.0), 8, 16),
                  lit);
      // The sun alone shines: neither sheet's underside nor the gap gets any of it.
      const auto up =
          measure(description, visible_geometry, {place + Vec3{0.0, 0.0, -50.0}, {0, 0, 1}}, 4, 16);
      const auto gap = measure(description, visible_geometry,
                               {place + Vec3{0.0, 0.0, -5e-4}, {0.6, 0.0, -0.8}}, 4, 16);
      for (const Estimate& lane : up.lanes) CHECK(lane.mean == 0.0);
      for (const Estimate& lane : gap.lanes) CHECK(lane.mean == 0.0);
    }
  }
}

TEST_CASE("of two sheets 1 mm apart the lower is seen from below, by the sky below",
          "[hard][geometry]") {
  for (const Method method : both_solvers) {
    SmallScene scene = two_sheets(true);
    scene.method = method;
    scene.sky(10.0);  // as bright below the horizon
    scene.solver = {.initial_sample_count = 16, .mu_samples = 8, .phi_samples = 8};
    const auto seen = hard_measure(scene.build(), visible_geometry,
                                   {{77.0, -88.0, -50.0}, {0.0, 0.0, 1.0}}, 16, 16);
    CAPTURE(name_of(method));
    check_right(seen, 8.0);
  }
}

/// A floor of triangles 100 m long and 0.1 m wide.
geometry::TriangleMesh slivers(int strips) {
  geometry::TriangleMesh mesh;
  for (int i = 0; i <= strips; ++i) {
    const double x = 0.1 * i;
    mesh.positions.push_back({x, -50.0, 0.0});
    mesh.positions.push_back({x, 50.0, 0.0});
  }
  for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(strips); ++i) {
    mesh.triangles.push_back({2 * i, 2 * i + 2, 2 * i + 3});
    mesh.triangles.push_back({2 * i, 2 * i + 3, 2 * i + 1});
  }
  return mesh;
}

TEST_CASE("a floor of triangles 1000 times longer than wide hides what glows beneath it",
          "[hard][geometry]") {
  SmallScene scene;
  scene.add(slivers(200), scene.material(grey(0.5), Kelvin{0.0}));
  scene.add(geometry::Plane{{10.0, 0.0, -0.5}, 19.0, 99.0}, scene.material(grey(0.0), 6000.0_K));
  scene.sky(1.0);
  SceneDescription description = scene.build();
  Diagnostics diagnostics;
  const LitScene lit{description, visible_geometry, diagnostics};
  PathSolver solver{lit};
  Rng rng{5};
  int wrong = 0;
  for (int i = 0; i < 30'000; ++i) {
    // Every third ray goes exactly through a long edge, every third through a diagonal's end.
    double x = 1.0 + 18.0 * rng.next(), y = 90.0 * (rng.next() - 0.5);
    if (i % 3 == 1) x = 0.1 * std::round(10.0 * x);
    if (i % 3 == 2) y = 1000.0 * (x - 0.1 * std::floor(10.0 * x)) - 50.0;
    const geometry::Ray ray = slanted({x, y, 0.0}, 85.0 * rng.next(), 200.0);
    const Sampler numbers{9, static_cast<std::uint32_t>(i)};
    const auto hit = lit.intersect(ray, numbers);
    const float seen = solver.aperture_radiance(ray, hit, numbers)[0];
    // An even sky of 1 on a floor of 0.5: every path brings one half, or it met the glow.
    if (!(std::abs(seen - 0.5F) < 1e-5F)) ++wrong;
  }
  CHECK(wrong == 0);
}

TEST_CASE("no light leaks in at the foot of a canyon wall of two triangles 4 km long",
          "[hard][geometry]") {
  const double height = 20.0;
  for (const Method method : both_solvers) {
    SmallScene scene;
    scene.method = method;
    const auto material = scene.material(grey(0.7), Kelvin{0.0});
    scene.add(two_triangles({-2000.0, -30.0, 0.0}, {2000.0, -30.0, 0.0}, {2000.0, 30.0, 0.0},
                            {-2000.0, 30.0, 0.0}),
              material);
    scene.add(two_triangles({-2000.0, 0.0, 0.0}, {2000.0, 0.0, 0.0}, {2000.0, 0.0, height},
                            {-2000.0, 0.0, height}),
              material);
    scene.add_body(0.0, 30.0, 0.266, 1000.0);  // in the north, behind the wall
    scene.solver = {.initial_sample_count = 8, .mu_samples = 4, .phi_samples = 8};
    const SceneDescription description = scene.build();
    CAPTURE(name_of(method));
    for (const double x : {0.0, 777.7, -1234.5, 1990.0}) {
      // Ground and wall within reach of the shadow see each other and the black sky: nothing.
      for (const double from_foot : {1e-4, 1e-3, 0.01, 0.1, 1.0, 20.0}) {
        CAPTURE(x, from_foot);
        const auto ground = measure(description, visible_geometry,
                                    {{x, -from_foot, 50.0}, {0.0, 0.0, -1.0}}, 4, 16);
        for (const Estimate& lane : ground.lanes) CHECK(lane.mean == 0.0);
        if (from_foot > 1.0) continue;
        const auto wall =
            measure(description, visible_geometry, {{x, -25.0, from_foot}, {0.0, 1.0, 0.0}}, 4, 16);
        for (const Estimate& lane : wall.lanes) CHECK(lane.mean == 0.0);
      }
      // The sunlit side, for contrast.
      const auto lit =
          measure(description, visible_geometry, {{x, 25.0, 10.0}, {0.0, -1.0, 0.0}}, 4, 64);
      CHECK(lit.lanes[0].mean > 0.7 * 1000.0 * std::cos(degrees(30.0).value) / geometry_pi);
    }
  }
}

TEST_CASE("a ray along an edge or through a corner sees what is around it", "[hard][geometry]") {
  // A grey box in surroundings as warm as itself: whatever the ray decides to have met, it is the
  // black body's radiance; a lost, doubled or non-finite contribution is not.
  const geometry::TriangleMesh box = geometry::test::box_mesh({-1.0, -2.0, -0.5}, {1.0, 2.0, 0.5});
  for (const Method method : both_solvers) {
    SmallScene scene;
    scene.method = method;
    scene.add(box, scene.material(grey(0.5), 300.0_K));
    scene.sky(0.0, 300.0_K);
    // A ray may find the box's inside through a corner: 0.5^18 is left out there.
    scene.solver = {.initial_sample_count = 1,
                    .sample_decay_rate = 1.0,
                    .max_bounces = 16,
                    .mu_samples = 2,
                    .phi_samples = 4};
    const SceneDescription description = scene.build();
    Diagnostics diagnostics;
    const LitScene lit{description, thermal_ir_geometry, diagnostics};
    CAPTURE(name_of(method));
    std::vector<geometry::Ray> rays;
    for (const auto& t : box.triangles) {
      for (std::size_t k = 0; k < 3; ++k) {
        const Vec3 a = box.positions[t[k]], b = box.positions[t[(k + 1) % 3]];
        const Vec3 along = normalised(b - a);
        rays.push_back({a - 3.0 * along, along});  // along an edge or a diagonal
        rays.push_back({{5.0, 4.0, 3.0}, normalised(a - Vec3{5.0, 4.0, 3.0})});  // at a corner
        const Vec3 middle = 0.5 * (a + b);
        rays.push_back({{-5.0, 4.0, 3.0}, normalised(middle - Vec3{-5.0, 4.0, 3.0})});
      }
    }
    for (const geometry::Ray& ray : rays) {
      // The generic solver's quads leave the cosine inside a quad to chance: that noise is in the
      // error bar; 1e-4 is for replicates whose noise happens to be alike.
      const Measured seen = method == Method::path
                                ? measure_with(PathSolver{lit}, lit, ray, 16, 16, 1)
                                : measure_with(GenericSolver{lit}, lit, ray, 16, 16, 1);
      check_right(seen, black_body(thermal_ir_geometry, 300.0_K), 1e-4);
    }
  }
}

TEST_CASE("a ray into the corners of a closed furnace sees a black body", "[hard][geometry]") {
  const geometry::TriangleMesh box = geometry::test::box_mesh({-1.0, -2.0, -0.5}, {1.0, 2.0, 0.5});
  SmallScene scene;
  scene.method = Method::path;
  scene.add(box, scene.material(grey(0.5), 300.0_K));
  const SceneDescription description = scene.build();
  for (const Vec3& corner : box.positions) {
    const geometry::Ray ray{{0.2, -0.3, 0.1}, normalised(corner - Vec3{0.2, -0.3, 0.1})};
    check_right(hard_measure(description, thermal_ir_geometry, ray, 16, 64),
                black_body(thermal_ir_geometry, 300.0_K));
  }
}

TEST_CASE("nothing of a bright sky gets into a closed box, however long the walk",
          "[hard][geometry]") {
  // White cold walls and a sky of 1e9: one ray that slips through any edge would be seen.
  const geometry::TriangleMesh box = geometry::test::box_mesh({-1.0, -2.0, -0.5}, {1.0, 2.0, 0.5});
  SmallScene scene;
  scene.method = Method::path;
  scene.path_max_bounces = 250;
  scene.add(box, scene.material(grey(1.0), Kelvin{0.0}));
  scene.sky(1e9);
  scene.add_body(30.0, 60.0, 0.266, 1e9);
  const auto seen = measure(scene.build(), visible_geometry, {{}, {0.48, 0.6, 0.64}}, 8, 128);
  for (const Estimate& lane : seen.lanes) CHECK(lane.mean == 0.0);
  CHECK(seen.counters.path_rays == 8 * 128 * 250);
}

/// Bounces in all directions inside a box: how many rays find no wall, and how many meet again the
/// wall that they leave.
struct Bounced {
  int escapes = 0, self_hits = 0;
};
Bounced bounce_about(const geometry::Scene& scene, Vec3 start, int paths, int bounces) {
  Rng rng{77};
  Bounced result;
  for (int path = 0; path < paths; ++path) {
    geometry::Ray ray{start, geometry::test::random_direction(rng)};
    Vec3 left{};
    for (int bounce = 0; bounce < bounces; ++bounce) {
      const auto hit = scene.intersect(ray);
      if (!hit) {
        ++result.escapes;
        break;
      }
      if (dot(left, hit->normal) > 1.0 - 1e-13) ++result.self_hits;
      Vec3 d = geometry::test::random_direction(rng);
      if (dot(d, hit->normal) < 0.0) d = -d;
      left = hit->normal;
      ray = {leaving_origin(*hit, d), d};
    }
  }
  return result;
}

TEST_CASE("1e7 rays in a closed box: none escapes, none hits the wall that it leaves",
          "[hard][geometry][slow]") {
  const geometry::TriangleMesh box = geometry::test::box_mesh({-1.0, -2.0, -0.5}, {1.0, 2.0, 0.5});
  const auto scene = geometry::test::scene_of(geometry::test::surface(box));
  const Bounced bounced = bounce_about(scene, {}, 1'000'000, 10);
  CHECK(bounced.escapes == 0);
  CHECK(bounced.self_hits == 0);
}

TEST_CASE("1e6 rays in a box of triangles 1000 times longer than wide: none escapes",
          "[hard][geometry]") {
  const geometry::TriangleMesh box =
      geometry::test::box_mesh({-1000.0, -1.0, -1.0}, {1000.0, 1.0, 1.0});
  const auto scene = geometry::test::scene_of(geometry::test::surface(box));
  const Bounced bounced = bounce_about(scene, {}, 100'000, 10);
  CHECK(bounced.escapes == 0);
  CHECK(bounced.self_hits == 0);
}

}  // namespace
}  // namespace nadir::radiometry::test
