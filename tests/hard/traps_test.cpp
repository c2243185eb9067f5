#include <cmath>
#include <limits>

#include "hard/hard_case.hpp"
#include "support/floating_point_traps.hpp"

// What the suite's traps see, and what they leave alone.

namespace nadir::radiometry::test {
namespace {

TEST_CASE("the suite runs with traps, before and after Embree, wherever traps can be trusted",
          "[hard][traps]") {
  CHECK(support::floating_point_is_trapped() == support::traps_are_honest());
  SmallScene scene;
  scene.add(geometry::Sphere{{0.0, 0.0, 0.0}, 1.0}, scene.material(grey(0.5), 300.0_K));
  const SceneDescription built = scene.build();
  CHECK(built.geometry.intersect(downward()).has_value());
  // Along an axis, where the reciprocal of two components is infinite, and past everything.
  CHECK_FALSE(built.geometry.occluded({{5.0, 0.0, 10.0}, {0.0, 0.0, -1.0}}));
  CHECK(support::floating_point_is_trapped() == support::traps_are_honest());
}

// Hidden: run by name, and expected to die by SIGFPE.
TEST_CASE("planted: a ray of NaN met by a shape", "[.planted]") {
  SmallScene scene;
  scene.add(geometry::Sphere{{0.0, 0.0, 0.0}, 1.0}, scene.material(grey(0.5), 300.0_K));
  const SceneDescription built = scene.build();
  const double nothing = std::numeric_limits<double>::quiet_NaN();
  CHECK_FALSE(built.geometry.intersect({{0.0, 0.0, 10.0}, {nothing, 0.0, -1.0}}).has_value());
}
TEST_CASE("planted: zero divided by zero", "[.planted]") {
  volatile double zero = 0.0;
  volatile double ratio = zero / zero;
  CHECK(std::isnan(ratio));
}

}  // namespace
}  // namespace nadir::radiometry::test
