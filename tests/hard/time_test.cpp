#include <cmath>
#include <numbers>
#include <string>

#include "core/error.hpp"
#include "ephemeris/instant.hpp"
#include "ephemeris/rise_set.hpp"
#include "ephemeris/sun_moon.hpp"
#include "support/catch.hpp"
#include "support/floating_point_traps.hpp"

// Sun and moon where clocks and coordinates are at their ends: poles, leap seconds, 1900 and 2100.

namespace nadir::ephemeris {
namespace {

constexpr double time_pi = std::numbers::pi;

Instant utc(const std::string& text) { return Instant::parse_utc(text); }

/// The angle between two places in the sky as the same observer sees them.
double apart_rad(Vec3 a, Vec3 b) { return 2.0 * std::asin(0.5 * length(a - b)); }

void check_sane_time(const BodyPosition& body) {
  CHECK(body.azimuth.value >= 0.0);
  CHECK(body.azimuth.value < 2.0 * time_pi);
  CHECK(std::abs(body.elevation.value) <= time_pi / 2);
  CHECK(std::isfinite(body.apparent_elevation.value));
  CHECK(body.angular_radius.value > 0.0);
  CHECK(length(body.direction_enu) == Approx(1.0).epsilon(1e-14));
}

TEST_CASE("at a pole every meridian sees the same sky, turned by its longitude", "[hard][time]") {
  const double latitude_deg = GENERATE(90.0, -90.0);
  const Instant now = utc("2024-06-21T10:12:13Z");
  const SunAndMoon at_zero = sun_and_moon(now, {latitude_deg, 0.0, 0.0});
  for (const double longitude_deg : {-180.0, -90.0, 1e-9, 45.0, 180.0, 360.0}) {
    const SunAndMoon there = sun_and_moon(now, {latitude_deg, longitude_deg, 0.0});
    const auto check_turned = [&](const BodyPosition& a, const BodyPosition& b) {
      check_sane_time(b);
      CHECK(b.elevation.value == Approx(a.elevation.value).margin(1e-12));
      // Azimuths count with the meridian at the north pole, against it at the south pole.
      const double sign = latitude_deg > 0.0 ? 1.0 : -1.0;
      const double turned = a.azimuth.value + sign * degrees(longitude_deg).value;
      CAPTURE(longitude_deg);
      CHECK(std::remainder(b.azimuth.value - turned, 2.0 * time_pi) == Approx(0.0).margin(1e-10));
    };
    check_turned(at_zero.sun, there.sun);
    check_turned(at_zero.moon, there.moon);
  }
}

TEST_CASE("the step from 1 mm beside a pole to the pole moves sun and moon by nothing",
          "[hard][time]") {
  const Instant now = utc("2024-03-20T03:06:00Z");  // the sun on the horizon
  const SunAndMoon pole = sun_and_moon(now, {90.0, 30.0, 0.0});
  const SunAndMoon beside = sun_and_moon(now, {90.0 - 9e-9, 30.0, 0.0});
  CHECK(apart_rad(pole.sun.direction_enu, beside.sun.direction_enu) < 1e-9);  // 9e-9 deg: 1.6e-10
  CHECK(apart_rad(pole.moon.direction_enu, beside.moon.direction_enu) < 1e-9);
}

TEST_CASE("a polar day has no rise or set, and the pole's equinox has one crossing or none",
          "[hard][time]") {
  const Site pole{90.0, 0.0, 0.0};
  CHECK(SkyDay{utc("2024-06-21T00:00:00Z"), pole}.rise_and_set(SkyBody::sun).always_above());
  CHECK(SkyDay{utc("2024-12-21T00:00:00Z"), pole}.rise_and_set(SkyBody::sun).always_below());
  int crossings = 0;
  for (int day = 10; day < 30; ++day) {
    const std::string date = "2024-03-" + std::to_string(day) + "T00:00:00Z";
    const Crossings of_day = SkyDay{utc(date), pole}.rise_and_set(SkyBody::sun);
    for (const Crossing& one : of_day.events) CHECK(one.rises);
    crossings += static_cast<int>(of_day.events.size());
  }
  CHECK(crossings == 1);  // the sun rises once a year
}

TEST_CASE("a leap second is a second: elapsed time runs through 23:59:60", "[hard][time]") {
  const std::string day = GENERATE("1972-06-30", "2015-06-30", "2016-12-31");
  const Instant before = utc(day + "T23:59:59Z"), within = utc(day + "T23:59:60Z"),
                late = utc(day + "T23:59:60.999999999Z");
  const Instant after = within + Seconds{1.0};
  CHECK((within - before).value == Approx(1.0).margin(1e-9));
  CHECK((late - before).value == Approx(2.0).margin(2e-9));
  CHECK(within.to_string() == day + "T23:59:60Z");
  CHECK((before + Seconds{1.0}).to_string() == within.to_string());
  CHECK((before + Seconds{1.5}).to_string() == day + "T23:59:60.5Z");
  CHECK(after.to_string().substr(10) == "T00:00:00Z");
  CHECK((after - before).value == Approx(2.0).margin(1e-9));
}

TEST_CASE("23:59:60 is refused on a day that has no leap second", "[hard][time]") {
  for (const char* text : {"2016-06-30T23:59:60Z", "2023-12-31T23:59:60Z", "1950-12-31T23:59:60Z",
                           "2016-12-31T22:59:60Z", "2016-12-31T23:59:61Z"}) {
    CAPTURE(text);
    CHECK_THROWS_AS(Instant::parse_utc(text), InputError);
  }
}

TEST_CASE("the sun does not jump at a leap second where UT1 - UTC is given on either side",
          "[hard][time]") {
  // IERS Bulletin D 128 and 129: -0.4 s before 2017, +0.6 s from then on (to 0.1 s).
  const Site site{0.0, 0.0, 0.0};
  const auto sun = [&](const char* text, double ut1_utc) {
    return sun_and_moon(Instant::parse_utc(text, Seconds{ut1_utc}), site).sun.direction_enu;
  };
  const Vec3 at_58 = sun("2016-12-31T23:59:58Z", -0.4), at_59 = sun("2016-12-31T23:59:59Z", -0.4),
             at_60 = sun("2016-12-31T23:59:60Z", -0.4), at_0 = sun("2017-01-01T00:00:00Z", 0.6),
             at_1 = sun("2017-01-01T00:00:01Z", 0.6);
  const double second = apart_rad(at_58, at_59);
  CHECK(second == Approx(2.0 * time_pi / 86400.0).epsilon(0.1));  // 15 arcsec times the cosine
  // Aberration and proper motion change by 1e-6 of it from one second to the next.
  CHECK(apart_rad(at_59, at_60) == Approx(second).epsilon(1e-4));
  CHECK(apart_rad(at_60, at_0) == Approx(second).epsilon(1e-4));
  CHECK(apart_rad(at_0, at_1) == Approx(second).epsilon(1e-4));
}

TEST_CASE("the first and last second of 1900 to 2100 have a sun, those beyond are refused",
          "[hard][time]") {
  const Site site{-33.0, 151.0, 10.0};
  for (const char* text :
       {"1900-01-01T00:00:00Z", "1959-12-31T23:59:59.999999999Z", "1960-01-01T00:00:00Z",
        "2100-02-28T23:59:59Z", "2100-12-31T23:59:59Z"}) {
    CAPTURE(text);
    const SunAndMoon seen = sun_and_moon(utc(text), site);
    check_sane_time(seen.sun);
    check_sane_time(seen.moon);
    CHECK(seen.sun.distance.value == Approx(1.496e11).epsilon(0.018));
    CHECK(seen.moon.distance.value == Approx(384.4e6).epsilon(0.08));
  }
  for (const char* text : {"1899-12-31T23:59:59Z", "2101-01-01T00:00:00Z", "2100-02-29T00:00:00Z",
                           "1900-02-29T00:00:00Z", "0000-01-01T00:00:00Z"}) {
    CAPTURE(text);
    CHECK_THROWS_AS(Instant::parse_utc(text), InputError);
  }
  CHECK_THROWS_AS(utc("2100-12-31T23:59:59Z") + Seconds{2.0}, InputError);
  CHECK_THROWS_AS(utc("1900-01-01T00:00:00Z") - Seconds{1.0}, InputError);
  CHECK_THROWS_AS(utc("2000-01-01T00:00:00Z") + Seconds{1e300}, InputError);
}

TEST_CASE("the scale of time before UTC joins that after it without a step in the sky",
          "[hard][time]") {
  const Site site{50.0, 15.0, 0.0};
  const Vec3 before = sun_and_moon(utc("1959-12-31T23:59:59Z"), site).sun.direction_enu;
  const Vec3 after = sun_and_moon(utc("1960-01-01T00:00:00Z"), site).sun.direction_enu;
  // A second of rotation is 7.3e-5 rad; UT1 - UTC, unknown here, was below 0.1 s.
  CHECK(apart_rad(before, after) == Approx(7.27e-5 * 0.92).epsilon(0.1));
  CHECK_FALSE(utc("2000-01-01T00:00:00Z").caution().has_value());
  CHECK(utc("2100-01-01T00:00:00Z").caution().has_value());
}

TEST_CASE("sites that are not on the earth are refused by name", "[hard][time]") {
  const double nothing = std::nan("");
  const support::WithoutTraps compares_nan;
  for (const Site& site : {Site{90.0000001, 0.0, 0.0}, Site{0.0, 361.0, 0.0}, Site{0.0, 0.0, 2e6},
                           Site{nothing, 0.0, 0.0}, Site{0.0, nothing, 0.0}}) {
    CHECK_THROWS_AS(checked(site), InputError);
  }
}

}  // namespace
}  // namespace nadir::ephemeris
