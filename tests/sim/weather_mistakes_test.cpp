#include <optional>
#include <string>

#include "sim/files/weather_format.hpp"
#include "sim/message_of.hpp"
#include "sim/weather_support.hpp"
#include "support/catch.hpp"

namespace nadir::sim {
namespace {

std::string weather_mistakes_message(const std::string& text,
                                     std::optional<WeatherLayout> layout = WeatherLayout::csv) {
  return support::message_of([&] { static_cast<void>(parse_weather(text, "w", layout)); });
}

TEST_CASE("the header of a CSV of weather is held to its names", "[sim][weather]") {
  CHECK(weather_mistakes_message("utc,air_temprature_c\n2026-06-21T16:00Z,20\n") ==
        "w:1:5: error: unknown column \"air_temprature_c\"\n"
        "    1 | utc,air_temprature_c\n"
        "      |     ^\n"
        "    hint: did you mean \"air_temperature_c\"?\n");
  CHECK(weather_mistakes_message("utc,dew_point_c,dew_point_k\n") ==
        "w:1:17: error: \"dew_point_k\" says what \"dew_point_c\" has said\n"
        "    1 | utc,dew_point_c,dew_point_k\n"
        "      |                 ^\n");
  CHECK(weather_mistakes_message("air_temperature_c\n20\n") ==
        "w:1:1: error: the time is missing: expected a column \"utc\" or \"local\"\n"
        "    1 | air_temperature_c\n"
        "      | ^\n");
  CHECK(weather_mistakes_message("local,air_temperature_c\n2026-06-21T16:00,20\n") ==
        "w:1:1: error: local time without its zone: expected a line such as "
        "\"# utc_offset_h: -5\" above, or a column \"utc_offset_h\"\n"
        "    1 | local,air_temperature_c\n"
        "      | ^\n");
  CHECK(weather_mistakes_message("# lattitude_deg: 36\nutc\n") ==
        "w:1:3: error: unknown key \"lattitude_deg\"\n"
        "    1 | # lattitude_deg: 36\n"
        "      |   ^\n"
        "    hint: did you mean \"latitude_deg\"?\n");
  CHECK(weather_mistakes_message("# utc_offset_h: 300\nlocal\n2026-06-21T16:00\n")
            .find("w:1:17: error: expected hours ahead of UTC from -14 to 14, found \"300\"\n") ==
        0);
  CHECK(weather_mistakes_message("# remark\n") ==
        "w: error: the weather is empty: its first row names the columns\n");
  CHECK(weather_mistakes_message("utc\n") == "w: error: the weather has no rows\n");
}

TEST_CASE("every row of a CSV of weather is held to what weather can be", "[sim][weather]") {
  CHECK(weather_mistakes_message("utc,air_temperature_c\n2026-06-21T16:00Z,288\n") ==
        "w:2:19: error: air_temperature_c is 288, which no weather is: it must lie from -93.15 to "
        "61.85\n"
        "    2 | 2026-06-21T16:00Z,288\n"
        "      |                   ^\n");
  CHECK(weather_mistakes_message("utc,pressure_pa\n2026-06-21T16:00Z,985\n")
            .find("pressure_pa is 985, which no weather is: it must lie from 40000 to 109000") !=
        std::string::npos);
  CHECK(weather_mistakes_message("utc,wind_speed_m_s\n2026-06-21T16:00Z,calm\n") ==
        "w:2:19: error: expected a number for wind_speed_m_s, found \"calm\"\n"
        "    2 | 2026-06-21T16:00Z,calm\n"
        "      |                   ^\n");
  CHECK(weather_mistakes_message("utc,wind_speed_m_s\n2026-06-21T16:00,1\n") ==
        "w:2:1: error: expected a time such as 2026-06-21T16:00Z, found \"2026-06-21T16:00\"\n"
        "    2 | 2026-06-21T16:00,1\n"
        "      | ^\n");
  CHECK(weather_mistakes_message("utc\n2026-02-29T16:00Z\n").find("found \"2026-02-29T16:00Z\"") !=
        std::string::npos);
  CHECK(weather_mistakes_message("utc,wind_speed_m_s\n2026-06-21T16:00Z,1,2\n")
            .find("w:2:1: error: expected 2 cells, found 3\n") == 0);
  CHECK(weather_mistakes_message("utc\n2026-06-21T16:00Z\n2026-06-21T15:00Z\n") ==
        "w:3:1: error: times must ascend: 2026-06-21T15:00Z follows 2026-06-21T16:00Z\n"
        "    3 | 2026-06-21T15:00Z\n"
        "      | ^\n");
  CHECK(weather_mistakes_message(
            "# radiation_mean_s: 3600\nutc\n2026-06-21T16:00Z\n2026-06-21T16:10Z\n")
            .find("w:4:1: error: 600 s after the row before, but radiation_mean_s is 3600\n") == 0);
}

TEST_CASE("mistakes of a TMY3 file are located", "[sim][weather]") {
  const std::string head =
      "723170,\"A\",NC,-5.0,36.100,-79.950,273\nDate (MM/DD/YYYY),Time (HH:MM),Dry-bulb (C)\n";
  const auto tmy3 = [](const std::string& text) {
    return weather_mistakes_message(text, WeatherLayout::tmy3);
  };
  CHECK(tmy3("723170,A\n")
            .find("w:1:1: error: expected the station's line: id, name, state, hours ahead of UTC, "
                  "latitude, longitude, height\n") == 0);
  CHECK(tmy3("723170,\"A\",NC,-5.0,136,-79.950,273\nDate (MM/DD/YYYY),Dry-bulb (C)\n") ==
        "w:1:20: error: expected the station's latitude in degrees from -90 to 90, found \"136\"\n"
        "    1 | 723170,\"A\",NC,-5.0,136,-79.950,273\n"
        "      |                    ^\n"
        "w:2:1: error: the column \"Time (HH:MM)\" is missing\n"
        "    2 | Date (MM/DD/YYYY),Dry-bulb (C)\n"
        "      | ^\n");
  CHECK(tmy3(head + "13/01/1988,01:00,10\n")
            .find("w:3:1: error: expected a date as MM/DD/YYYY, found \"13/01/1988\"\n") == 0);
  CHECK(tmy3(head + "01/01/1988,24:01,10\n")
            .find("w:3:12: error: expected a time as HH:MM up to 24:00, found \"24:01\"\n") == 0);
  // Years change between months; the order within the year must not.
  CHECK(tmy3(head + "01/31/1988,24:00,10\n02/01/1996,01:00,10\n03/01/1990,01:00,10\n") ==
        "(nothing thrown)");
  CHECK(tmy3(head + "01/31/1988,24:00,10\n01/31/1996,23:00,10\n") ==
        "w:4:1: error: times must ascend through the year: 01-31 23:00 follows 01-31 24:00\n"
        "    4 | 01/31/1996,23:00,10\n"
        "      | ^\n");
}

TEST_CASE("mistakes of EPW and SURFRAD files are located", "[sim][weather]") {
  const support::EpwDay day;
  CHECK(weather_mistakes_message(support::epw_header("LOCATION,A") + support::epw_row(day, 1),
                                 WeatherLayout::epw)
            .find("w:1:1: error: expected LOCATION, city, state, country, source, WMO number, "
                  "latitude, longitude, hours ahead of UTC, height\n") == 0);
  CHECK(weather_mistakes_message("LOCATION,A,-,-,-,0,50.0,8.0,1.0,100\n", WeatherLayout::epw) ==
        "w: error: the DATA PERIODS line is missing from the eight header lines\n");
  CHECK(weather_mistakes_message(support::epw_header() + "2001,6,31,1,60,x\n", WeatherLayout::epw)
            .find("w:9:1: error: expected 24 to 35 cells, found 6\n") == 0);
  CHECK(weather_mistakes_message(support::epw_header() + support::epw_row({2001, 6, 31}, 1),
                                 WeatherLayout::epw)
            .find("w:9:8: error: the month has no such day\n") == 0);
  CHECK(weather_mistakes_message(support::epw_header() + support::epw_row(day, 1, "80.5"),
                                 WeatherLayout::epw)
            .find("w:9:27: error: dry bulb temperature (C) is 80.5, which no weather is: it must "
                  "lie from -93.15 to 61.85\n") == 0);
  CHECK(weather_mistakes_message(support::surfrad_header() + " 2010 171 6 20 0 0\n",
                                 WeatherLayout::surfrad)
            .find("w:3:2: error: expected 48 numbers, found 6\n") == 0);
  CHECK(weather_mistakes_message("A\n 40 x 3\n", WeatherLayout::surfrad)
            .find("w:2:5: error: expected the station's longitude in degrees from -180 to 360, "
                  "found \"x\"\n") == 0);
}

TEST_CASE("a file that is no weather says what would be", "[sim][weather]") {
  CHECK(weather_mistakes_message("height_m,pressure_hpa\n0,1013\n", std::nullopt) ==
        "w:1:1: error: this is no weather that can be read: an EPW file begins with LOCATION, the "
        "second line of a TMY3 file with Date (MM/DD/YYYY) and that of a SURFRAD file with "
        "latitude, longitude and height; the header of a CSV has a column \"utc\" or \"local\"\n"
        "    1 | height_m,pressure_hpa\n"
        "      | ^\n");
}

}  // namespace
}  // namespace nadir::sim
