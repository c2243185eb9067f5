#include "core/transform.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include "core/random.hpp"
#include "support/catch.hpp"
#include "support/directions.hpp"

using namespace nadir;

namespace {

double distance(const Mat3& a, const Mat3& b) {
  return length(a.x - b.x) + length(a.y - b.y) + length(a.z - b.z);
}

Vec3 random_vector(Rng& rng) { return 10.0 * rng.next() * support::random_on_sphere(rng); }

Affine random_placement(Rng& rng) {
  const Mat3 turn = rotation(support::random_on_sphere(rng), 7.0 * rng.next());
  const Vec3 scale{0.5 + rng.next(), 0.5 + rng.next(), -0.5 - rng.next()};
  return {turn * scaling(scale), random_vector(rng)};
}

}  // namespace

// Scales between 0.5 and 1.5 keep the condition below 3, vectors are shorter than 10: 1e-14.
TEST_CASE("the inverse of a placement undoes it, from either side", "[core][transform]") {
  Rng rng{31};
  for (int i = 0; i < 100; ++i) {
    const Affine a = random_placement(rng);
    const Vec3 p = random_vector(rng);
    CHECK(length(a.inverse().point(a.point(p)) - p) < 1e-13);
    CHECK(length((a * a.inverse()).point(p) - p) < 1e-13);
    CHECK(length(a.inverse().vector(a.vector(p)) - p) < 1e-13);
    CHECK(distance(a.linear.inverse() * a.linear, Mat3{}) < 1e-14);
  }
}

TEST_CASE("a product of placements applies the right one first", "[core][transform]") {
  Rng rng{32};
  for (int i = 0; i < 100; ++i) {
    const Affine a = random_placement(rng), b = random_placement(rng);
    const Vec3 p = random_vector(rng);
    CHECK(length((a * b).point(p) - a.point(b.point(p))) < 1e-13);
    CHECK((a * b).linear.determinant() ==
          Approx(a.linear.determinant() * b.linear.determinant()).epsilon(1e-13));
  }
  const Affine move{Mat3{}, {1, 2, 3}}, grow{scaling({2, 2, 2}), {}};
  CHECK((grow * move).point({1, 0, 0}) == Vec3{4, 4, 6});
  CHECK((move * grow).point({1, 0, 0}) == Vec3{3, 2, 3});
}

TEST_CASE("a rotation is orthogonal, keeps its axis and turns right-handed", "[core][transform]") {
  Rng rng{33};
  for (int i = 0; i < 100; ++i) {
    const Vec3 axis = support::random_on_sphere(rng);
    const double angle = 20.0 * rng.next() - 10.0;
    const Mat3 r = rotation(axis, angle);
    CHECK(r.determinant() == Approx(1.0).epsilon(1e-14));
    CHECK(distance(r * r.transposed(), Mat3{}) < 5e-15);
    CHECK(length(r * axis - axis) < 2e-15);
    CHECK(distance(r * rotation(axis, -angle), Mat3{}) < 5e-15);
  }
  const Mat3 quarter = rotation({0, 0, 1}, std::numbers::pi / 2.0);
  CHECK(length(quarter * Vec3{1, 0, 0} - Vec3{0, 1, 0}) < 1e-15);
  CHECK(length(quarter * Vec3{0, 1, 0} - Vec3{-1, 0, 0}) < 1e-15);
}

TEST_CASE("matrices multiply by columns", "[core][transform]") {
  const Mat3 m{{1, 2, 3}, {4, 5, 6}, {7, 8, 10}};
  CHECK(m * Vec3{1, 10, 100} == Vec3{741, 852, 1063});
  CHECK(m.determinant() == -3.0);
  CHECK(m.transposed().x == Vec3{1, 4, 7});
  CHECK(m.transposed().transposed().y == m.y);
}

TEST_CASE("vectors obey the identities of Lagrange and Jacobi", "[core][vec]") {
  Rng rng{34};
  for (int i = 0; i < 100; ++i) {
    const Vec3 a = random_vector(rng), b = random_vector(rng), c = random_vector(rng);
    const double square = std::pow(length(cross(a, b)), 2) + std::pow(dot(a, b), 2);
    CHECK(square == Approx(dot(a, a) * dot(b, b)).epsilon(1e-13));
    const Vec3 cyclic = cross(a, cross(b, c)) + cross(b, cross(c, a)) + cross(c, cross(a, b));
    CHECK(length(cyclic) < 1e-11);  // sums of terms up to 1000
    CHECK(length(normalised(a)) == Approx(1.0).epsilon(1e-15));
  }
  CHECK(cross({1, 0, 0}, {0, 1, 0}) == Vec3{0, 0, 1});
}

TEST_CASE("a vector with one bad component is not finite", "[core][vec]") {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  constexpr double infinity = std::numeric_limits<double>::infinity();
  CHECK(is_finite({1.0, -2.0, 0.0}));
  CHECK_FALSE(is_finite({nan, 0.0, 0.0}));
  CHECK_FALSE(is_finite({0.0, infinity, 0.0}));
  CHECK_FALSE(is_finite({0.0, 0.0, -infinity}));
}
