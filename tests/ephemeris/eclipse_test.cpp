#include "ephemeris/eclipse.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "support/catch.hpp"

namespace {

using namespace nadir;
using namespace nadir::ephemeris;

constexpr Angle sun = degrees(0.2666);

VisibleShare left_by(double cover, double separation) {
  return visible_share({sun, cover * sun, separation * sun});
}

// By brute force: the disc in squares, their middles counted.
VisibleShare counted(double cover, double separation) {
  constexpr int n = 400;
  VisibleShare seen{0.0, 0.0}, all{0.0, 0.0};
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      const double x = (2.0 * i + 1.0) / n - 1.0, y = (2.0 * j + 1.0) / n - 1.0;
      const double r2 = x * x + y * y;
      if (r2 >= 1.0) continue;
      const bool free = std::hypot(x - separation, y) > cover;
      const double cosine = std::sqrt(1.0 - r2);
      all.area += 1.0;
      all.by_cosine += cosine;
      seen.area += free ? 1.0 : 0.0;
      seen.by_cosine += free ? cosine : 0.0;
    }
  }
  return {seen.area / all.area, seen.by_cosine / all.by_cosine};
}

Eclipse solar_at(const std::string& utc, double latitude_deg, double longitude_deg,
                 double later_s = 0.0) {
  const Instant instant = Instant::parse_utc(utc) + Seconds{later_s};
  return solar_eclipse(sun_and_moon(instant, {latitude_deg, longitude_deg, 0.0}));
}

struct Circumstances {
  double magnitude = 0.0, obscuration = 0.0, central_s = 0.0;
};

// Every 4 s through 8 minutes about a published time; how long one disc lies within the other, to
// about 4 s.
Circumstances local(const std::string& utc, double latitude_deg, double longitude_deg) {
  Circumstances most;
  constexpr double step_s = 4.0;
  for (double t = -240.0; t <= 240.0; t += step_s) {
    const Eclipse eclipse = solar_at(utc, latitude_deg, longitude_deg, t);
    most.magnitude = std::max(most.magnitude, eclipse.magnitude);
    most.obscuration = std::max(most.obscuration, 1.0 - eclipse.sunlight.area);
    if (eclipse.sunlight.area == 0.0) most.central_s += step_s;
  }
  return most;
}

Eclipse lunar_at(const std::string& utc) {
  return lunar_eclipse(earth_shadow(Instant::parse_utc(utc)));
}

}  // namespace

TEST_CASE("discs that do not overlap cover nothing, a large one before a small one all",
          "[ephemeris][eclipse]") {
  CHECK(left_by(1.0, 2.0).area == 1.0);
  CHECK(left_by(1.0, 2.0).by_cosine == 1.0);
  CHECK(left_by(1.03, 0.02).area == 0.0);
  CHECK(left_by(1.03, 0.02).by_cosine == 0.0);
}

// A disc of radius m in the middle covers m^2 of the area and 1 - (1 - m^2)^1.5 of the cosine's
// share.
TEST_CASE("a small disc in the middle leaves a ring of known light", "[ephemeris][eclipse]") {
  const double m = GENERATE(0.3, 0.95, 0.999);
  CHECK(left_by(m, 0.0).area == Approx(1.0 - m * m).epsilon(1e-12));
  CHECK(left_by(m, 0.0).by_cosine == Approx(std::pow(1.0 - m * m, 1.5)).epsilon(1e-10));
}

// Two equal circles through each other's middle share 2 pi / 3 - sqrt(3) / 2 of the unit disc.
TEST_CASE("equal discs half a diameter apart share the textbook's lens", "[ephemeris][eclipse]") {
  const double lens = 2.0 * std::numbers::pi / 3.0 - std::sqrt(3.0) / 2.0;
  CHECK(left_by(1.0, 1.0).area == Approx(1.0 - lens / std::numbers::pi).epsilon(1e-12));
}

TEST_CASE("what discs leave free is what counting finds", "[ephemeris][eclipse]") {
  const double cover = GENERATE(0.94, 1.05, 3.6);
  for (const double part : {0.1, 0.5, 0.9}) {
    const double nearest = std::abs(cover - 1.0);
    const double separation = nearest + part * (cover + 1.0 - nearest);
    CAPTURE(cover, separation);
    const VisibleShare here = left_by(cover, separation), there = counted(cover, separation);
    // 1.6e5 squares: those of the edges leave some 2e-4
    CHECK(here.area == Approx(there.area).epsilon(0).margin(6e-4));
    CHECK(here.by_cosine == Approx(there.by_cosine).epsilon(0).margin(6e-4));
  }
}

// beta = 3 h c 2^(1/4) / (8 k lambda T): 2.03 at 0.55 um, and limb over middle 1 / (1 + beta).
TEST_CASE("the sun's limb is darker, more so in the blue", "[ephemeris][eclipse]") {
  CHECK(limb_darkening(0.55_um) == Approx(2.032 / 3.032).epsilon(1e-3));
  CHECK(limb_darkening(0.40_um) > limb_darkening(0.70_um));
  CHECK(limb_darkening(10.0_um) < 0.11);
  // When only the limb is left, the blue has lost more than the infrared.
  const Eclipse thin{left_by(1.0, 0.1), 0.0, 0.95};
  CHECK(thin.factor(0.40_um) < thin.factor(1.6_um));
  CHECK(thin.factor(0.40_um) < thin.sunlight.area);
  // The far infrared sees an even disc.
  CHECK(thin.factor(1000.0_um) == Approx(thin.sunlight.area).epsilon(1e-3));
  CHECK(Eclipse{}.factor(0.55_um) == 1.0);
  // Limb and middle covered alike: no colour, whatever the darkening.
  CHECK(Eclipse{{0.3, 0.3}}.factor(0.40_um) == Approx(0.3).epsilon(1e-12));
  // The middle alone is left, all of it cosine 1: its share is 1 over the disc's mean, 1 - u / 3.
  const double u = limb_darkening(0.55_um);
  CHECK(Eclipse{{1e-6, 1.5e-6}}.factor(0.55_um) == Approx(1e-6 / (1.0 - u / 3.0)).epsilon(1e-9));
}

// NASA (F. Espenak): greatest eclipse 18:25:32 UT at 36 deg 58.0' N, 87 deg 40.3' W, magnitude
// 1.0306 (with a lunar radius 4e-4 smaller), totality 2 min 40 s.
TEST_CASE("the eclipse of 2017 August 21 is total where it was", "[ephemeris][eclipse]") {
  const double latitude_deg = 36.0 + 58.0 / 60.0, longitude_deg = -(87.0 + 40.3 / 60.0);
  const Circumstances seen = local("2017-08-21T18:25:32Z", latitude_deg, longitude_deg);
  CHECK(seen.magnitude == Approx(1.0306).epsilon(0).margin(0.0015));
  CHECK(seen.obscuration == 1.0);
  CHECK(seen.central_s == Approx(160.0).epsilon(0).margin(8.0));  // two steps
  const Eclipse total = solar_at("2017-08-21T18:25:32Z", latitude_deg, longitude_deg);
  CHECK(total.factor(0.55_um) == 0.0);
}

// NASA: greatest eclipse 18:17:18 UT, 25 deg 17.4' N, 104 deg 08.3' W, magnitude 1.0566, 4 min 28
// s.
TEST_CASE("the eclipse of 2024 April 8 is total where it was", "[ephemeris][eclipse]") {
  const Circumstances seen = local("2024-04-08T18:17:18Z", 25.0 + 17.4 / 60, -104.0 - 8.3 / 60);
  CHECK(seen.magnitude == Approx(1.0566).epsilon(0).margin(0.0015));
  CHECK(seen.central_s == Approx(268.0).epsilon(0).margin(8.0));
}

// NASA: greatest eclipse 17:59:29 UT, 11 deg 22.1' N, 83 deg 06.1' W, magnitude 0.9520, and of the
// area 0.9520^2 = 0.9063.
TEST_CASE("the eclipse of 2023 October 14 is annular where it was", "[ephemeris][eclipse]") {
  const Circumstances seen = local("2023-10-14T17:59:29Z", 11.0 + 22.1 / 60, -83.0 - 6.1 / 60);
  CHECK(seen.magnitude == Approx(0.9520).epsilon(0).margin(0.0015));
  CHECK(seen.obscuration == Approx(0.9063).epsilon(0).margin(0.0025));
  CHECK(seen.central_s == 0.0);
}

// Magnitudes at maximum from EclipseWise (F. Espenak), two decimals; 0.005 more for the moon's
// place. Times of maximum to some minutes.
TEST_CASE("the eclipse of 2017 is partial in the cities as published", "[ephemeris][eclipse]") {
  CHECK(local("2017-08-21T17:47:00Z", 39.739, -104.985).magnitude ==  // Denver
        Approx(0.93).epsilon(0).margin(0.01));
  CHECK(local("2017-08-21T18:46:00Z", 42.360, -71.058).magnitude ==  // Boston
        Approx(0.70).epsilon(0).margin(0.01));
  CHECK(local("2017-08-21T17:45:00Z", 35.084, -106.650).magnitude ==  // Albuquerque
        Approx(0.78).epsilon(0).margin(0.01));
}

// Contacts of the total lunar eclipse of 2022 May 16 (Espenak, NASA): P1 01:32:07, U1 02:27:53, U2
// 03:29:03, greatest 04:11:29 with umbral magnitude 1.4137, U3 04:53:56, U4 05:55:07, P4 06:50:48.
// Five minutes within the penumbra its light falls by 1e-6. The moon crosses its radius, 0.5 of
// magnitude, in half an hour: 0.005 is 20 s or 10 arcsec.
TEST_CASE("the moon passes the earth's shadow of 2022 May 16 on time", "[ephemeris][eclipse]") {
  CHECK(lunar_at("2022-05-16T02:27:53Z").magnitude == Approx(0.0).margin(0.005));
  CHECK(lunar_at("2022-05-16T03:29:03Z").magnitude == Approx(1.0).epsilon(0).margin(0.005));
  CHECK(lunar_at("2022-05-16T04:11:29Z").magnitude == Approx(1.4137).epsilon(0).margin(0.005));
  CHECK(lunar_at("2022-05-16T04:53:56Z").magnitude == Approx(1.0).epsilon(0).margin(0.005));
  CHECK(lunar_at("2022-05-16T05:55:07Z").magnitude == Approx(0.0).margin(0.005));
  CHECK_FALSE(lunar_at("2022-05-16T01:31:00Z").any());
  CHECK(lunar_at("2022-05-16T01:37:00Z").any());
  CHECK(lunar_at("2022-05-16T06:46:00Z").any());
  CHECK_FALSE(lunar_at("2022-05-16T06:52:00Z").any());
}

TEST_CASE("the moon in the umbra is dark and red, in the penumbra between",
          "[ephemeris][eclipse]") {
  const Eclipse total = lunar_at("2022-05-16T04:11:29Z");
  CHECK(total.in_umbra == Approx(1.0).epsilon(1e-6));
  CHECK(total.sunlight.area == Approx(0.0).margin(1e-9));
  CHECK(total.factor(0.55_um) == Approx(8e-5).epsilon(1e-6));
  CHECK(total.factor(0.45_um) < 0.4 * total.factor(0.65_um));
  const Eclipse partial = lunar_at("2022-05-16T02:58:00Z");
  CHECK(partial.in_umbra > 0.3);
  CHECK(partial.in_umbra < 0.7);
  CHECK(partial.sunlight.area < 1.0 - partial.in_umbra);
  CHECK(lunar_at("2022-05-16T01:40:00Z").factor(0.55_um) > 0.99);
}

// Half the rings of the moon's disc change from dark to light over minutes: no step on the way.
TEST_CASE("the moon's light falls and rises without a step", "[ephemeris][eclipse]") {
  const Instant start = Instant::parse_utc("2022-05-16T01:25:00Z");
  double previous = 1.0;
  for (int minute = 0; minute <= 166; minute += 2) {  // to the middle
    const double now = lunar_eclipse(earth_shadow(start + Seconds{60.0 * minute})).factor(0.55_um);
    CAPTURE(minute);
    CHECK(now <= previous + 1e-9);
    // The moon's diameter takes an hour, the brightest strip of it 1.3 of the mean: 5 % in 2 min.
    CHECK(now > previous - 0.05);
    previous = now;
  }
  CHECK(previous < 1e-3);
}

TEST_CASE("an ordinary day has no eclipse", "[ephemeris][eclipse]") {
  CHECK_FALSE(solar_at("2026-06-21T16:00:00Z", 43.1, -77.6).any());
  CHECK_FALSE(lunar_at("2026-06-21T16:00:00Z").any());
}
