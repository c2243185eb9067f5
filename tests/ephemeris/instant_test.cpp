#include "ephemeris/instant.hpp"

#include <cmath>
#include <limits>
#include <string>

#include "core/error.hpp"
#include "support/catch.hpp"

namespace {

using namespace nadir;
using namespace nadir::ephemeris;

template <class A, class B>
double seconds_between(A a, B b) {
  return ((a.day - b.day) + (a.fraction - b.fraction)) * 86400.0;
}

double tai_utc(const std::string& text) {
  const Instant instant = Instant::parse_utc(text);
  return seconds_between(instant.tai(), instant.utc());
}

std::string message(const std::string& text, double ut1_utc_s = 0.0) {
  try {
    static_cast<void>(Instant::parse_utc(text, Seconds{ut1_utc_s}));
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

// The stated precision of a date or a difference, with the difference of two days as number.
constexpr double precision_s = 1e-10;

}  // namespace

// USNO tai-utc.dat; IERS Bulletin C 52 (37 s from 2017-01-01).
TEST_CASE("TAI - UTC follows the table of leap seconds", "[ephemeris][instant]") {
  CHECK(tai_utc("1972-01-01T00:00:00Z") == Approx(10.0).margin(precision_s));
  CHECK(tai_utc("1980-01-06T00:00:00Z") == Approx(19.0).margin(precision_s));  // GPS begins
  CHECK(tai_utc("1999-01-01T00:00:00Z") == Approx(32.0).margin(precision_s));
  CHECK(tai_utc("2012-07-01T00:00:00Z") == Approx(35.0).margin(precision_s));
  CHECK(tai_utc("2016-12-31T00:00:00Z") == Approx(36.0).margin(precision_s));
  CHECK(tai_utc("2017-01-01T00:00:00Z") == Approx(37.0).margin(precision_s));
  // before 1972 UTC ran at another rate: 4.3131700 s + (MJD - 39126) 0.002592 s from 1966, and
  // 1.4178180 s + (MJD - 37300) 0.001296 s in 1960
  CHECK(tai_utc("1966-01-01T00:00:00Z") == Approx(4.31317).margin(precision_s));
  CHECK(tai_utc("1966-01-11T00:00:00Z") == Approx(4.33909).margin(precision_s));
  CHECK(tai_utc("1960-01-01T00:00:00Z") == Approx(0.943482).margin(precision_s));
}

TEST_CASE("TT - UTC is 69.184 s in 2026", "[ephemeris][instant]") {
  const Instant instant = Instant::parse_utc("2026-06-21T16:00:00Z");
  CHECK(seconds_between(instant.tt(), instant.utc()) == Approx(69.184).margin(precision_s));
}

// J2000.0 is JD 2451545.0 TT; then TAI - UTC was 32 s (IERS Conventions 2010, chapter 5).
TEST_CASE("J2000 has its Julian date", "[ephemeris][instant]") {
  const TtDate tt = Instant::parse_utc("2000-01-01T11:58:55.816Z").tt();
  CHECK(seconds_between(tt, TtDate{2451544.5, 0.5}) == Approx(0.0).margin(precision_s));
}

TEST_CASE("UT1 lies UT1 - UTC after UTC", "[ephemeris][instant]") {
  const Instant instant = Instant::parse_utc("2026-06-21T16:00:00Z", Seconds{-0.25});
  CHECK(seconds_between(instant.ut1(), instant.utc()) == Approx(-0.25).margin(precision_s));
  CHECK(instant.ut1_utc().value == -0.25);
}

TEST_CASE("leap seconds are real seconds", "[ephemeris][instant]") {
  const Instant before = Instant::parse_utc("2016-12-31T23:59:59Z");
  const Instant leap = Instant::parse_utc("2016-12-31T23:59:60.5Z");
  const Instant after = Instant::parse_utc("2017-01-01T00:00:00Z");
  CHECK((leap - before).value == Approx(1.5).margin(precision_s));
  CHECK((after - before).value == Approx(2.0).margin(precision_s));
  CHECK((before + Seconds{1.25}).to_string() == "2016-12-31T23:59:60.25Z");
  CHECK((before + Seconds{2.0}).to_string() == "2017-01-01T00:00:00Z");
}

TEST_CASE("second 60 is taken only where there was one", "[ephemeris][instant]") {
  CHECK(message("2016-12-31T23:59:60Z") == "accepted");
  CHECK(message("1972-06-30T23:59:60.999Z") == "accepted");
  CHECK(message("2015-12-31T23:59:60Z") ==
        "error: time \"2015-12-31T23:59:60Z\": there is no such second: the day ends before it\n");
  CHECK(message("2050-12-31T23:59:60Z") != "accepted");
  CHECK(message("1950-12-31T23:59:60Z") != "accepted");
  CHECK(message("1959-12-31T23:59:60Z") != "accepted");
  // steps of 0.1 s before 1972 (USNO tai-utc.dat): one longer day, one shorter
  CHECK(message("1965-08-31T23:59:60.05Z") == "accepted");
  CHECK(message("1965-08-31T23:59:60.15Z") != "accepted");
  CHECK(message("1968-01-31T23:59:59.85Z") == "accepted");
  CHECK(message("1968-01-31T23:59:59.95Z") != "accepted");
}

TEST_CASE("a time comes back as it was written", "[ephemeris][instant]") {
  const std::string text = GENERATE(
      as<std::string>{}, "1900-01-01T00:00:00Z", "1936-06-21T16:00:00.000000025Z",
      "1959-12-31T23:59:59.999999998Z", "1960-01-01T00:00:00Z", "1960-01-01T00:00:00.000000001Z",
      "1960-01-01T00:00:01.4Z", "1965-08-31T23:59:60.05Z", "1971-12-31T23:59:60Z",
      "1972-01-01T00:00:00Z", "2016-12-31T23:59:60.999999999Z", "2026-06-21T16:00:00.123456789Z",
      "2100-12-31T23:59:59.999999999Z");
  CHECK(Instant::parse_utc(text).to_string() == text);
}

TEST_CASE("time after a moment is undone by the time before it", "[ephemeris][instant]") {
  const Instant start = Instant::parse_utc("1959-12-31T12:00:00Z");
  // half a day, ten days, and sixty years, across the beginning of UTC
  const double elapsed_s = GENERATE(43'199.5, 43'200.0, 43'200.5, 864e3, 1.9e9 + 0.5);
  const Instant end = start + Seconds{elapsed_s};
  // 2.2e-16: the last bit of so many seconds
  CHECK((end - start).value ==
        Approx(elapsed_s).epsilon(0).margin(precision_s + 2.2e-16 * elapsed_s));
  CHECK((end - Seconds{elapsed_s}).to_string() == "1959-12-31T12:00:00Z");
}

TEST_CASE("time runs on over the beginning of UTC", "[ephemeris][instant]") {
  const Instant last = Instant::parse_utc("1959-12-31T23:59:59Z");
  CHECK((last + Seconds{1.0}).to_string() == "1960-01-01T00:00:00Z");
  const Instant first = Instant::parse_utc("1960-01-01T00:00:00Z");
  CHECK((first - last).value == Approx(1.0).margin(precision_s));
}

TEST_CASE("before 1960 the time is UT1 and TT comes from Delta T", "[ephemeris][instant]") {
  const Instant instant = Instant::parse_utc("1950-01-01T00:00:00Z");
  CHECK(instant.ut1().value() == 2433282.5);
  CHECK(instant.utc().value() == 2433282.5);
  // 29.07 s: the polynomial's constant at 1950.0; the date is 1950.0 to 2e-5 years
  CHECK(seconds_between(instant.tt(), instant.ut1()) == Approx(29.07).margin(1e-3));
  CHECK(seconds_between(instant.tt(), instant.tai()) == Approx(32.184).margin(precision_s));
  CHECK(message("1950-01-01T00:00:00Z", 0.1) ==
        "error: UT1 - UTC is 0.1 s, expected 0 before 1960, when there was no UTC\n");
}

TEST_CASE("dates outside 1900 to 2100 are refused", "[ephemeris][instant]") {
  CHECK(message("1899-12-31T23:59:59Z") ==
        "error: time \"1899-12-31T23:59:59Z\": outside 1900-01-01 to 2100-12-31, the years for "
        "which the positions of the sun and the moon are good\n");
  CHECK(message("2101-01-01T00:00:00Z") != "accepted");
  const Instant last = Instant::parse_utc("2100-12-31T23:59:59Z");
  CHECK_THROWS_WITH(last + Seconds{2.5},
                    "error: time 2100-12-31T23:59:59Z plus 2.5 s lies outside 1900-01-01 to "
                    "2100-12-31\n");
  const Instant first = Instant::parse_utc("1900-01-01T00:00:00Z");
  CHECK((first + Seconds{0.0}).to_string() == "1900-01-01T00:00:00Z");
  CHECK_THROWS_AS(first - Seconds{0.001}, InputError);
  CHECK_THROWS_AS(first + Seconds{1e300}, InputError);
  CHECK_THROWS_AS(first + Seconds{std::numeric_limits<double>::quiet_NaN()}, InputError);
}

TEST_CASE("UT1 - UTC is kept within what leap seconds allow", "[ephemeris][instant]") {
  CHECK(message("2026-01-01T00:00:00Z", 0.9) == "accepted");
  CHECK(message("2026-01-01T00:00:00Z", -1.5) ==
        "error: UT1 - UTC is -1.5 s, expected at most 1 s either way: leap seconds keep it within "
        "0.9 s\n");
  CHECK(message("2026-01-01T00:00:00Z", std::nan("")) != "accepted");
  CHECK(message("2090-01-01T00:00:00Z", -60.0) == "accepted");
  CHECK(message("2090-01-01T00:00:00Z", -300.0) ==
        "error: UT1 - UTC is -300 s, expected at most 200 s either way\n");
}

TEST_CASE("a caution is given outside the table of leap seconds", "[ephemeris][instant]") {
  CHECK(!Instant::parse_utc("1960-01-01T00:00:00Z").caution());
  CHECK(!Instant::parse_utc("2020-06-21T16:00:00Z").caution());
  CHECK(Instant::parse_utc("2080-06-21T16:00:00Z").caution() ==
        "time 2080-06-21T16:00:00Z: after the end of the table of leap seconds; TAI - UTC is kept "
        "at 37 s");
  CHECK(Instant::parse_utc("1950-06-21T16:00:00Z").caution() ==
        "time 1950-06-21T16:00:00Z: before 1960 there was no UTC; taken as UT1, with TT - UT1 from "
        "the polynomials of Espenak and Meeus (2006)");
}
