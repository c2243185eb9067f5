#include "ephemeris/iso_time.hpp"

#include <string>

#include "core/error.hpp"
#include "support/catch.hpp"

namespace {

using namespace nadir;
using namespace nadir::ephemeris;

std::string time_message(const std::string& text) {
  try {
    static_cast<void>(parse_iso_time(text));
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

}  // namespace

TEST_CASE("an ISO 8601 time is read field by field", "[ephemeris][iso_time]") {
  const CalendarTime time = parse_iso_time("2026-06-21T16:05:09.25Z");
  CHECK(time.year == 2026);
  CHECK(time.month == 6);
  CHECK(time.day == 21);
  CHECK(time.hour == 16);
  CHECK(time.minute == 5);
  CHECK(time.second == 9.25);  // exact in binary
}

TEST_CASE("the text after the Z's place is not read", "[ephemeris][iso_time]") {
  const std::string longer = "2026-06-21T16:05:09Z5";
  CHECK(parse_iso_time(std::string_view{longer}.substr(0, 20)).second == 9.0);
}

TEST_CASE("calendar months have their Gregorian lengths", "[ephemeris][iso_time]") {
  CHECK(parse_iso_time("2000-02-29T00:00:00Z").day == 29);
  CHECK(parse_iso_time("2024-02-29T00:00:00Z").day == 29);
  CHECK(time_message("1900-02-29T00:00:00Z") ==
        "error: time \"1900-02-29T00:00:00Z\": month 2 of 1900 has 28 days\n");
  CHECK(time_message("2026-04-31T00:00:00Z") ==
        "error: time \"2026-04-31T00:00:00Z\": month 4 of 2026 has 30 days\n");
  CHECK(time_message("2026-01-00T00:00:00Z") ==
        "error: time \"2026-01-00T00:00:00Z\": month 1 of 2026 has 31 days\n");
}

TEST_CASE("fields outside their ranges are named", "[ephemeris][iso_time]") {
  CHECK(time_message("2026-13-01T00:00:00Z") ==
        "error: time \"2026-13-01T00:00:00Z\": month 13 is outside 1 to 12\n");
  CHECK(time_message("2026-06-21T24:00:00Z") ==
        "error: time \"2026-06-21T24:00:00Z\": hour 24 is outside 0 to 23\n");
  CHECK(time_message("2026-06-21T16:60:00Z") ==
        "error: time \"2026-06-21T16:60:00Z\": minute 60 is outside 0 to 59\n");
  CHECK(time_message("2026-06-21T16:00:60Z") ==
        "error: time \"2026-06-21T16:00:60Z\": second 60 is outside 0 to 59\n");
  CHECK(time_message("2016-12-31T23:59:61Z") ==
        "error: time \"2016-12-31T23:59:61Z\": second 61 is outside 0 to 60\n");
}

TEST_CASE("a time without Z is refused", "[ephemeris][iso_time]") {
  CHECK(time_message("2026-06-21T16:00:00") ==
        "error: time \"2026-06-21T16:00:00\": expected ISO 8601 in UTC, such as "
        "2026-06-21T16:00:00Z; the Z at the end is missing\n");
}

TEST_CASE("what is not an ISO 8601 time is refused", "[ephemeris][iso_time]") {
  const std::string text = GENERATE(
      as<std::string>{}, "", "noon", "2026-06-21", "2026-06-21 16:00:00Z", "2026-6-21T16:00:00Z",
      "2026-06-21T16:00Z", "2026-06-21t16:00:00Z", "2026-06-21T16:00:00.Z", "2026-06-21T16:00:0aZ",
      "2026-06-21T16:00:00,5Z", "2026-06-21T16:00:00.5eZ", "2026-06-21T16:00:00ZZ",
      "+2026-06-21T16:00:00Z", "2026-06-21T16:00:-1Z");
  CHECK(time_message(text) ==
        "error: time \"" + text + "\": expected ISO 8601 in UTC, such as 2026-06-21T16:00:00Z\n");
}

TEST_CASE("a second has at most nine decimals", "[ephemeris][iso_time]") {
  CHECK(time_message("2026-06-21T16:00:00.123456789Z") == "accepted");
  CHECK(time_message("2026-06-21T16:00:00.1234567890Z") ==
        "error: time \"2026-06-21T16:00:00.1234567890Z\": a second has at most 9 decimals\n");
}

TEST_CASE("a time is written with the decimals that it needs", "[ephemeris][iso_time]") {
  const CalendarTime time{1999, 1, 2, 3, 4, 5.0};
  CHECK(format_iso_time(time, 0) == "1999-01-02T03:04:05Z");
  CHECK(format_iso_time(time, 250'000'000) == "1999-01-02T03:04:05.25Z");
  CHECK(format_iso_time(time, 7) == "1999-01-02T03:04:05.000000007Z");
  // trailing zeros of the seconds themselves stay
  CHECK(format_iso_time({2000, 10, 20, 10, 20, 30.0}, 0) == "2000-10-20T10:20:30Z");
}
