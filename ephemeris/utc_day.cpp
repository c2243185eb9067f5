#include "ephemeris/utc_day.hpp"

#include <erfa.h>

#include <algorithm>
#include <cmath>

namespace nadir::ephemeris {
namespace {

struct TableEntry {
  double tai_utc_s = 0.0;
  bool past_end = false;
};

TableEntry tai_utc(double midnight_jd, double day_fraction) {
  int year = 0, month = 0, day = 0;
  double fraction = 0.0;
  TableEntry entry;
  eraJd2cal(midnight_jd, 0.0, &year, &month, &day, &fraction);
  entry.past_end = eraDat(year, month, day, day_fraction, &entry.tai_utc_s) != 0;
  return entry;
}

}  // namespace

UtcDay::UtcDay(double midnight_jd) : midnight_{midnight_jd} {
  const TableEntry start = tai_utc(midnight_, 0.0);
  const double drift_s = 2.0 * (tai_utc(midnight_, 0.5).tai_utc_s - start.tai_utc_s);
  const double step_s = tai_utc(midnight_ + 1.0, 0.0).tai_utc_s - (start.tai_utc_s + drift_s);
  tai_utc_s_ = start.tai_utc_s;
  past_table_ = start.past_end;
  rate_ = 1.0 + drift_s / seconds_per_day;
  // Rounding leaves 1e-14 s of the differences where there is no step.
  length_s_ = seconds_per_day + (std::abs(step_s) < half_nanosecond ? 0.0 : step_s);
}

TaiDate UtcDay::tai(double second) const noexcept {
  return later(TaiDate{midnight_, 0.0}, second * rate_ + tai_utc_s_);
}

double UtcDay::second(TaiDate tai) const noexcept {
  const double elapsed_s = ((tai.day - midnight_) + tai.fraction) * seconds_per_day;
  return (elapsed_s - tai_utc_s_) / rate_;
}

// TAI is ahead of UTC, so the day of UTC is that of TAI or the one before.
UtcMoment utc_moment(TaiDate tai) noexcept {
  const UtcDay today{tai.day};
  const double second = today.second(tai);
  if (second >= -half_nanosecond) return {today, std::max(0.0, second)};
  const UtcDay yesterday{tai.day - 1.0};
  return {yesterday, yesterday.second(tai)};
}

}  // namespace nadir::ephemeris
