#pragma once

#include <string>
#include <string_view>

namespace nadir::ephemeris {

/// A moment as a clock shows it. In a leap second `second` is 60 or more.
struct CalendarTime {
  int year = 2000, month = 1, day = 1;
  int hour = 0, minute = 0;
  double second = 0.0;
};

/// Reads `2026-06-21T16:00:00Z` or `2026-06-21T16:00:00.25Z`: ISO 8601 in its extended form, all
/// fields present, up to nine decimals of a second, and the Z of UTC.
///
/// Checks every field and the length of the month. Second 60 is taken at 23:59 only; whether that
/// day had a leap second, only the table of leap seconds can tell.
/// @throws InputError  quotes the text and says what was expected
[[nodiscard]] CalendarTime parse_iso_time(std::string_view text);

/// The same form back, with as many of `nanoseconds`' nine decimals as are needed.
[[nodiscard]] std::string format_iso_time(const CalendarTime& whole_seconds, int nanoseconds);

}  // namespace nadir::ephemeris
