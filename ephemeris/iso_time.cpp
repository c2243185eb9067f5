#include "ephemeris/iso_time.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdio>

#include "core/error.hpp"

namespace nadir::ephemeris {
namespace {

constexpr std::string_view shape = "0000-00-00T00:00:00";  // 0 stands for any digit
constexpr std::size_t max_decimals = 9;

bool is_digit(char c) { return c >= '0' && c <= '9'; }

[[noreturn]] void fail(std::string_view text, const std::string& problem) {
  throw InputError{"time \"" + std::string{text} + "\": " + problem};
}

void check_shape(std::string_view text) {
  const std::string expected = "expected ISO 8601 in UTC, such as 2026-06-21T16:00:00Z";
  if (text.size() < shape.size()) fail(text, expected);
  for (std::size_t i = 0; i < shape.size(); ++i) {
    if (shape[i] == '0' ? !is_digit(text[i]) : text[i] != shape[i]) fail(text, expected);
  }
  if (text.back() != 'Z') fail(text, expected + "; the Z at the end is missing");
  const std::string_view decimals = text.substr(shape.size(), text.size() - shape.size() - 1);
  if (decimals.empty()) return;
  const bool digits = std::all_of(decimals.begin() + 1, decimals.end(), is_digit);
  if (decimals[0] != '.' || decimals.size() == 1 || !digits) fail(text, expected);
  if (decimals.size() - 1 > max_decimals) fail(text, "a second has at most 9 decimals");
}

int digits(std::string_view text, std::size_t first, std::size_t count) {
  int value = 0;
  std::from_chars(text.data() + first, text.data() + first + count, value);
  return value;
}

int days_in_month(int year, int month) {
  constexpr std::array<int, 12> days{31, 28, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31};
  const bool leap_year = (year % 4 == 0 && year % 100 != 0) || year % 400 == 0;
  return month == 2 && leap_year ? 29 : days[static_cast<std::size_t>(month - 1)];
}

void check_range(std::string_view text, const char* field, int value, int lowest, int highest) {
  if (value >= lowest && value <= highest) return;
  fail(text, std::string{field} + " " + std::to_string(value) + " is outside " +
                 std::to_string(lowest) + " to " + std::to_string(highest));
}

void check_day(std::string_view text, const CalendarTime& time) {
  const int days = days_in_month(time.year, time.month);
  if (time.day >= 1 && time.day <= days) return;
  fail(text, "month " + std::to_string(time.month) + " of " + std::to_string(time.year) + " has " +
                 std::to_string(days) + " days");
}

}  // namespace

CalendarTime parse_iso_time(std::string_view text) {
  check_shape(text);
  CalendarTime time{digits(text, 0, 4),  digits(text, 5, 2),  digits(text, 8, 2),
                    digits(text, 11, 2), digits(text, 14, 2), 0.0};
  // The shape is checked: from_chars reads the digits and stops at the Z.
  std::from_chars(text.data() + 17, text.data() + text.size(), time.second);
  check_range(text, "month", time.month, 1, 12);
  check_day(text, time);
  check_range(text, "hour", time.hour, 0, 23);
  check_range(text, "minute", time.minute, 0, 59);
  const bool last_minute = time.hour == 23 && time.minute == 59;
  check_range(text, "second", digits(text, 17, 2), 0, last_minute ? 60 : 59);
  return time;
}

std::string format_iso_time(const CalendarTime& whole_seconds, int nanoseconds) {
  const CalendarTime& t = whole_seconds;
  std::array<char, 80> buffer{};
  std::snprintf(buffer.data(), buffer.size(), "%04d-%02d-%02dT%02d:%02d:%02d.%09d", t.year, t.month,
                t.day, t.hour, t.minute, static_cast<int>(t.second), nanoseconds);
  std::string text{buffer.data()};
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text + "Z";
}

}  // namespace nadir::ephemeris
