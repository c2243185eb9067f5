#include <cmath>
#include <limits>

#include "core/error.hpp"
#include "geometry/earth.hpp"
#include "support/catch.hpp"
#include "support/floating_point_traps.hpp"

// Scenes where longitude jumps and where it has no meaning.

namespace nadir::geometry {
namespace {

void check_round_trip(const LocalFrame& frame, Vec3 place) {
  const Geodetic there = frame.geodetic(place);
  CHECK(std::abs(there.latitude_deg) <= 90.0);
  CHECK(std::abs(there.longitude_deg) <= 180.0);
  const Vec3 back = frame.enu(there);
  CAPTURE(place.x, place.y, place.z, there.latitude_deg, there.longitude_deg);
  // Nanometres of GeographicLib and of 6.4e6 m in doubles; degrees near 180 hold 3e-14: 3 nm.
  CHECK(length(back - place) < 2e-8 * std::max(1.0, length(place) / 1e6));
}

TEST_CASE("places go to latitude and longitude and back at the date line and at the poles",
          "[hard][earth]") {
  for (const double latitude : {-90.0, -89.9999999, 0.0, 65.0, 90.0}) {
    for (const double longitude : {-180.0, -179.9999999, 0.0, 179.9999999, 180.0, 359.0}) {
      const LocalFrame frame{{latitude, longitude, 100.0}};
      for (const Vec3 place : {Vec3{}, Vec3{1000.0, 0.0, 0.0}, Vec3{-1000.0, 1000.0, 5.0},
                               Vec3{0.0, -1e5, 36e6}, Vec3{1e-3, 1e-3, 0.0}}) {
        check_round_trip(frame, place);
      }
    }
  }
}

TEST_CASE("across the date line neighbours stay neighbours: 1 m east is 1 m east",
          "[hard][earth]") {
  const LocalFrame frame{{10.0, 180.0, 0.0}};
  const Geodetic west = frame.geodetic({-1.0, 0.0, 0.0}), east = frame.geodetic({1.0, 0.0, 0.0});
  CHECK(west.longitude_deg > 179.9);
  CHECK(east.longitude_deg < -179.9);
  CHECK(length(frame.enu(east) - frame.enu(west)) == Approx(2.0).epsilon(1e-7));
  // The same place under three of its names.
  for (const double name : {-540.0, -180.0, 180.0, 540.0}) {
    CHECK(length(frame.enu({10.0, name, 0.0})) < 1e-8);
  }
}

TEST_CASE("axes are orthonormal and right-handed everywhere, at the poles too", "[hard][earth]") {
  const LocalFrame frame{{90.0, 0.0, 0.0}};
  for (const Geodetic& place : {Geodetic{90.0, 0.0, 0.0}, Geodetic{90.0, 77.0, 0.0},
                                Geodetic{-90.0, 180.0, 0.0}, Geodetic{0.0, -180.0, 1e7}}) {
    const Mat3 axes = frame.axes_at(place);
    CHECK(length(cross(axes.x, axes.y) - axes.z) < 1e-14);
    CHECK(axes.determinant() == Approx(1.0).epsilon(1e-14));
  }
}

TEST_CASE("the middle of the earth and a place light-years away have a latitude", "[hard][earth]") {
  const LocalFrame frame{{0.0, 0.0, 0.0}};
  const Geodetic middle = frame.geodetic({0.0, 0.0, -6378137.0});
  CHECK(std::isfinite(middle.latitude_deg));
  CHECK(std::isfinite(middle.longitude_deg));
  const Geodetic far = frame.geodetic({0.0, 0.0, 1e18});
  CHECK(far.latitude_deg == Approx(0.0).margin(1e-9));
  CHECK(far.height_m == Approx(1e18).epsilon(1e-12));
}

TEST_CASE("an origin that is no place is refused", "[hard][earth]") {
  const double nothing = std::nan(""), infinite = std::numeric_limits<double>::infinity();
  const support::WithoutTraps compares_nan;
  CHECK_THROWS_AS((LocalFrame{{90.00001, 0.0, 0.0}}), InputError);
  CHECK_THROWS_AS((LocalFrame{{nothing, 0.0, 0.0}}), InputError);
  CHECK_THROWS_AS((LocalFrame{{0.0, nothing, 0.0}}), InputError);
  CHECK_THROWS_AS((LocalFrame{{0.0, infinite, 0.0}}), InputError);
  CHECK_THROWS_AS((LocalFrame{{0.0, 0.0, infinite}}), InputError);
}

}  // namespace
}  // namespace nadir::geometry
