#pragma once

#include <cmath>

#include "ephemeris/time_scales.hpp"

namespace nadir::ephemeris {

inline constexpr double seconds_per_day = 86400.0;

/// Half of the last digit of a written time. A moment less than this before midnight is midnight:
/// rounding must not change the day.
inline constexpr double half_nanosecond = 5e-10;

/// A date some seconds later, with whole days in the day part so that the fraction stays precise.
template <class Scale>
[[nodiscard]] JulianDate<Scale> later(JulianDate<Scale> date, double seconds) noexcept {
  const double days = std::floor(seconds / seconds_per_day);
  const double fraction = date.fraction + (seconds - days * seconds_per_day) / seconds_per_day;
  const double carry = std::floor(fraction);
  return {date.day + days + carry, fraction - carry};
}

/// One day of UTC, from 1960-01-01 on. Before 1972 its seconds were longer than those of TAI, and
/// some days ended in a step of 0.05 or 0.1 s.
///
/// Of ERFA only the table is used (eraDat): its conversions are inexact before 1972 (eraD2dtf does
/// not undo eraDtf2d on a day with a step, by 0.1 s; eraUtcut1 leaves out the day's drift, 2.6 ms).
class UtcDay {
 public:
  explicit UtcDay(double midnight_jd);

  [[nodiscard]] double midnight() const noexcept { return midnight_; }  ///< Julian date
  [[nodiscard]] double length_s() const noexcept {
    return length_s_;
  }  ///< 86401 with a leap second
  [[nodiscard]] double tai_utc_s() const noexcept { return tai_utc_s_; }  ///< TAI - UTC at midnight
  /// After the years for which the table vouches: its last value is kept.
  [[nodiscard]] bool past_table() const noexcept { return past_table_; }

  [[nodiscard]] TaiDate tai(double second) const noexcept;  ///< at a second of this day
  [[nodiscard]] double second(TaiDate tai) const noexcept;  ///< the other way, unbounded

 private:
  double midnight_;
  double tai_utc_s_;
  double rate_;      // seconds of TAI in a second of UTC
  double length_s_;  // in seconds of UTC
  bool past_table_;
};

/// A moment by the clock of its day.
struct UtcMoment {
  UtcDay day;
  double second;  ///< 0 <= second < length of the day
};

[[nodiscard]] UtcMoment utc_moment(TaiDate tai) noexcept;

}  // namespace nadir::ephemeris
