#include "ephemeris/instant.hpp"

#include <erfa.h>
#include <erfam.h>

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "ephemeris/delta_t.hpp"
#include "ephemeris/iso_time.hpp"
#include "ephemeris/number_text.hpp"
#include "ephemeris/utc_day.hpp"

namespace nadir::ephemeris {
namespace {

// Julian dates of midnights.
constexpr double range_begin = 2415020.5;  // 1900-01-01
constexpr double range_end = 2488434.5;    // 2101-01-01
constexpr double utc_begin = 2436934.5;    // 1960-01-01, where the table of TAI - UTC begins
// TAI - UTC at that moment, s: 1.417818 + (36934 - 37300) 0.001296 (USNO tai-utc.dat; eraDat).
constexpr double tai_utc_1960_s = 0.943482;

template <class Scale>
bool is_before(JulianDate<Scale> date, double midnight_jd) {
  return (date.day - midnight_jd) + date.fraction < 0.0;
}

std::string quoted(std::string_view text) { return "time \"" + std::string{text} + "\": "; }

double midnight_of(const CalendarTime& time) {
  double zero_point = 0.0, modified = 0.0;
  eraCal2jd(time.year, time.month, time.day, &zero_point, &modified);  // the date is checked
  return zero_point + modified;
}

double second_of_day(const CalendarTime& time) {
  return 3600.0 * time.hour + 60.0 * time.minute + time.second;
}

void check_year(std::string_view text, int year) {
  if (year >= 1900 && year <= 2100) return;
  throw InputError{quoted(text) +
                   "outside 1900-01-01 to 2100-12-31, the years for which the positions of the sun "
                   "and the moon are good"};
}

void check_ut1_utc(Seconds ut1_utc, bool has_utc, bool past_table) {
  const double limit = !has_utc ? 0.0 : past_table ? 200.0 : 1.0;
  if (std::abs(ut1_utc.value) <= limit) return;  // false for NaN
  const std::string found = "UT1 - UTC is " + number_text(ut1_utc.value) + " s, ";
  if (!has_utc) throw InputError{found + "expected 0 before 1960, when there was no UTC"};
  if (past_table) throw InputError{found + "expected at most 200 s either way"};
  throw InputError{found + "expected at most 1 s either way: leap seconds keep it within 0.9 s"};
}

void check_second(std::string_view text, double second, double length_s) {
  if (second < length_s) return;
  throw InputError{quoted(text) + "there is no such second: the day ends before it"};
}

// The calendar's view of a moment, rounded to nanoseconds.
std::string iso_text(double midnight_jd, double second_of_the_day) {
  CalendarTime time;
  double fraction = 0.0;
  eraJd2cal(midnight_jd, 0.0, &time.year, &time.month, &time.day, &fraction);
  const long long nanoseconds = std::llround(second_of_the_day * 1e9);
  const int second = static_cast<int>(nanoseconds / 1'000'000'000);
  const int minute = std::min(second / 60, 1439);  // a leap second belongs to the last minute
  time.hour = minute / 60;
  time.minute = minute % 60;
  time.second = second - 60 * minute;
  return format_iso_time(time, static_cast<int>(nanoseconds % 1'000'000'000));
}

}  // namespace

Instant Instant::parse_utc(std::string_view text, Seconds ut1_utc) {
  const CalendarTime time = parse_iso_time(text);
  check_year(text, time.year);
  const double midnight = midnight_of(time), second = second_of_day(time);
  if (time.year < 1960) {
    check_second(text, second, seconds_per_day);
    check_ut1_utc(ut1_utc, false, false);
    return {later(TaiDate{midnight, 0.0}, second + tai_utc_1960_s), ut1_utc};
  }
  const UtcDay day{midnight};
  check_second(text, second, day.length_s());
  check_ut1_utc(ut1_utc, true, day.past_table());
  return {day.tai(second), ut1_utc};
}

bool Instant::before_utc() const noexcept {
  return is_before(later(clock_, half_nanosecond - tai_utc_1960_s), utc_begin);
}

UtcDate Instant::utc() const {
  if (before_utc()) {
    const Ut1Date date = ut1();
    return {date.day, date.fraction};
  }
  const UtcMoment moment = utc_moment(clock_);
  return {moment.day.midnight(), moment.second / moment.day.length_s()};
}

Ut1Date Instant::ut1() const {
  if (before_utc()) return later(Ut1Date{clock_.day, clock_.fraction}, -tai_utc_1960_s);
  const UtcMoment moment = utc_moment(clock_);
  return later(Ut1Date{moment.day.midnight(), 0.0}, moment.second + ut1_utc_.value);
}

TtDate Instant::tt() const {
  if (!before_utc()) return later(TtDate{clock_.day, clock_.fraction}, ERFA_TTMTAI);
  const Ut1Date rotation = ut1();
  const Seconds offset = delta_t(eraEpj(rotation.day, rotation.fraction));
  return later(TtDate{rotation.day, rotation.fraction}, offset.value);
}

TaiDate Instant::tai() const {
  if (!before_utc()) return clock_;
  const TtDate date = tt();
  return later(TaiDate{date.day, date.fraction}, -ERFA_TTMTAI);
}

std::string Instant::to_string() const {
  if (before_utc()) {
    const Ut1Date date = later(ut1(), half_nanosecond);  // as in `utc_moment`: rounded up, then
    const double second = date.fraction * seconds_per_day - half_nanosecond;  // down again
    return iso_text(date.day, std::max(0.0, second));
  }
  const UtcMoment moment = utc_moment(clock_);
  return iso_text(moment.day.midnight(), moment.second);
}

std::optional<std::string> Instant::caution() const {
  if (before_utc()) {
    return "time " + to_string() +
           ": before 1960 there was no UTC; taken as UT1, with TT - UT1 from the polynomials of "
           "Espenak and Meeus (2006)";
  }
  const UtcDay day = utc_moment(clock_).day;
  if (!day.past_table()) return std::nullopt;
  return "time " + to_string() +
         ": after the end of the table of leap seconds; TAI - UTC is kept at " +
         number_text(day.tai_utc_s()) + " s";
}

Instant Instant::operator+(Seconds elapsed) const {
  constexpr double longest_s = (range_end - range_begin) * seconds_per_day;
  if (std::abs(elapsed.value) <= longest_s) {  // false for NaN
    const Instant sum{later(clock_, elapsed.value), ut1_utc_};
    const UtcDate date = sum.utc();
    if (!is_before(later(date, half_nanosecond), range_begin) && is_before(date, range_end)) {
      return sum;
    }
  }
  throw InputError{"time " + to_string() + " plus " + number_text(elapsed.value) +
                   " s lies outside 1900-01-01 to 2100-12-31"};
}

Seconds Instant::operator-(const Instant& earlier) const noexcept {
  const double days = clock_.day - earlier.clock_.day;
  const double fraction = clock_.fraction - earlier.clock_.fraction;
  return Seconds{days * seconds_per_day + fraction * seconds_per_day};
}

}  // namespace nadir::ephemeris
