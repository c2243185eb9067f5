#include "ephemeris/sun_moon.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/constants.hpp"
#include "core/error.hpp"
#include "core/frame.hpp"
#include "support/catch.hpp"

namespace {

using namespace nadir;
using namespace nadir::ephemeris;

const Site equator{0.0, 0.0, 0.0};

struct Geocentric {
  double declination_deg = 0.0, distance_m = 0.0;
};

// On the equator up points away from the centre of the ellipsoid and north along its axis.
Geocentric geocentric(const BodyPosition& body) {
  const Vec3 up{0.0, 0.0, 1.0};
  const Vec3 v = body.distance.value * body.direction_enu + 6'378'137.0 * up;
  return {to_degrees(Angle{std::asin(v.y / length(v))}), length(v)};
}

// Through the day by the hour, and around noon of the prime meridian every two minutes.
double highest_sun_deg(const std::string& day, double latitude_deg) {
  const Instant start = Instant::parse_utc(day + "T00:00:00Z");
  double highest_deg = -90.0;
  for (int minute = 0; minute < 1440; minute += minute >= 710 && minute < 730 ? 2 : 10) {
    if (minute % 60 != 0 && std::abs(minute - 720) > 10) continue;
    const SunAndMoon seen = sun_and_moon(start + Seconds{60.0 * minute}, {latitude_deg, 0.0, 0.0});
    highest_deg = std::max(highest_deg, to_degrees(seen.sun.elevation));
  }
  return highest_deg;
}

}  // namespace

// Meeus, Astronomical Algorithms, 2nd ed., example 47.a: 1992 April 12, 0h TD (TT - UTC = 58.184
// s): apparent declination 13.768368 deg, distance 368409.7 km. 20 arcsec and 20 km as in the
// oracle's test, plus the 0.3 arcsec of the observer's motion.
TEST_CASE("the moon stands where Meeus' example has it", "[ephemeris][sun_moon]") {
  const Instant instant = Instant::parse_utc("1992-04-11T23:59:01.816Z");
  const Geocentric moon = geocentric(sun_and_moon(instant, equator).moon);
  CHECK(moon.declination_deg == Approx(13.768368).epsilon(0).margin(20.0 / 3600.0));
  CHECK(moon.distance_m == Approx(368'409'700.0).epsilon(0).margin(20e3));
}

// Meeus, example 25.b: 1992 October 13, 0h TD (TT - UTC = 59.184 s): the complete VSOP87 theory
// gives the declination -7 deg 47' 01.74" and the distance 0.99760853 au. 1 arcsec covers the
// observer's motion (0.3) and the older nutation; 1e-7 au the example's last digit.
TEST_CASE("the sun stands where Meeus' example has it", "[ephemeris][sun_moon]") {
  const Instant instant = Instant::parse_utc("1992-10-12T23:59:00.816Z");
  const Geocentric sun = geocentric(sun_and_moon(instant, equator).sun);
  const double expected_deg = -(7.0 + 47.0 / 60.0 + 1.74 / 3600.0);
  CHECK(sun.declination_deg == Approx(expected_deg).epsilon(0).margin(1.0 / 3600.0));
  CHECK(sun.distance_m / astro::astronomical_unit_m == Approx(0.99760853).epsilon(0).margin(1e-7));
}

// NASA (F. Espenak): total eclipse of 2024 April 8, greatest at 18:17:18 UT1 over 25 deg 17.4' N,
// 104 deg 08.3' W; magnitude 1.0566, the ratio of the diameters; sun's elevation 69.8 deg.
TEST_CASE("the moon covers the sun in the eclipse of 2024", "[ephemeris][sun_moon]") {
  const Site site{25.0 + 17.4 / 60.0, -(104.0 + 8.3 / 60.0), 0.0};
  const SunAndMoon seen = sun_and_moon(Instant::parse_utc("2024-04-08T18:17:18Z"), site);
  const double separation = length(seen.sun.direction_enu - seen.moon.direction_enu);
  // 3.5 arcsec for a second of rounded time, 6 for the rounded place, 10 for the moon
  CHECK(to_degrees(Angle{separation}) * 3600.0 < 20.0);
  // the canon's lunar radius is the smaller by 4e-4
  CHECK(seen.moon.angular_radius / seen.sun.angular_radius ==
        Approx(1.0566).epsilon(0).margin(0.0015));
  CHECK(to_degrees(seen.sun.elevation) == Approx(69.8).epsilon(0).margin(0.06));
  CHECK(seen.phase.illuminated_fraction < 1e-5);
}

// Declination at the June solstice of 2026: the obliquity of date, 23.436 deg (IAU 2006). The sun
// is sampled every 2 minutes (at most 0.01 deg below its height) and parallax lowers it by 0.0024.
TEST_CASE("the midsummer sun culminates at 90 degrees less |latitude - declination|",
          "[ephemeris][sun_moon]") {
  const double latitude_deg = GENERATE(-35.0, 0.0, 43.1, 60.0);
  const double expected_deg = 90.0 - std::abs(latitude_deg - 23.436);
  CAPTURE(latitude_deg);
  CHECK(highest_sun_deg("2026-06-21", latitude_deg) ==
        Approx(expected_deg).epsilon(0).margin(0.015));
}

TEST_CASE("the sun is south at noon in the north and north in the south", "[ephemeris][sun_moon]") {
  const Instant noon = Instant::parse_utc("2026-04-15T12:00:00Z");  // equation of time 0
  // 0.2 deg of the equation of time, enlarged by the high sun
  CHECK(to_degrees(sun_and_moon(noon, {50.0, 0.0, 0.0}).sun.azimuth) ==
        Approx(180.0).epsilon(0).margin(0.5));
  const Vec3 southern = sun_and_moon(noon, {-50.0, 0.0, 0.0}).sun.direction_enu;
  CHECK(southern.y > 0.5);
  CHECK(std::abs(southern.x) < 0.01);
}

TEST_CASE("the morning sun stands in the east", "[ephemeris][sun_moon]") {
  const Vec3 sun =
      sun_and_moon(Instant::parse_utc("2026-03-20T06:30:00Z"), equator).sun.direction_enu;
  CHECK(sun.x > 0.98);
  CHECK(sun.z > 0.0);
}

TEST_CASE("positions obey their definitions", "[ephemeris][sun_moon]") {
  const std::string day =
      GENERATE(as<std::string>{}, "1905-03-01", "1962-09-09", "2026-06-21", "2099-12-31");
  const SunAndMoon seen =
      sun_and_moon(Instant::parse_utc(day + "T07:30:00Z"), {-33.9, 151.2, 58.0});
  CAPTURE(day);
  for (const BodyPosition& body : {seen.sun, seen.moon}) {
    CHECK(length(body.direction_enu) == Approx(1.0).epsilon(1e-14));
    CHECK(body.azimuth >= 0.0_rad);
    CHECK(body.azimuth < 360.0_deg);
    const Vec3 same = direction_enu(body.azimuth.value, body.elevation.value);
    CHECK(length(same - body.direction_enu) < 1e-14);
    CHECK(body.apparent_elevation == body.elevation + refraction(body.elevation));
  }
  CHECK(std::sin(seen.sun.angular_radius.value) * seen.sun.distance.value ==
        Approx(astro::solar_radius_m).epsilon(1e-12));
  CHECK(std::sin(seen.moon.angular_radius.value) * seen.moon.distance.value ==
        Approx(astro::lunar_radius_m).epsilon(1e-12));
  CHECK(seen.phase.illuminated_fraction ==
        Approx((1.0 + std::cos(seen.phase.phase_angle.value)) / 2.0).epsilon(1e-14));
}

// In the triangle sun - moon - observer the angles add up to pi; the one at the sun is sin(e) d /
// D by the sine rule, the one at the observer is the separation in the sky. 25 arcsec: aberration,
// which shifts the sun and not the moon.
TEST_CASE("phase angle and separation close the triangle", "[ephemeris][sun_moon]") {
  const std::string day = GENERATE(as<std::string>{}, "2026-06-01", "2026-06-08", "2026-06-22");
  const SunAndMoon seen = sun_and_moon(Instant::parse_utc(day + "T00:00:00Z"), equator);
  const double separation = std::acos(dot(seen.sun.direction_enu, seen.moon.direction_enu));
  const double sine = std::sin(seen.phase.phase_angle.value);
  const double at_sun = std::asin(sine * (seen.moon.distance / seen.sun.distance));
  const double sum = separation + seen.phase.phase_angle.value + at_sun;
  CHECK(to_degrees(Angle{sum}) == Approx(180.0).epsilon(0).margin(25.0 / 3600.0));
}

TEST_CASE("the lit fraction of the moon runs from new to full", "[ephemeris][sun_moon]") {
  CHECK(illuminated_fraction(0.0_deg) == 1.0);
  CHECK(illuminated_fraction(90.0_deg) == Approx(0.5).epsilon(1e-14));
  CHECK(illuminated_fraction(180.0_deg) == Approx(0.0).margin(1e-15));
}

TEST_CASE("UT1 - UTC turns the earth by 15 arcsec a second", "[ephemeris][sun_moon]") {
  const std::string time = "2026-03-20T12:00:00Z";  // the sun near the zenith, on the equator
  const Site site{60.0, 0.0, 0.0};
  const Vec3 slow = sun_and_moon(Instant::parse_utc(time), site).sun.direction_enu;
  const Vec3 fast = sun_and_moon(Instant::parse_utc(time, Seconds{0.9}), site).sun.direction_enu;
  // 0.9 s of 15.041 arcsec, at declination 0 to 0.3 deg
  CHECK(to_degrees(Angle{length(fast - slow)}) * 3600.0 == Approx(13.54).epsilon(0).margin(0.01));
}

TEST_CASE("poles and the date line are places like others", "[ephemeris][sun_moon]") {
  const Instant instant = Instant::parse_utc("2026-06-21T16:00:00Z");
  const SunAndMoon pole = sun_and_moon(instant, {90.0, 0.0, 0.0});
  CHECK(is_finite(pole.sun.direction_enu));
  // the declination, less 8.1 arcsec of parallax
  CHECK(to_degrees(pole.sun.elevation) == Approx(23.436).epsilon(0).margin(0.004));
  const Vec3 west = sun_and_moon(instant, {10.0, -90.0, 0.0}).sun.direction_enu;
  const Vec3 east = sun_and_moon(instant, {10.0, 270.0, 0.0}).sun.direction_enu;
  CHECK(length(west - east) < 1e-12);  // rounding of the longitude in radians
}

// Up by h, the moon comes nearer by h sin(elevation), and sinks by the parallax h cos(elevation) /
// d to first order; the next order is h / d = 1e-5 of them. 1 m and 0.01 arcsec are that and the
// motion of the higher site.
TEST_CASE("a higher site is nearer to a moon above it", "[ephemeris][sun_moon]") {
  const Instant instant = Instant::parse_utc("2026-06-21T21:00:00Z");
  constexpr double height_m = 4205.0;
  const Site low{19.8207, -77.0, 0.0}, high{19.8207, -77.0, height_m};
  const BodyPosition from_low = sun_and_moon(instant, low).moon;
  const BodyPosition from_high = sun_and_moon(instant, high).moon;
  CHECK((from_low.distance - from_high.distance).value ==
        Approx(height_m * std::sin(from_low.elevation.value)).epsilon(0).margin(1.0));
  const double sunk = (from_low.elevation - from_high.elevation).value;
  const double parallax = height_m * std::cos(from_low.elevation.value) / from_low.distance.value;
  CHECK(to_degrees(Angle{sunk - parallax}) * 3600.0 == Approx(0.0).margin(0.01));
}

TEST_CASE("the air changes the apparent elevation alone", "[ephemeris][sun_moon]") {
  const Instant instant = Instant::parse_utc("2026-03-20T06:30:00Z");
  const SunAndMoon with = sun_and_moon(instant, equator);
  const SunAndMoon without = sun_and_moon(instant, equator, {.pressure_hpa = 0.0});
  CHECK(without.sun.apparent_elevation == without.sun.elevation);
  CHECK(with.sun.apparent_elevation > with.sun.elevation);
  CHECK(with.sun.direction_enu == without.sun.direction_enu);
}

TEST_CASE("a site outside its ranges is refused with every mistake", "[ephemeris][site]") {
  const Instant instant = Instant::parse_utc("2026-06-21T16:00:00Z");
  CHECK_THROWS_WITH(sun_and_moon(instant, {93.1, 0.0, 0.0}),
                    "error: site latitude is 93.1 deg, allowed range is [-90, 90]\n");
  CHECK_THROWS_WITH(sun_and_moon(instant, {std::nan(""), -180.5, 1e9}),
                    "error: site latitude is nan deg, allowed range is [-90, 90]\n"
                    "error: site longitude is -180.5 deg, allowed range is [-180, 360]\n"
                    "error: site height is 1e+09 m, allowed range is [-12000, 1e+06]\n");
}
