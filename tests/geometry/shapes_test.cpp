#include "core/error.hpp"
#include "geometry/scene_helpers.hpp"
#include "support/catch.hpp"

using namespace nadir;
using namespace nadir::geometry;
using namespace nadir::geometry::test;

namespace {

// Shapes are cut in double: a few roundings of coordinates of a few metres.
constexpr double exact = 1e-14;

void check_close(Vec3 a, Vec3 b, double margin = exact) {
  CHECK(a.x == Approx(b.x).margin(margin).epsilon(0.0));
  CHECK(a.y == Approx(b.y).margin(margin).epsilon(0.0));
  CHECK(a.z == Approx(b.z).margin(margin).epsilon(0.0));
}

}  // namespace

TEST_CASE("a sphere is hit from outside at its near side and from inside at its far side") {
  const Vec3 centre{1.0, -2.0, 3.0};
  const Scene scene = scene_of(surface(Sphere{centre, 2.0}, 7));
  Rng rng{1};
  for (int i = 0; i < 200; ++i) {
    const Vec3 d = random_direction(rng);
    const auto outside = scene.intersect({centre - 5.0 * d, d});
    REQUIRE(outside);
    CHECK(outside->distance == Approx(3.0).epsilon(exact));
    check_close(outside->normal, -d);
    CHECK_FALSE(outside->back_face);
    CHECK(outside->material == 7);
    const auto inside = scene.intersect({centre, d});
    REQUIRE(inside);
    CHECK(inside->distance == Approx(2.0).epsilon(exact));
    check_close(inside->normal, -d);
    CHECK(inside->back_face);
    check_close(inside->position, centre + 2.0 * d);
  }
}

TEST_CASE("a ray that grazes a sphere meets it at the impact parameter's chord") {
  const Scene scene = scene_of(surface(Sphere{{}, 1.0}));
  for (const double below : {1e-2, 1e-6, 1e-10}) {
    const double impact = 1.0 - below;
    const auto hit = scene.intersect({{-3.0, 0.0, impact}, {1.0, 0.0, 0.0}});
    REQUIRE(hit);
    // Half chord sqrt(1 - b^2) = sqrt(below (1 + b)); rounding of b by 1e-16 moves it by
    // 1e-16 / sqrt(2 below), which is below 1e-11 here.
    CHECK(hit->distance ==
          Approx(3.0 - std::sqrt(below * (1.0 + impact))).margin(1e-11).epsilon(0));
    CHECK(std::abs(length(hit->position) - 1.0) < 1e-15);
    CHECK_FALSE(scene.intersect({{-3.0, 0.0, 1.0 + below}, {1.0, 0.0, 0.0}}));
  }
}

TEST_CASE("a disc is hit on both sides within its radius") {
  const Vec3 normal = normalised({1.0, 2.0, 2.0}), centre{0.5, 0.0, -1.0};
  const Scene scene = scene_of(surface(Disc{centre, 3.0 * normal, 1.5}));
  const Frame axes = frame_about(normal);
  for (const double side : {1.0, -1.0}) {
    for (const double r : {0.0, 0.7, 1.499999, 1.500001, 2.0}) {
      const Vec3 target = centre + r * axes.to_world({0.6, 0.8, 0.0});
      const Vec3 travel = normalised(-side * normal + 0.3 * axes.x);
      const auto hit = scene.intersect({target - 4.0 * travel, travel});
      REQUIRE(hit.has_value() == (r < 1.5));
      if (!hit) continue;
      CHECK(hit->distance == Approx(4.0).epsilon(exact));
      check_close(hit->normal, side * normal);
      CHECK(hit->back_face == (side < 0.0));
    }
  }
}

TEST_CASE("a plane is a rectangle with two sides") {
  const Scene scene = scene_of(surface(Plane{{10.0, 20.0, 5.0}, 4.0, 2.0}));
  const auto hit = scene.intersect({{11.0, 19.5, 8.0}, {0.0, 0.0, -1.0}});
  REQUIRE(hit);
  CHECK(hit->distance == 3.0);
  check_close(hit->normal, {0.0, 0.0, 1.0}, 0.0);
  CHECK(hit->uv.x == Approx(0.75).epsilon(exact));
  CHECK(hit->uv.y == Approx(0.25).epsilon(exact));
  CHECK(scene.intersect({{11.0, 19.5, 2.0}, {0.0, 0.0, 1.0}})->back_face);
  CHECK_FALSE(scene.intersect({{12.001, 20.0, 8.0}, {0.0, 0.0, -1.0}}));
  CHECK_FALSE(scene.intersect({{10.0, 21.001, 8.0}, {0.0, 0.0, -1.0}}));
}

TEST_CASE("a box is hit on every face from outside and from inside") {
  const Box box{{-1.0, -2.0, -3.0}, {2.0, 3.0, 4.0}};
  const Scene scene = scene_of(surface(box));
  const Vec3 p{0.5, 0.25, 0.125};  // inside
  const Vec3 axes[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (const Vec3& axis : axes) {
    for (const double side : {1.0, -1.0}) {
      const Vec3 d = side * axis;
      const double to_face = side > 0.0 ? dot(box.hi - p, axis) : dot(p - box.lo, axis);
      const auto inside = scene.intersect({p, d});
      REQUIRE(inside);
      CHECK(inside->distance == Approx(to_face).epsilon(exact));
      check_close(inside->normal, -d, 0.0);
      CHECK(inside->back_face);
      const auto outside = scene.intersect({p + 100.0 * d, -d});
      REQUIRE(outside);
      CHECK(outside->distance == Approx(100.0 - to_face).epsilon(exact));
      check_close(outside->normal, d, 0.0);
    }
  }
}

TEST_CASE("a tube is open at its ends unless it is capped") {
  const Cylinder tube{{1.0, 1.0, 0.0}, {1.0, 1.0, 4.0}, 0.5, false};
  Cylinder can = tube;
  can.capped = true;
  const Scene open = scene_of(surface(tube)), closed = scene_of(surface(can));
  const Ray down{{1.1, 1.2, 10.0}, {0.0, 0.0, -1.0}};
  CHECK_FALSE(open.intersect(down));
  const auto cap = closed.intersect(down);
  REQUIRE(cap);
  CHECK(cap->distance == Approx(6.0).epsilon(exact));
  check_close(cap->normal, {0.0, 0.0, 1.0});

  // Through the mouth of the open tube onto the inner wall: at 0.5 m across it is 1 m deeper.
  const Ray slanted{{1.0, 1.0, 5.0}, normalised({0.5, 0.0, -2.0})};
  const auto wall = open.intersect(slanted);
  REQUIRE(wall);
  check_close(wall->position, {1.5, 1.0, 3.0});
  check_close(wall->normal, {-1.0, 0.0, 0.0});
  CHECK(wall->back_face);
  CHECK(wall->uv.y == Approx(0.75).epsilon(exact));

  for (const Scene& scene : {open, closed}) {
    const auto side = scene.intersect({{-3.0, 1.0, 2.0}, {1.0, 0.0, 0.0}});
    REQUIRE(side);
    CHECK(side->distance == Approx(3.5).epsilon(exact));
    check_close(side->normal, {-1.0, 0.0, 0.0});
  }
}

TEST_CASE("a leaning cylinder keeps every hit at its radius from its axis") {
  const Cylinder c{{-1.0, 2.0, 0.5}, {3.0, -1.0, 2.0}, 0.75, false};
  const Scene scene = scene_of(surface(c));
  const Vec3 axis = normalised(c.top - c.base);
  Rng rng{4};
  int hits = 0;
  for (int i = 0; i < 2000; ++i) {
    const Ray ray = random_ray(rng, {1.0, 0.5, 1.25}, 6.0, 3.0);
    const auto hit = scene.intersect(ray);
    if (!hit) continue;
    ++hits;
    const Vec3 from_base = hit->position - c.base;
    const Vec3 across = from_base - dot(from_base, axis) * axis;
    CHECK(length(across) == Approx(0.75).epsilon(exact));
    CHECK(std::abs(dot(hit->normal, axis)) < exact);
    // 1e-13: where the ray nearly touches, the root loses a few digits.
    check_close(ray.origin + hit->distance * ray.direction, hit->position, 1e-13);
    CHECK(scene.occluded(ray));
  }
  CHECK(hits > 100);
}

TEST_CASE("a stretched sphere is an ellipsoid with the normals of its gradient") {
  const Vec3 axes{3.0, 1.0, 0.5};
  const Affine placement{rotation(normalised({1, 1, 0}), 0.7) * scaling(axes), {5.0, 6.0, 7.0}};
  const Affine back = placement.inverse();
  const Scene scene = scene_of(surface(Sphere{{}, 1.0}), placement);
  Rng rng{5};
  for (int i = 0; i < 300; ++i) {
    const Vec3 d = random_direction(rng);
    const auto hit = scene.intersect({placement.origin - 20.0 * d, d});
    REQUIRE(hit);
    const Vec3 local = back.point(hit->position);
    CHECK(length(local) == Approx(1.0).epsilon(1e-13));  // 20 m away: roundings of 4e-15 m
    check_close(hit->normal, normalised(back.linear.transposed() * local), 1e-12);
  }
  const Bounds bounds = scene.bounds();
  // The support function of an ellipsoid: half widths are the lengths of the rows of its matrix.
  const Mat3 rows = placement.linear.transposed();
  CHECK(bounds.hi.x - placement.origin.x == Approx(length(rows.x)).epsilon(1e-12));
  CHECK(bounds.hi.z - placement.origin.z == Approx(length(rows.z)).epsilon(1e-12));
}

TEST_CASE("shapes without a size are refused") {
  SceneBuilder builder;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<Shape> bad{Sphere{{}, 0.0},
                               Sphere{{nan, 0, 0}, 1.0},
                               Disc{{}, {}, 1.0},
                               Box{{0, 0, 0}, {1, 0, 1}},
                               Plane{{}, 1.0, -1.0},
                               Cylinder{{1, 1, 1}, {1, 1, 1}, 1.0, false},
                               Cylinder{{}, {0, 0, 1}, nan, false}};
  for (const Shape& shape : bad) CHECK_THROWS_AS(builder.add(surface(shape), {}, 0), InputError);
}
