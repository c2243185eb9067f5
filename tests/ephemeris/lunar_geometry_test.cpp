#include "ephemeris/lunar_geometry.hpp"

#include <algorithm>
#include <cmath>

#include "core/constants.hpp"
#include "ephemeris/sun_moon.hpp"
#include "support/catch.hpp"

namespace {

using namespace nadir;
using namespace nadir::ephemeris;

LunarGeometry seen_from(const char* utc, const Site& site) {
  return sun_and_moon(Instant::parse_utc(utc), site).lunar;
}

}  // namespace

// Meeus, Astronomical Algorithms, 2nd ed., example 53.a: 1992 April 12, 0h TD: optical and physical
// libration of the geocentric moon l = -1.23, b = 4.20 degrees; the sun over l0 = 67.89, b0 = 1.46.
// Seen from the sublunar point, which the earth's centre sees in the same place. The example's
// figures have 0.01, its series for the physical libration as much.
TEST_CASE("libration is that of Meeus' example", "[ephemeris][lunar]") {
  const char* utc = "1992-04-11T23:59:01.816Z";
  Site site{13.77, 0.0, 0.0};
  double highest = -2.0;
  for (double longitude = -75.0; longitude < -55.0; longitude += 0.25) {
    const Site here{13.77, longitude, 0.0};
    const double height = sun_and_moon(Instant::parse_utc(utc), here).moon.direction_enu.z;
    if (height > highest) site = here;
    highest = std::max(highest, height);
  }
  REQUIRE(highest > 0.99999);
  const LunarGeometry moon = seen_from(utc, site);
  CHECK(to_degrees(moon.observer.longitude) == Approx(-1.23).epsilon(0).margin(0.03));
  CHECK(to_degrees(moon.observer.latitude) == Approx(4.20).epsilon(0).margin(0.03));
  CHECK(to_degrees(moon.sun.longitude) == Approx(67.89).epsilon(0).margin(0.03));
  CHECK(to_degrees(moon.sun.latitude) == Approx(1.46).epsilon(0).margin(0.03));
}

TEST_CASE("the phase angle is the arc between the points under sun and observer",
          "[ephemeris][lunar]") {
  for (const char* utc : {"1962-03-01T05:00:00Z", "2026-06-08T00:00:00Z", "2099-12-30T18:00:00Z"}) {
    const LunarGeometry moon = seen_from(utc, {51.0, 13.0, 100.0});
    const double a = moon.sun.latitude.value, b = moon.observer.latitude.value;
    const double apart = (moon.sun.longitude - moon.observer.longitude).value;
    const double cosine = std::sin(a) * std::sin(b) + std::cos(a) * std::cos(b) * std::cos(apart);
    CHECK(cosine == Approx(std::cos(moon.phase.value)).epsilon(0).margin(1e-12));
  }
}

// The moon turns its face: libration stays within 8.0 and 6.9 degrees (Meeus, ch. 53), with a
// degree of parallax more; the sun stays within 1.6 degrees of the moon's equator.
TEST_CASE("libration stays within its bounds", "[ephemeris][lunar]") {
  const Instant start = Instant::parse_utc("2000-01-01T00:00:00Z");
  double widest = 0.0, highest = 0.0;
  for (int i = 0; i < 200; ++i) {
    const Instant instant = start + Seconds{86400.0 * 8.7 * i};
    const LunarGeometry moon = sun_and_moon(instant, {0.0, 10.0, 0.0}).lunar;
    widest = std::max(widest, std::abs(to_degrees(moon.observer.longitude)));
    highest = std::max(highest, std::abs(to_degrees(moon.observer.latitude)));
    CHECK(std::abs(to_degrees(moon.sun.latitude)) < 1.62);
  }
  CHECK(widest > 6.0);
  CHECK(widest < 9.0);
  CHECK(highest > 6.0);
  CHECK(highest < 7.9);
}

// First quarter 2026-06-21 21:55 UT, last quarter 2026-06-08 10:00 UT (USNO).
TEST_CASE("the sun stands in the moon's east while it waxes", "[ephemeris][lunar]") {
  const LunarGeometry waxing = seen_from("2026-06-21T21:55:00Z", {0.0, 0.0, 0.0});
  const LunarGeometry waning = seen_from("2026-06-08T10:00:00Z", {0.0, 0.0, 0.0});
  CHECK(to_degrees(waxing.sun.longitude) == Approx(90.0).epsilon(0).margin(9.0));
  CHECK(to_degrees(waning.sun.longitude) == Approx(-90.0).epsilon(0).margin(9.0));
}

TEST_CASE("the moon's distances are those of the triangle", "[ephemeris][lunar]") {
  const SunAndMoon seen =
      sun_and_moon(Instant::parse_utc("2026-06-08T00:00:00Z"), {51.0, 13.0, 0.0});
  CHECK(seen.lunar.observer_distance.value == Approx(seen.moon.distance.value).epsilon(1e-12));
  const double a = seen.lunar.sun_distance.value, b = seen.lunar.observer_distance.value;
  const double c = std::sqrt(a * a + b * b - 2.0 * a * b * std::cos(seen.lunar.phase.value));
  CHECK(c == Approx(seen.sun.distance.value).epsilon(1e-10));
}
