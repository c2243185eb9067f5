#include "geometry/scene_helpers.hpp"
#include "support/catch.hpp"

using namespace nadir;
using namespace nadir::geometry;
using namespace nadir::geometry::test;

namespace {

/// Two levels of a square of the given half size, a millimetre apart, as triangles.
Scene two_sheets(double half_m, double gap_m) {
  SceneBuilder builder;
  builder.add(surface(grid_mesh(1, half_m, [](double, double) { return 0.0; }), 1), {}, 1);
  builder.add(surface(grid_mesh(1, half_m, [](double, double) { return 0.0; }), 2),
              {{}, {0.0, 0.0, gap_m}}, 2);
  return builder.build();
}

}  // namespace

// The bound: the origin is rounded to half an ulp of the distance (800 km: 6e-11 m, 36,000 km:
// 4e-9 m), and so are the products of distance and direction, some of each. 10 ulps are allowed.
TEST_CASE("a target of a metre is hit at the right place from orbit") {
  const double range = GENERATE(800e3, 36e6);
  const double bound = 10.0 * range * 0x1.0p-52;
  CAPTURE(range, bound);
  // Around the target a scene of 2 km, so that the target is far from its middle.
  SceneBuilder builder;
  builder.add(surface(Plane{{0, 0, -1.0}, 2000.0, 2000.0}, 1), {}, 0);
  const Vec3 corner{800.0, -700.0, 2.0};
  builder.add(surface(one_triangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0}), 2), {{}, corner}, 1);
  const Scene scene = builder.build();
  Rng rng{41};
  for (int i = 0; i < 500; ++i) {
    double u = rng.next(), v = rng.next();
    if (u + v > 1.0) u = 1.0 - u, v = 1.0 - v;
    // 1 mm off the edges: the float part decides which surface by 6e-5 m here.
    const Vec3 target = corner + Vec3{0.002 + 0.99 * u, 0.002 + 0.99 * v, 0.0};
    const bool on_target = u + v < 0.99;
    const double zenith = 1.2 * rng.next(), azimuth = 6.2 * rng.next();
    const Vec3 up = direction_enu(azimuth, 0.5 * std::numbers::pi - zenith);
    const Vec3 origin = target + range * up;
    const Vec3 travel = normalised(target - origin);
    const auto hit = scene.intersect({origin, travel});
    REQUIRE(hit);
    if (!on_target) continue;
    CHECK(hit->material == 2);
    const double slant = 1.0 / std::cos(zenith);
    CHECK(std::abs(hit->distance - length(target - origin)) < bound * slant);
    CHECK(length(hit->position - target) < bound * slant);
    CHECK(hit->position.z == Approx(2.0).margin(1e-4).epsilon(0));  // its stored height
  }
}

TEST_CASE("a beam from 36,000 km sees the edge of a target where it is") {
  // The float part decides at edges: 2^-23 of the scene's half extent of 1 km is 0.12 mm; allow 1
  // mm.
  SceneBuilder builder;
  builder.add(surface(Plane{{0, 0, -1.0}, 2000.0, 2000.0}, 1), {}, 0);
  builder.add(surface(box_mesh({700, 700, 0}, {701, 701, 1}), 2), {}, 1);
  const Scene scene = builder.build();
  for (const double dx : {-0.001, 0.001, 0.999, 1.001}) {
    const auto hit = scene.intersect({{700.0 + dx, 700.5, 36e6}, {0, 0, -1}});
    REQUIRE(hit);
    CHECK(hit->material == (dx > 0.0 && dx < 1.0 ? 2U : 1U));
  }
}

TEST_CASE("occlusion from far away is that of the same ray from near") {
  const Scene scene = scene_of(surface(box_mesh({-0.5, -0.5, 0}, {0.5, 0.5, 1})));
  Rng rng{42};
  for (int i = 0; i < 300; ++i) {
    const Vec3 aim = random_point(rng, {-1, -1, 0}, {1, 1, 1}), up = random_direction(rng);
    const bool near = scene.occluded({aim + 5.0 * up, -up});
    CHECK(scene.occluded({aim + 36e6 * up, -up}) == near);
    CHECK(scene.intersect({aim + 36e6 * up, -up}).has_value() == near);
  }
}

TEST_CASE("sheets a millimetre apart in a scene of a kilometre are told apart") {
  const Scene scene = two_sheets(500.0, 1e-3);
  Rng rng{43};
  for (int i = 0; i < 2000; ++i) {
    const Vec3 target = random_point(rng, {-499, -499, 0}, {499, 499, 0});
    Vec3 up = random_direction(rng);
    up.z = std::abs(up.z) + 0.05;
    up = normalised(up);
    const auto upper = scene.intersect({target + 300.0 * up, -up});
    REQUIRE(upper);
    CHECK(upper->material == 2);
    const auto lower = scene.intersect({leaving_origin(*upper, -up), -up});
    if (std::max(std::abs(target.x), std::abs(target.y)) < 498.9) {
      REQUIRE(lower);  // the gap is crossed within 0.02 m
      CHECK(lower->material == 1);
      // The sheets as stored are half an ulp of 1e-3 m off, so nearly all of it is the lift.
      CHECK(dot(lower->position - upper->position, {0, 0, 1}) == Approx(-1e-3).epsilon(1e-4));
      const auto back = scene.intersect({leaving_origin(*lower, up), up});
      REQUIRE(back);
      CHECK(back->material == 2);
      CHECK_FALSE(scene.intersect({leaving_origin(*lower, -up), -up}));
      CHECK_FALSE(scene.occluded({leaving_origin(*upper, up), up}));
    }
  }
}

TEST_CASE("the lift follows the place and not the size of the triangle") {
  SceneBuilder builder;
  builder.add(surface(grid_mesh(1, 1000.0, [](double, double) { return 0.0; }), 1), {}, 0);
  const auto big = builder.build().intersect({{10, 20, 5}, {0, 0, -1}});
  builder.add(surface(grid_mesh(200, 1000.0, [](double, double) { return 0.0; }), 1), {}, 0);
  const auto small = builder.build().intersect({{10, 20, 5}, {0, 0, -1}});
  REQUIRE((big && small));
  CHECK(big->lift == small->lift);
  CHECK(big->lift < 1e-4);
}

TEST_CASE("flat ground never shadows itself, in scenes from 0.1 mm to 500 km") {
  const double size = GENERATE(1e-4, 1.0, 1000.0, 5e5);
  const int n = GENERATE(1, 50);
  const Vec3 offset = GENERATE(Vec3{}, Vec3{1e4, -2e4, 300.0});
  CAPTURE(size, n);
  const Scene scene =
      scene_of(surface(grid_mesh(n, size, [](double, double) { return 0.0; })), {{}, offset});
  Rng rng{44};
  int self_hits = 0;
  for (int i = 0; i < 300; ++i) {
    const Vec3 target = offset + size * random_point(rng, {-1, -1, 0}, {1, 1, 0});
    const auto hit = scene.intersect({target + Vec3{0, 0, size}, {0, 0, -1}});
    REQUIRE(hit);
    for (const double elevation : {1e-6, 1e-3, 0.1, 1.5}) {
      const Vec3 d = direction_enu(6.2 * rng.next(), elevation);
      const Ray ray{leaving_origin(*hit, d), d};
      self_hits += scene.occluded(ray) ? 1 : 0;
      self_hits += scene.intersect(ray) ? 1 : 0;
    }
  }
  CHECK(self_hits == 0);
}

TEST_CASE("hits in a scene of 500 km and in one of a metre keep double precision") {
  const double size = GENERATE(1.0, 250e3);
  const auto hill = [&](double x, double y) {
    return 0.1 * size * std::sin(3 * x / size) * std::cos(2 * y / size);
  };
  const TriangleMesh mesh = grid_mesh(20, size, hill);
  const TriangleMesh stored = rounded(mesh);
  const Scene scene = scene_of(surface(mesh));
  Rng rng{45};
  int compared = 0;
  for (int i = 0; i < 300; ++i) {
    const Vec3 target = size * random_point(rng, {-0.8, -0.8, 0}, {0.8, 0.8, 0});
    const Vec3 up = normalised({0.4 * rng.next() - 0.2, 0.4 * rng.next() - 0.2, 1.0});
    const Ray ray{target + 2.0 * size * up, -up};
    const auto expected = brute_force(stored, ray);
    const auto hit = scene.intersect(ray);
    REQUIRE((hit && expected));
    if (hit->primitive != expected->primitive) continue;  // at an edge
    ++compared;
    CHECK(std::abs(hit->distance - expected->distance) < 1e-14 * size);
    CHECK(length(ray.origin + hit->distance * ray.direction - hit->position) < 1e-14 * size);
  }
  CHECK(compared > 295);
}

TEST_CASE("long thin triangles are hit where they are") {
  // 1 km long and 1 cm wide: float rounding here is 0.06 mm.
  const TriangleMesh mesh{{{-500, 0, 0}, {500, 0, 0.3}, {500, 0.01, 0.3}, {-500, 0.01, 0}},
                          {{0, 1, 2}, {0, 2, 3}},
                          {},
                          {},
                          {}};
  const TriangleMesh stored = rounded(mesh);
  const Scene scene = scene_of(surface(mesh));
  Rng rng{46};
  for (int i = 0; i < 1000; ++i) {
    const Vec3 target{998.0 * rng.next() - 499.0, 0.0002 + 0.0096 * rng.next(), 0.0};
    const Vec3 up = normalised({0.6 * rng.next() - 0.3, 0.6 * rng.next() - 0.3, 1.0});
    const Ray ray{target + Vec3{0, 0, 0.15 + 0.0003 * target.x} + 100.0 * up, -up};
    const auto hit = scene.intersect(ray);
    REQUIRE(hit);
    CHECK(std::abs(hit->position.z - (0.15 + 0.0003 * hit->position.x)) < 1e-7);  // stored in float
    CHECK(length(ray.origin + hit->distance * ray.direction - hit->position) < 2e-4);
    CHECK(hit->normal.z > 0.999);
  }
}

TEST_CASE("a ray that starts closer to a wall than floats resolve still meets it") {
  // A slanted box of 2 km: an ulp of 1 km is 0.06 mm, the rays start 0.1 um before the wall.
  const Affine slanted{rotation(normalised({1, 2, 3}), 0.9), {}};
  const double before_m = 1e-7;
  const Scene box = scene_of(surface(box_mesh({-1e3, -1e3, -1e3}, {1e3, 1e3, 1e3})), slanted);
  const Scene ball = scene_of(surface(Sphere{{}, 1e3}));
  Rng rng{47};
  for (const Scene& scene : {box, ball}) {
    for (int i = 0; i < 1000; ++i) {
      const Vec3 d = random_direction(rng);
      const auto wall = scene.intersect({{}, d});
      REQUIRE(wall);
      const Ray ray{wall->position - before_m * d, d};
      const auto hit = scene.intersect(ray);
      REQUIRE(hit);
      CHECK(hit->distance == Approx(before_m).margin(1e-11).epsilon(0.0));  // ulps of 1 km: 1e-13
      CHECK(scene.occluded(ray));
      CHECK_FALSE(scene.occluded({wall->position + before_m * d, d}));
    }
  }
}
