#include "geometry/earth.hpp"
#include "core/error.hpp"
#include "geometry/scene_helpers.hpp"
#include "support/catch.hpp"

using namespace nadir;
using namespace nadir::geometry;

namespace {
// WGS84, NIMA TR8350.2 (2000), table 3.1.
constexpr double semi_major_m = 6'378'137.0;
constexpr double flattening = 1.0 / 298.257223563;
}  // namespace

TEST_CASE("axis points of the ellipsoid have the published radii") {
  const LocalFrame frame{{0.0, 0.0, 0.0}};
  const Vec3 greenwich = frame.ecef({});
  CHECK(greenwich.x == Approx(semi_major_m).epsilon(1e-15));
  CHECK(std::abs(greenwich.y) + std::abs(greenwich.z) < 1e-9);
  // Semi-minor axis 6356752.3142 m, the same source, printed to 0.1 mm.
  CHECK(LocalFrame{{90.0, 0.0, 0.0}}.ecef({}).z == Approx(6'356'752.3142).margin(5e-5).epsilon(0));
}

TEST_CASE("ECEF follows the closed form of the ellipsoid") {
  const double degree = std::numbers::pi / 180.0;
  const double e2 = flattening * (2.0 - flattening);
  for (const Geodetic place :
       {Geodetic{36.4, -84.3, 300.0}, {-77.85, 166.67, 10.0}, {5.2, -52.8, 7e5}}) {
    const double s = std::sin(place.latitude_deg * degree),
                 c = std::cos(place.latitude_deg * degree);
    const double n = semi_major_m / std::sqrt(1.0 - e2 * s * s);
    const double lon = place.longitude_deg * degree;
    const Vec3 ecef = LocalFrame{place}.ecef({});
    // A few roundings of 7e6 m: 1e-9 m each.
    CHECK(ecef.x == Approx((n + place.height_m) * c * std::cos(lon)).margin(5e-9).epsilon(0));
    CHECK(ecef.y == Approx((n + place.height_m) * c * std::sin(lon)).margin(5e-9).epsilon(0));
    CHECK(ecef.z == Approx((n * (1.0 - e2) + place.height_m) * s).margin(5e-9).epsilon(0));
  }
}

TEST_CASE("ENU, ECEF and geodetic coordinates go round to nanometres") {
  const LocalFrame frame{{43.1, -77.6, 150.0}};
  Rng rng{21};
  for (int i = 0; i < 200; ++i) {
    const Vec3 p = test::random_point(rng, {-5e5, -5e5, -1e3}, {5e5, 5e5, 8e5});
    CHECK(length(frame.enu(frame.geodetic(p)) - p) < 1e-8);  // ulp of 7e6 m is 9e-10 m, some steps
    CHECK(length(frame.enu_from_ecef(frame.ecef(p)) - p) < 5e-9);
  }
  CHECK(length(frame.enu(frame.origin())) < 5e-9);
}

TEST_CASE("the axes at a place are orthonormal, and those of the origin are the scene's") {
  const LocalFrame frame{{43.1, -77.6, 150.0}};
  const Mat3 home = frame.axes_at(frame.origin());
  CHECK(length(home.x - Vec3{1, 0, 0}) < 1e-15);
  CHECK(length(home.y - Vec3{0, 1, 0}) < 1e-15);
  CHECK(length(home.z - Vec3{0, 0, 1}) < 1e-15);
  const Geodetic far{44.0, -75.0, 10.0};
  const Mat3 axes = frame.axes_at(far);
  CHECK(axes.determinant() == Approx(1.0).epsilon(1e-14));
  CHECK(std::abs(dot(axes.x, axes.y)) + std::abs(dot(axes.y, axes.z)) < 1e-15);
  // Up is where the height grows, north where the latitude does: finite differences of 1 m.
  const Vec3 here = frame.enu(far);
  const Vec3 up = frame.enu({far.latitude_deg, far.longitude_deg, far.height_m + 1.0}) - here;
  CHECK(length(up - axes.z) < 1e-8);
  const Vec3 north = frame.enu({far.latitude_deg + 1e-5, far.longitude_deg, far.height_m}) - here;
  CHECK(length(normalised(north) - axes.y) < 1e-6);  // the arc of 1 m turns by 1e-7
}

TEST_CASE("an origin off the earth is refused") {
  CHECK_THROWS_AS((LocalFrame{{90.5, 0.0, 0.0}}), InputError);
  CHECK_THROWS_AS((LocalFrame{{0.0, std::numeric_limits<double>::infinity(), 0.0}}), InputError);
}
