#include "core/frame.hpp"

#include <numbers>
#include <vector>

#include "core/random.hpp"
#include "support/catch.hpp"
#include "support/directions.hpp"

using namespace nadir;

namespace {

std::vector<Vec3> unit_vectors() {
  // The poles, the equator with either zero as z, and the neighbourhood of the lower pole, where
  // older constructions divide by nearly 0.
  std::vector<Vec3> z = {{0, 0, 1},
                         {0, 0, -1},
                         {1, 0, 0},
                         {-1, 0, 0},
                         {0, 1, 0},
                         {1, 0, -0.0},
                         {0, -1, -0.0},
                         normalised({1e-9, 0, -1}),
                         normalised({-1e-5, 1e-5, -1}),
                         normalised({1e-160, 1e-160, -1})};
  Rng rng{21};
  for (int i = 0; i < 200; ++i) z.push_back(support::random_on_sphere(rng));
  return z;
}

}  // namespace

// Tolerance: a few roundings of numbers below 1 (2.2e-16 each).
TEST_CASE("axes about any unit vector are orthonormal and right-handed", "[core][frame]") {
  for (const Vec3 z : unit_vectors()) {
    const Frame f = frame_about(z);
    CAPTURE(z.x, z.y, z.z);
    CHECK(f.z == z);
    CHECK(dot(f.x, f.x) == Approx(1.0).epsilon(2e-15));
    CHECK(dot(f.y, f.y) == Approx(1.0).epsilon(2e-15));
    CHECK(std::abs(dot(f.x, f.y)) < 2e-15);
    CHECK(std::abs(dot(f.x, z)) < 2e-15);
    CHECK(std::abs(dot(f.y, z)) < 2e-15);
    CHECK(length(cross(f.x, f.y) - z) < 2e-15);
  }
}

TEST_CASE("a vector survives the way into a frame and back", "[core][frame]") {
  const Vec3 v{0.3, -2.0, 5.0};
  for (const Vec3 z : unit_vectors()) {
    const Frame f = frame_about(z);
    CHECK(length(f.to_world(f.to_local(v)) - v) < 1e-14);  // of a length of 5.4
    CHECK(f.to_local(v).z == Approx(dot(v, z)).margin(1e-15));
  }
  CHECK(Frame{}.to_local(v) == v);
}

TEST_CASE("azimuth runs from north to east, elevation from the horizon up", "[core][frame]") {
  const double quarter = std::numbers::pi / 2.0;
  CHECK(length(direction_enu(0.0, 0.0) - Vec3{0, 1, 0}) < 1e-15);
  CHECK(length(direction_enu(quarter, 0.0) - Vec3{1, 0, 0}) < 1e-15);
  CHECK(length(direction_enu(2.0 * quarter, 0.0) - Vec3{0, -1, 0}) < 1e-15);
  CHECK(length(direction_enu(1.0, quarter) - Vec3{0, 0, 1}) < 1e-15);
  const Vec3 d = direction_enu(4.0, 0.7);
  CHECK(std::atan2(d.x, d.y) + 4.0 * quarter == Approx(4.0).epsilon(1e-15));
  CHECK(std::asin(d.z) == Approx(0.7).epsilon(1e-15));
}
