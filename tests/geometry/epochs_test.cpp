#include "geometry/scene_helpers.hpp"
#include "support/catch.hpp"

using namespace nadir;
using namespace nadir::geometry;
using namespace nadir::geometry::test;

namespace {

constexpr std::uint32_t first = 1U, second = 2U, third = 4U;

Surface at_times(Surface s, std::uint32_t epochs) {
  s.epochs = epochs;
  return s;
}

/// What a ray from 5 m above (x, 0) straight down meets: 1 the ground, 2 what stands on it.
std::uint32_t met(const Scene& scene, double x, std::uint32_t epochs) {
  Ray ray{{x, 0.1, 5.0}, {0, 0, -1}};
  ray.epochs = epochs;
  const auto hit = scene.intersect(ray);
  CHECK(scene.occluded(ray) == hit.has_value());
  return hit ? hit->material : 0;
}

/// Whether the ground at (x, 0) sees the sun straight above.
bool lit(const Scene& scene, double x, std::uint32_t epochs) {
  Ray ray{{x, 0.1, 1e-3}, {0, 0, 1}};
  ray.epochs = epochs;
  CHECK(scene.occluded(ray) == scene.intersect(ray).has_value());
  return !scene.occluded(ray);
}

}  // namespace

TEST_CASE("what is there in some epochs only is met, and shades, in those only") {
  const Box block{{-1, -1, 1}, {1, 1, 2}};
  const bool as_shape = GENERATE(true, false), instanced = GENERATE(true, false);
  CAPTURE(as_shape, instanced);
  const Surface crate =
      at_times(as_shape ? surface(Shape{block}, 2) : surface(box_mesh(block.lo, block.hi), 2),
               second | third);
  SceneBuilder builder;
  builder.add(surface(grid_mesh(4, 10.0, [](double, double) { return 0.0; }), 1), {}, 0);
  if (instanced) {
    builder.add_instances({crate}, {Affine{{}, {-4, 0, 0}}, Affine{{}, {4, 0, 0}}}, 1);
  } else {
    builder.add(crate, Affine{{}, {-4, 0, 0}}, 1);
    builder.add(crate, Affine{{}, {4, 0, 0}}, 1);
  }
  const Scene scene = builder.build();
  for (const double x : {-4.3, 4.3}) {
    CHECK(met(scene, x, first) == 1);
    CHECK(met(scene, x, second) == 2);
    CHECK(met(scene, x, third) == 2);
    CHECK(met(scene, x, always) == 2);
    CHECK(met(scene, x, first | third) == 2);
    CHECK(lit(scene, x, first));
    CHECK_FALSE(lit(scene, x, second));
  }
  CHECK(met(scene, 0.3, second) == 1);
  // Bounds are of all times.
  CHECK(scene.bounds().hi.z == 2.0);
}

TEST_CASE("an instance's parts have epochs of their own") {
  SceneBuilder builder;
  builder.add(surface(Shape{Plane{{}, 20.0, 20.0}}, 1), {}, 0);
  builder.add_instances({at_times(surface(Shape{Sphere{{0, 0, 2}, 1.0}}, 2), first),
                         at_times(surface(box_mesh({-1, -1, 1}, {1, 1, 2}), 3), second)},
                        {Affine{}}, 1);
  const Scene scene = builder.build();
  CHECK(met(scene, 0.2, first) == 2);
  CHECK(met(scene, 0.2, second) == 3);
  CHECK(met(scene, 0.2, third) == 1);
}

TEST_CASE("rays look at the moment of the picture unless told otherwise") {
  SceneBuilder builder;
  builder.add(at_times(surface(Shape{Plane{{0, 0, 1}, 2.0, 2.0}}, 1), ~at_the_picture), {}, 0);
  builder.add(at_times(surface(Shape{Plane{{0, 0, 0}, 2.0, 2.0}}, 2), at_the_picture), {}, 1);
  const Scene scene = builder.build();
  const auto hit = scene.intersect({{0.1, 0.1, 5}, {0, 0, -1}});
  REQUIRE(hit);
  CHECK(hit->material == 2);
}

// Rays that go down are tried again displaced: no retry may see another epoch's surfaces.
TEST_CASE("no ray slips through to another epoch's surface, nor by a retry") {
  SceneBuilder builder;
  const auto flat = [](double, double) { return 0.0; };
  builder.add(at_times(surface(grid_mesh(8, 10.0, flat), 1), first), {}, 0);
  builder.add(at_times(surface(grid_mesh(8, 10.0, flat), 2), second), Affine{{}, {0, 0, 1}}, 1);
  const Scene scene = builder.build();
  Rng rng{41};
  for (int i = 0; i < 2000; ++i) {
    // Exactly at vertices every other time.
    const bool vertex = i % 2 == 0;
    const Vec3 at = vertex ? Vec3{2.5 * (i % 7 - 3), 2.5 * (i / 14 % 7 - 3), 0.0}
                           : random_point(rng, {-9, -9, 0}, {9, 9, 0});
    const Vec3 d = normalised(Vec3{rng.next() - 0.5, rng.next() - 0.5, -1.0});
    Ray ray{at - 7.0 * d, d};
    const auto below = scene.intersect(ray);
    REQUIRE(below);
    CHECK(below->material == 1);
    ray.epochs = third;
    CHECK_FALSE(scene.intersect(ray));
    CHECK_FALSE(scene.occluded(ray));
  }
}
