#include "sensor/orbit/earth_frames.hpp"

#include <erfa.h>
#include <erfam.h>

#include <array>
#include <cmath>

#include "support/catch.hpp"

namespace nadir::sensor {
namespace {

using ephemeris::Instant;

// The worked example of Vallado et al., AIAA 2006-6753, appendix C (Vallado, Fundamentals of
// Astrodynamics, example 3-15), km and km/s. PEF: earth-fixed but for polar motion.
const StateVector teme{{5094.18016210, 6127.64465950, 6380.34453270},
                       {-4.746131487, 0.785818041, 5.531931288}};
const StateVector pef{{-1033.47503120, 7901.30558560, 6380.34453270},
                      {-3.2256327470, -2.8724425110, 5.5319312880}};
const Vec3 itrf{-1033.47938300, 7901.29527540, 6380.35659580};
constexpr double length_of_day_s = 0.0015563;  // above 86400

Instant example() { return Instant::parse_utc("2004-04-06T07:51:28.386009Z", Seconds{-0.4399619}); }

std::vector<Instant> some_times() {
  return {Instant::parse_utc("1973-06-01T00:00:00Z", Seconds{0.2}),
          Instant::parse_utc("2000-01-01T12:00:00Z"), example(),
          Instant::parse_utc("2026-06-21T16:00:00.25Z", Seconds{0.1})};
}

Vec3 turned(const double m[3][3], Vec3 v) {
  return {m[0][0] * v.x + m[0][1] * v.y + m[0][2] * v.z,
          m[1][0] * v.x + m[1][1] * v.y + m[1][2] * v.z,
          m[2][0] * v.x + m[2][1] * v.y + m[2][2] * v.z};
}

/// ERFA's own matrix from GCRS to ITRS, without polar motion.
Vec3 by_erfa(const Instant& time, Vec3 gcrf) {
  const auto tt = time.tt();
  const auto ut1 = time.ut1();
  double m[3][3];
  eraC2t06a(tt.day, tt.fraction, ut1.day, ut1.fraction, 0.0, 0.0, m);
  return turned(m, gcrf);
}

}  // namespace

TEST_CASE("the published example from TEME to the earth is met", "[sensor][frames]") {
  // The authors' Julian date of UT1 is one double, 2453101.8274067829 to the nearest 4.7e-10 days.
  const auto ut1 = example().ut1();
  const double in_one_double = ut1.day + ut1.fraction;
  const Seconds rounded{86400.0 * ((in_one_double - ut1.day) - ut1.fraction)};
  const StateVector s = ecef_from_teme(teme, example() + rounded);
  CHECK(std::abs(rounded.value) < 2.1e-5);
  // Printed to 1e-7 km: half a digit in each axis of both vectors. Measured 1.6e-7.
  CHECK(length(s.position - pef.position) < 2e-7);
  CHECK(length(ecef_from_teme(teme, example()).position - pef.position) < 1.3e-5);  // 21 us
  // Their rate of turning has the day's true length in it, which the program does not know.
  const Vec3 longer_day =
      cross(Vec3{0.0, 0.0, earth_rate_rad_s * length_of_day_s / 86400.0}, s.position);
  CHECK(length(longer_day) == Approx(1.05e-8).epsilon(0.01));    // 10 um/s: what this costs
  CHECK(length(s.velocity + longer_day - pef.velocity) < 1e-9);  // the last digit
  // What polar motion (xp -0.14, yp 0.33 arcsec) costs, km.
  CHECK(length(s.position - itrf) == Approx(0.01646).epsilon(0.01));
}

TEST_CASE("sidereal time is that of ERFA", "[sensor][frames]") {
  for (const Instant& time : some_times()) {
    const auto ut1 = time.ut1();
    const double difference = mean_sidereal_time(ut1).value - eraGmst82(ut1.day, ut1.fraction);
    CHECK(std::remainder(difference, 2.0 * ERFA_DPI) == Approx(0.0).margin(1e-12));
  }
}

TEST_CASE("UT1 turns the earth", "[sensor][frames]") {
  const Instant later_ut1 = Instant::parse_utc("2004-04-06T07:51:28.386009Z", Seconds{0.5600381});
  const Vec3 at = ecef_from_teme(teme, example()).position;
  const Vec3 turned_on = ecef_from_teme(teme, later_ut1).position;
  const double angle =
      std::atan2(at.x * turned_on.y - at.y * turned_on.x, at.x * turned_on.x + at.y * turned_on.y);
  // Eastwards, the satellite falls behind by a second's turn of the earth.
  CHECK(angle == Approx(-earth_rate_rad_s).epsilon(1e-6));
}

TEST_CASE("TEME and back is where it was", "[sensor][frames]") {
  for (const Instant& time : some_times()) {
    const StateVector s = teme_from_ecef(ecef_from_teme(teme, time), time);
    CHECK(length(s.position - teme.position) < 1e-11);  // rounding of 1e4
    CHECK(length(s.velocity - teme.velocity) < 1e-13);
    // A place fixed to the earth moves eastwards in the sky.
    const StateVector fixed = teme_from_ecef({{6378.0, 0.0, 0.0}, {}}, time);
    CHECK(length(fixed.velocity) == Approx(6378.0 * earth_rate_rad_s).epsilon(1e-12));
    CHECK(cross(fixed.position, fixed.velocity).z > 0.0);
  }
}

TEST_CASE("the sky's axes turn into the earth's as in ERFA", "[sensor][frames]") {
  for (const Instant& time : some_times()) {
    const StateVector s = ecef_from_gcrf(teme, time);
    CHECK(length(s.position - by_erfa(time, teme.position)) <
          1e-9);  // 1e-13 rad of 1e4 km; measured 4e-14
    const StateVector later =
        ecef_from_gcrf({teme.position + 0.5 * teme.velocity, {}}, time + Seconds{0.5});
    const StateVector sooner =
        ecef_from_gcrf({teme.position - 0.5 * teme.velocity, {}}, time - Seconds{0.5});
    // The axis' motion in the sky is left out: 8e-12 rad/s of 1e4 km.
    CHECK(length(later.position - sooner.position - s.velocity) < 1e-7);
  }
}

TEST_CASE("EME2000 differs from GCRF by the bias of the frames", "[sensor][frames]") {
  double bias[3][3], precession[3][3], both[3][3];
  eraBp06(ERFA_DJ00, 0.0, bias, precession, both);
  for (const Vec3 v : {Vec3{1.0, 0.0, 0.0}, Vec3{0.0, 1.0, 0.0}, Vec3{0.0, 0.0, 1.0}}) {
    const Vec3 eme2000 = turned(bias, v);
    // ERFA's bias of IAU 2006 is another fit of the same angles: measured 8e-13.
    CHECK(length(ecef_from_eme2000({eme2000, {}}, example()).position -
                 ecef_from_gcrf({v, {}}, example()).position) < 1e-11);
    CHECK(length(eme2000 - v) < 2e-7);
  }
}

}  // namespace nadir::sensor
