#include "core/quaternion.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/random.hpp"
#include "support/catch.hpp"
#include "support/directions.hpp"

using namespace nadir;

namespace {

double largest_entry(Vec3 v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

/// The largest difference of an entry.
double entry_difference(const Mat3& a, const Mat3& b) {
  return std::max({largest_entry(a.x - b.x), largest_entry(a.y - b.y), largest_entry(a.z - b.z)});
}

Quaternion turn_about(Vec3 axis, double angle_rad) {
  const double s = std::sin(0.5 * angle_rad);
  return {std::cos(0.5 * angle_rad), s * axis.x, s * axis.y, s * axis.z};
}

Quaternion random_quaternion(Rng& rng) {
  return turn_about(support::random_on_sphere(rng), 2.0 * std::numbers::pi * rng.next());
}

}  // namespace

TEST_CASE("a quaternion and its matrix are the same rotation", "[core][quaternion]") {
  Rng rng{71};
  for (int i = 0; i < 1000; ++i) {
    const Vec3 axis = support::random_on_sphere(rng);
    const double angle = 7.0 * rng.next() - 3.5;
    // Each entry is a sum of few products below 1: a few roundings of 1.1e-16;
    // there and back at most 2e-15 in a million.
    CHECK(entry_difference(to_matrix(turn_about(axis, angle)), rotation(axis, angle)) < 3e-15);
    const Quaternion q = random_quaternion(rng);
    const Quaternion back = to_quaternion(to_matrix(q));
    CHECK(std::abs(std::abs(dot(q, back)) - 1.0) < 1e-15);
    CHECK(angle_between(q, back) < 3e-15);
    CHECK(entry_difference(to_matrix(back), to_matrix(q)) < 3e-15);
  }
}

// By the largest component: half turns have w = 0, and each axis a branch of its own.
TEST_CASE("half turns survive the way through the matrix", "[core][quaternion]") {
  for (const Vec3 axis : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}, Vec3{0.6, 0, -0.8},
                          normalised(Vec3{1e-9, 1, -1e-9})}) {
    for (const double angle : {std::numbers::pi, std::numbers::pi - 1e-9, 0.0, 1e-12}) {
      const Quaternion q = turn_about(axis, angle);
      CHECK(angle_between(q, to_quaternion(to_matrix(q))) < 1e-15);
    }
  }
}

TEST_CASE("a product of quaternions is that of their matrices", "[core][quaternion]") {
  Rng rng{72};
  for (int i = 0; i < 200; ++i) {
    const Quaternion a = random_quaternion(rng), b = random_quaternion(rng);
    CHECK(entry_difference(to_matrix(a * b), to_matrix(a) * to_matrix(b)) < 2e-15);
    CHECK(entry_difference(to_matrix(conjugate(a)), to_matrix(a).transposed()) < 1e-15);
    CHECK(entry_difference(to_matrix(-a), to_matrix(a)) == 0.0);
    CHECK(dot(a * conjugate(a), Quaternion{}) == Approx(1.0).epsilon(1e-15));
  }
  const Quaternion scaled = unit({3.0, 0.0, -4.0, 0.0});
  CHECK(scaled.w == Approx(0.6).epsilon(1e-15));
  CHECK(scaled.y == Approx(-0.8).epsilon(1e-15));
}

// Roundings; at 6 rad the arc of the quaternions is 3 rad, and division by its sine makes them 7
// times as large.
TEST_CASE("slerp turns evenly, at all angles", "[core][quaternion]") {
  Rng rng{73};
  for (const double angle :
       {0.0, 1e-300, 1e-12, 1e-6, 0.019, 0.0199999, 0.0200001, 0.021, 0.7, 3.0, 6.0}) {
    const Vec3 axis = support::random_on_sphere(rng);
    const Quaternion a = random_quaternion(rng), b = turn_about(axis, angle) * a;
    for (const double share : {0.0, 1e-9, 0.25, 0.5, 0.8, 1.0}) {
      CAPTURE(angle, share);
      const Quaternion q = slerp(a, b, share);
      CHECK(dot(q, q) == Approx(1.0).epsilon(4e-15));
      CHECK(angle_between(q, turn_about(axis, share * angle) * a) < 4e-15);
    }
  }
  // Not off by the square of tiny angles, as a method by the arc cosine would be: to 1e-7 of them.
  const Quaternion tiny = slerp({}, {1.0, 1e-9, 0.0, 0.0}, 0.3);
  CHECK(tiny.x == Approx(3e-10).epsilon(1e-15));
  const Quaternion opposite = slerp({}, {-1.0, 0.0, 0.0, 0.0}, 0.3);
  CHECK(std::abs(opposite.w) == 1.0);
}

TEST_CASE("the angle between rotations is exact for tiny ones and blind to signs",
          "[core][quaternion]") {
  Rng rng{74};
  for (const double angle : {1e-12, 1e-6, 0.5, 3.0}) {
    const Quaternion a = random_quaternion(rng);
    const Quaternion b = turn_about(support::random_on_sphere(rng), angle) * a;
    CHECK(angle_between(a, b) == Approx(angle).margin(1e-15));
    CHECK(angle_between(a, -b) == Approx(angle).margin(1e-15));
  }
}

TEST_CASE("a small rotation is off by a twelfth of the angle's cube", "[core][quaternion]") {
  const Vec3 axis = normalised(Vec3{1, -2, 3});
  for (const double angle : {1e-6, 1e-3, 0.02}) {
    const double error = angle_between(small_rotation(angle * axis), turn_about(axis, angle));
    CHECK(error == Approx(angle * angle * angle / 12.0).epsilon(1e-3).margin(1e-15));
  }
}
