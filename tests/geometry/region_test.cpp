#include "geometry/region.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include "core/error.hpp"
#include "core/random.hpp"
#include "support/catch.hpp"
#include "support/directions.hpp"

namespace nadir::geometry {
namespace {

const Affine in_place{};

Ray ray(Vec3 origin, Vec3 direction) { return {origin, normalised(direction)}; }

double length_of(const std::optional<Interval>& part) {
  return part ? part->end - part->begin : 0.0;
}

// A few roundings of coordinates of order 1.
constexpr double rounding = 1e-13;

TEST_CASE("a ray through a region has the chord of the shape inside", "[geometry][region]") {
  const Region box{Box{{-1.0, -2.0, 0.0}, {1.0, 2.0, 5.0}}, in_place};
  const Region sphere{Sphere{{1.0, 0.0, 0.0}, 2.0}, in_place};
  const Region cylinder{Cylinder{{0.0, 0.0, 1.0}, {0.0, 0.0, 4.0}, 0.5, false}, in_place};

  const auto through = box.crossing(ray({0.0, 0.0, 10.0}, {0.0, 0.0, -1.0}));
  REQUIRE(through.has_value());
  CHECK(through->begin == Approx(5.0).epsilon(rounding));
  CHECK(through->end == Approx(10.0).epsilon(rounding));
  // Off the centre by b the chord is 2 sqrt(r^2 - b^2).
  CHECK(length_of(sphere.crossing(ray({-9.0, 1.2, 0.0}, {1.0, 0.0, 0.0}))) ==
        Approx(2.0 * std::sqrt(4.0 - 1.44)).epsilon(rounding));
  // Capped: along the axis it is the whole length, slanted the wall cuts it.
  CHECK(length_of(cylinder.crossing(ray({0.1, 0.1, 9.0}, {0.0, 0.0, -1.0}))) ==
        Approx(3.0).epsilon(rounding));
  CHECK(length_of(cylinder.crossing(ray({-3.0, 0.0, 2.0}, {1.0, 0.0, 0.0}))) ==
        Approx(1.0).epsilon(rounding));
  CHECK_FALSE(cylinder.crossing(ray({-3.0, 0.0, 5.0}, {1.0, 0.0, 0.0})).has_value());
  CHECK_FALSE(sphere.crossing(ray({-9.0, 2.1, 0.0}, {1.0, 0.0, 0.0})).has_value());
}

TEST_CASE("a region counts only in front of the ray and before its end", "[geometry][region]") {
  const Region box{Box{{0.0, 0.0, 0.0}, {1.0, 1.0, 1.0}}, in_place};
  Ray inside = ray({0.25, 0.5, 0.5}, {1.0, 0.0, 0.0});
  CHECK(box.crossing(inside)->begin == 0.0);
  CHECK(box.crossing(inside)->end == Approx(0.75).epsilon(rounding));
  inside.max_distance = 0.5;
  CHECK(box.crossing(inside)->end == 0.5);
  CHECK_FALSE(box.crossing(ray({2.0, 0.5, 0.5}, {1.0, 0.0, 0.0})).has_value());
  // Along a face: parallel to two pairs of sides, whichever way the zero is signed.
  CHECK(length_of(box.crossing({{-1.0, 0.0, 0.5}, {1.0, -0.0, 0.0}})) ==
        Approx(1.0).epsilon(rounding));
}

TEST_CASE("crossings and containment agree under any placement", "[geometry][region]") {
  const Affine placement{rotation(normalised({1.0, 2.0, -0.5}), 0.8) * scaling({1.0, -2.0, 0.3}),
                         {10.0, -4.0, 3.0}};
  const RegionShape shapes[] = {Box{{-1.0, -1.0, -1.0}, {2.0, 1.0, 1.0}}, Sphere{{0.3, 0, 0}, 1.5},
                                Cylinder{{0.0, -1.0, 0.0}, {1.0, 1.0, 0.5}, 0.8, true}};
  Rng rng{1};
  for (const RegionShape& shape : shapes) {
    const Region region{shape, placement};
    const Bounds bounds = region.bounds();
    int met = 0;
    for (int i = 0; i < 300; ++i) {
      const Vec3 aim{bounds.lo.x + rng.next() * (bounds.hi.x - bounds.lo.x),
                     bounds.lo.y + rng.next() * (bounds.hi.y - bounds.lo.y),
                     bounds.lo.z + rng.next() * (bounds.hi.z - bounds.lo.z)};
      const Vec3 towards = support::random_on_sphere(rng);
      const Ray r{aim - 50.0 * towards, towards};
      const auto part = region.crossing(r);
      CHECK((part && part->begin <= 50.0 && part->end >= 50.0) == region.contains(aim));
      if (!part) continue;
      ++met;
      const double margin = 1e-6 * (part->end - part->begin);
      CHECK(region.contains(r.origin + (part->begin + margin) * towards));
      CHECK(region.contains(r.origin + (part->end - margin) * towards));
      CHECK_FALSE(region.contains(r.origin + (part->begin - margin - 1e-9) * towards));
      CHECK_FALSE(region.contains(r.origin + (part->end + margin + 1e-9) * towards));
    }
    CHECK(met > 100);
  }
}

TEST_CASE("a metre-wide ball keeps its chord from a satellite's distance", "[geometry][region]") {
  const Region ball{Sphere{{0.0, 0.0, 1.0}, 0.5}, in_place};
  const double height = GENERATE(8e5, 3.6e7);
  const auto part = ball.crossing(ray({0.3, 0.0, height}, {0.0, 0.0, -1.0}));
  REQUIRE(part.has_value());
  // Both ends are rounded as numbers of the size of the distance.
  CHECK(length_of(part) == Approx(0.8).margin(4e-16 * height));
}

TEST_CASE("regions without an inside are refused", "[geometry][region]") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_AS((Region{Box{{0, 0, 0}, {1, 0, 1}}, in_place}), InputError);
  CHECK_THROWS_AS((Region{Sphere{{0, 0, 0}, -1.0}, in_place}), InputError);
  CHECK_THROWS_AS((Region{Sphere{{0, nan, 0}, 1.0}, in_place}), InputError);
  CHECK_THROWS_AS((Region{Cylinder{{0, 0, 1}, {0, 0, 1}, 1.0}, in_place}), InputError);
  CHECK_THROWS_AS((Region{Sphere{{0, 0, 0}, 1.0}, {scaling({1.0, 0.0, 1.0}), {}}}), InputError);
  CHECK_THROWS_AS((Region{Sphere{{0, 0, 0}, 1.0}, {Mat3{}, {nan, 0.0, 0.0}}}), InputError);
}

}  // namespace
}  // namespace nadir::geometry
