#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/quantity.hpp"
#include "ephemeris/time_scales.hpp"

namespace nadir::ephemeris {

struct CalendarTime;

/// A moment between 1900-01-01 and 2100-12-31, the years for which the positions of the sun and
/// the moon are good. Read from UTC; gives every time scale that the positions need.
///
/// - From 1960 on the text is UTC: TAI from the table of leap seconds, TT = TAI + 32.184 s,
///   UT1 = UTC + (UT1 - UTC). The last is measured (IERS bulletins A and B); left at 0 it costs at
///   most 0.9 s, 13.7 arcsec of azimuth, as long as leap seconds keep UTC near UT1.
/// - Before 1960 there was no UTC: the text is taken as UT1, and TT = UT1 + Delta T (delta_t.hpp).
/// - After the table of leap seconds ends, its last value is kept and `caution` says so.
///
/// Precision of every date, sum and difference: 1e-10 s. A value; thread-safe.
class Instant {
 public:
  /// @param text     ISO 8601 with a trailing Z, up to nine decimals; 23:59:60 where there was one
  /// @param ut1_utc  UT1 - UTC; at most 1 s, after the table's end at most 200 s; 0 before 1960
  /// @throws InputError for anything else, with the text in the message
  [[nodiscard]] static Instant parse_utc(std::string_view text, Seconds ut1_utc = Seconds{0.0});

  [[nodiscard]] UtcDate utc() const;  ///< before 1960 the same numbers as `ut1`
  [[nodiscard]] TaiDate tai() const;
  [[nodiscard]] TtDate tt() const;
  [[nodiscard]] Ut1Date ut1() const;
  [[nodiscard]] Seconds ut1_utc() const noexcept { return ut1_utc_; }

  /// ISO 8601, rounded to nanoseconds: what `parse_utc` reads back.
  [[nodiscard]] std::string to_string() const;
  /// What the user should know about the time scales at this moment, or nothing.
  [[nodiscard]] std::optional<std::string> caution() const;

  /// SI seconds later. Before 1960 the seconds are those of UT1 (equal to 1 in 3e7).
  /// @throws InputError where the sum leaves 1900 to 2100
  [[nodiscard]] Instant operator+(Seconds elapsed) const;
  [[nodiscard]] Instant operator-(Seconds elapsed) const { return *this + -elapsed; }
  /// Seconds from `earlier` to this, leap seconds counted; undoes `operator+`.
  [[nodiscard]] Seconds operator-(const Instant& earlier) const noexcept;

 private:
  Instant(TaiDate clock, Seconds ut1_utc) : clock_{clock}, ut1_utc_{ut1_utc} {}
  [[nodiscard]] bool before_utc() const noexcept;

  // An even axis: TAI from 1960 on, and before 1960 UT1 plus the TAI - UTC of the first moment of
  // 1960, so that elapsed time runs on without a step.
  TaiDate clock_;
  Seconds ut1_utc_;
};

}  // namespace nadir::ephemeris
