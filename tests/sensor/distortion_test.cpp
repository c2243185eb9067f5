#include "sensor/camera/distortion.hpp"

#include <cmath>

#include "core/error.hpp"
#include "support/catch.hpp"

namespace nadir::sensor {
namespace {

TEST_CASE("radial distortion scales a place by a polynomial of its distance", "[sensor][lens]") {
  const Distortion lens{.k1 = -0.2, .k2 = 0.3, .k3 = -0.5};
  const Vec2 place = distorted(lens, {0.3, 0.4});  // r2 = 0.25
  const double scale = 1.0 - 0.2 * 0.25 + 0.3 * 0.0625 - 0.5 * 0.015625;
  CHECK(place.x == Approx(0.3 * scale).epsilon(1e-15));  // a few roundings
  CHECK(place.y == Approx(0.4 * scale).epsilon(1e-15));
}

TEST_CASE("tangential distortion: p1 bends along y, p2 along x", "[sensor][lens]") {
  // By hand from the definition with x = 0.2, y = 0.1: r2 = 0.05.
  const Vec2 first = distorted({.p1 = 0.01}, {0.2, 0.1});
  CHECK(first.x == Approx(0.2 + 2 * 0.01 * 0.02).epsilon(1e-15));
  CHECK(first.y == Approx(0.1 + 0.01 * (0.05 + 0.02)).epsilon(1e-15));
  const Vec2 second = distorted({.p2 = 0.01}, {0.2, 0.1});
  CHECK(second.x == Approx(0.2 + 0.01 * (0.05 + 0.08)).epsilon(1e-15));
  CHECK(second.y == Approx(0.1 + 2 * 0.01 * 0.02).epsilon(1e-15));
}

TEST_CASE("coefficients come in the order k1, k2, p1, p2, k3", "[sensor][lens]") {
  const Distortion lens{0.1, 0.2, 0.3, 0.4, 0.5};
  CHECK(lens.p1 == 0.3);
  CHECK(lens.k3 == 0.5);
}

TEST_CASE("undistorting undoes distorting to 1e-13", "[sensor][lens]") {
  const Distortion lenses[] = {{},
                               {.k1 = -0.35, .k2 = 0.15, .p1 = 1e-3, .p2 = -5e-4, .k3 = -0.03},
                               {.k1 = 0.2, .k2 = 0.05, .p1 = -4e-3, .p2 = 4e-3, .k3 = 0.01},
                               {.k1 = -0.5},
                               {.p1 = 0.02, .p2 = -0.02}};
  for (const Distortion& lens : lenses) {
    for (double x = -0.5; x <= 0.5; x += 0.125) {
      for (double y = -0.4; y <= 0.4; y += 0.1) {
        const Vec2 back = undistorted(lens, distorted(lens, {x, y}));
        CAPTURE(lens.k1, x, y);
        CHECK(std::hypot(back.x - x, back.y - y) < 1e-13);
      }
    }
  }
}

// r (1 + k1 r^2) with k1 < 0 turns back at r = 1 / sqrt(-3 k1), whose image lies at 2/3 of that.
TEST_CASE("a barrel distortion passes as far as it does not fold, and no farther",
          "[sensor][lens]") {
  const Distortion lens{.k1 = -2.0};
  const double edge = 2.0 / 3.0 / std::sqrt(6.0);
  CHECK_NOTHROW(check(lens, 0.99 * edge));
  CHECK_THROWS_AS(check(lens, 1.01 * edge), InputError);
  CHECK_THROWS_WITH(check(lens, 0.4),
                    "error: the distortion folds the image over itself within its pixels, which "
                    "reach to 0.4 focal lengths from the axis: order of the coefficients? "
                    "(k1, k2, p1, p2, k3)\n");
}

TEST_CASE("distortions of well-built lenses pass", "[sensor][lens]") {
  CHECK_NOTHROW(check({}, 10.0));
  CHECK_NOTHROW(check({.k1 = 0.3, .k2 = 0.1, .k3 = 0.05}, 1.0));
  CHECK_NOTHROW(check({.k1 = -0.1, .k2 = 0.12, .p1 = 1e-4, .p2 = 3e-4, .k3 = -0.04}, 0.55));
}

TEST_CASE("tangential distortion can fold as well, on one side only", "[sensor][lens]") {
  // Along x < 0 the image of p2 turns back where 1 + 6 p2 x = 0: x = -1/1.2, image at half of it.
  CHECK_NOTHROW(check({.p2 = 0.2}, 0.40));
  CHECK_THROWS_AS(check({.p2 = 0.2}, 0.43), InputError);
}

TEST_CASE("beyond the fold the inverse is of no use but finite", "[sensor][lens]") {
  for (double x = 0.0; x < 5.0; x += 0.01) {
    const Vec2 back = undistorted({.k1 = -2.0, .k2 = 0.3}, {x, 0.7 * x});
    CHECK((std::isfinite(back.x) && std::isfinite(back.y)));
  }
}

TEST_CASE("coefficients that are not finite are refused", "[sensor][lens]") {
  CHECK_THROWS_AS(check({.k2 = std::nan("")}, 0.5), InputError);
}

}  // namespace
}  // namespace nadir::sensor
