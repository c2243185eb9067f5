#include "ephemeris/rise_set.hpp"

#include <cmath>
#include <string>

#include "core/error.hpp"
#include "support/catch.hpp"

namespace {

using namespace nadir;
using namespace nadir::ephemeris;

SkyDay day_at(const std::string& utc, double latitude_deg, double longitude_deg = 0.0) {
  return SkyDay{Instant::parse_utc(utc), {latitude_deg, longitude_deg, 0.0}};
}

double hours(const Crossings& seen, std::size_t i, const std::string& utc) {
  return (seen.events.at(i).time - Instant::parse_utc(utc)).value / 3600.0;
}

}  // namespace

// Refraction and radius let the sun rise before its centre's 0 and make the equinox day longer: by
// 2 x 50 arcmin / (15 degrees an hour cos latitude).
TEST_CASE("the equinox day is longer than the night by refraction and radius",
          "[ephemeris][rise_set]") {
  const std::string utc = "2026-03-20T00:00:00Z";
  const double latitude_deg = GENERATE(0.0, 40.0);
  const SkyDay day = day_at(utc, latitude_deg);
  const Crossings sun = day.rise_and_set(SkyBody::sun);
  REQUIRE(sun.events.size() == 2);
  CHECK(sun.events[0].rises);
  CHECK_FALSE(sun.events[1].rises);
  const double longer = 2.0 * (50.0 / 60.0) / (15.0 * std::cos(degrees(latitude_deg).value));
  // declination +-0.1 degrees: 0.7 minutes at 40 degrees
  CHECK(hours(sun, 1, utc) - hours(sun, 0, utc) == Approx(12.0 + longer).epsilon(0).margin(0.015));
  CHECK(to_degrees(sun.events[0].azimuth) == Approx(90.0).epsilon(0).margin(1.2));
  CHECK(to_degrees(sun.events[1].azimuth) == Approx(270.0).epsilon(0).margin(1.2));
}

// The definitions: at the event the limb stands where it should.
TEST_CASE("at an event the body stands at the horizon", "[ephemeris][rise_set]") {
  const Site site{51.5, -0.1, 20.0};
  const SkyDay day{Instant::parse_utc("2026-01-05T00:00:00Z"), site};
  for (const Crossing& event : day.rise_and_set(SkyBody::sun).events) {
    const BodyPosition sun = sun_and_moon(event.time, site).sun;
    CHECK(to_degrees(sun.elevation) == Approx(-50.0 / 60.0).epsilon(0).margin(1e-4));
    CHECK(sun.azimuth.value == Approx(event.azimuth.value).epsilon(0).margin(1e-6));
  }
  for (const Crossing& event : day.rise_and_set(SkyBody::moon).events) {
    const BodyPosition moon = sun_and_moon(event.time, site).moon;
    CHECK(to_degrees(moon.elevation + moon.angular_radius) ==
          Approx(-34.0 / 60.0).epsilon(0).margin(1e-4));
  }
  const Crossings civil = day.sun_through(degrees(civil_twilight_deg));
  REQUIRE(civil.events.size() == 2);
  CHECK(to_degrees(sun_and_moon(civil.events[0].time, site).sun.elevation) ==
        Approx(-6.0).epsilon(0).margin(1e-4));
  CHECK(civil.events[0].time - day.rise_and_set(SkyBody::sun).events[0].time < Seconds{0.0});
}

TEST_CASE("transit is where the body stands highest and due south or north",
          "[ephemeris][rise_set]") {
  const Site site{43.0, 5.0, 0.0};
  const SkyDay day{Instant::parse_utc("2026-06-21T00:00:00Z"), site};
  for (const SkyBody body : {SkyBody::sun, SkyBody::moon}) {
    const auto transits = day.transits(body);
    REQUIRE(transits.size() == 1);
    const SunAndMoon there = sun_and_moon(transits[0].time, site);
    const BodyPosition& seen = body == SkyBody::sun ? there.sun : there.moon;
    CHECK(std::abs(seen.direction_enu.x) < 1e-5);
    CHECK(seen.elevation.value == Approx(transits[0].elevation.value).epsilon(0).margin(1e-6));
  }
  // below the horizon there is a transit too: the polar night's noon
  const auto noon = day_at("2026-12-21T00:00:00Z", 75.0).transits(SkyBody::sun);
  REQUIRE(noon.size() == 1);
  CHECK(to_degrees(noon[0].elevation) == Approx(15.0 - 23.436).epsilon(0).margin(0.01));
}

TEST_CASE("at the poles the sun is up or down all day", "[ephemeris][rise_set]") {
  const double pole = GENERATE(90.0, 89.9, -89.9, -90.0);
  const Crossings june = day_at("2026-06-21T00:00:00Z", pole).rise_and_set(SkyBody::sun);
  const Crossings december = day_at("2026-12-21T00:00:00Z", pole).rise_and_set(SkyBody::sun);
  CHECK(june.always_above() == (pole > 0.0));
  CHECK(june.always_below() == (pole < 0.0));
  CHECK(december.always_above() == (pole < 0.0));
  CHECK(december.always_below() == (pole > 0.0));
}

// The sun's 50 arcmin and 0.4 degrees a day: it rises on the north pole some two days before the
// equinox (2026-03-20 14:46 UTC), for half a year.
TEST_CASE("on the north pole the sun rises once, before the equinox", "[ephemeris][rise_set]") {
  const std::string utc = "2026-03-18T00:00:00Z";
  const SkyDay day = day_at(utc, 90.0);
  const Crossings sun = day.rise_and_set(SkyBody::sun);
  REQUIRE(sun.events.size() == 1);
  CHECK(sun.events[0].rises);
  // 50 arcmin at 0.988 arcmin an hour: 50.6 h before, and 9 arcsec of parallax later
  CHECK(hours(sun, 0, utc) == Approx(62.77 - 50.6).epsilon(0).margin(0.4));
}

// The moon rises 50 minutes later each day: once a month a day has no rise, and in the far north it
// may rise, or set, twice. Whatever happens, rises and sets alternate and the day's ends tell
// which.
TEST_CASE("events alternate and lead from the day's start to its end", "[ephemeris][rise_set]") {
  int without_rise = 0;
  for (int i = 0; i < 30; i += 7) {
    const Instant start = Instant::parse_utc("2026-02-01T00:00:00Z") + Seconds{86400.0 * i};
    for (const double latitude_deg : {-66.0, 0.0, 66.5}) {
      CAPTURE(i, latitude_deg);
      const Site site{latitude_deg, 30.0, 0.0};
      const SkyDay day{start, site};
      const Crossings moon = day.rise_and_set(SkyBody::moon);
      bool above = moon.above_at_start;
      int rises = 0;
      for (const Crossing& event : moon.events) {
        CHECK(event.rises != above);
        above = event.rises;
        rises += event.rises ? 1 : 0;
        CHECK(event.time - start >= Seconds{0.0});
        CHECK(event.time - start <= Seconds{86400.0});
      }
      const BodyPosition last = sun_and_moon(start + Seconds{86400.0}, site).moon;
      CHECK(above == ((last.elevation + last.angular_radius).value > degrees(-34.0 / 60.0).value));
      without_rise += rises == 0 ? 1 : 0;
    }
  }
  CHECK(without_rise > 0);
}

// The sun's lowest on midsummer night at latitude 65.75 is near -50 arcmin: within tenths of a
// degree of latitude it goes from two events to none, passing nights of a few minutes.
TEST_CASE("a sun that dips under the horizon for minutes is caught", "[ephemeris][rise_set]") {
  int shortest_min = 1440, nights = 0;
  for (double latitude_deg = 65.70; latitude_deg < 65.76; latitude_deg += 0.01) {
    const Crossings sun = day_at("2026-06-20T12:00:00Z", latitude_deg).rise_and_set(SkyBody::sun);
    if (sun.events.empty()) continue;
    REQUIRE(sun.events.size() == 2);
    CHECK_FALSE(sun.events[0].rises);
    ++nights;
    const double night_s = (sun.events[1].time - sun.events[0].time).value;
    shortest_min = std::min(shortest_min, static_cast<int>(night_s / 60.0));
  }
  CHECK(nights > 0);
  CHECK(shortest_min < 35);
}

TEST_CASE("a day beyond the ephemeris or a site off the earth is refused",
          "[ephemeris][rise_set]") {
  CHECK_THROWS_AS(day_at("2100-12-31T12:00:00Z", 0.0), InputError);
  CHECK_THROWS_AS(day_at("2026-03-20T00:00:00Z", 91.0), InputError);
}
