#include "sim/files/temperature_table.hpp"

#include "core/error.hpp"
#include "sim/message_of.hpp"
#include "support/catch.hpp"

using namespace nadir;
using namespace nadir::sim;

namespace {

ephemeris::Instant moment(const char* utc) { return ephemeris::Instant::parse_utc(utc); }

const std::string two_hours =
    "# a roof\nutc,station_c,temperature_k\n2020-06-01T10:00:00Z,20,290\n\n"
    "2020-06-01T12:00:00Z,24,300\r\n2020-06-01T12:30:00Z,25.5,297\n";

std::string table_message(const std::string& text, const std::string& column = {}) {
  return support::message_of([&] { (void)parse_temperature_table(text, "roof.csv", column); });
}

}  // namespace

// 1e-9: times are good to 1e-10 s, slopes are 10 K in two hours.
TEST_CASE("a table of temperatures runs linearly between its times", "[sim][temperature]") {
  const TemperatureTable table = parse_temperature_table(two_hours, "roof.csv");
  CHECK(table.at(moment("2020-06-01T10:00:00Z")).value == 290.0);
  CHECK(table.at(moment("2020-06-01T10:30:00Z")).value == Approx(292.5).epsilon(1e-9));
  CHECK(table.at(moment("2020-06-01T12:00:00Z")).value == Approx(300.0).epsilon(1e-12));
  CHECK(table.at(moment("2020-06-01T12:20:00Z")).value == Approx(298.0).epsilon(1e-9));
  CHECK(table.at(moment("2020-06-01T12:30:00Z")).value == 297.0);
}

TEST_CASE("the column of a table of temperatures tells its unit", "[sim][temperature]") {
  const auto named = parse_temperature_table(two_hours, "roof.csv", "station_c");
  CHECK(named.at(moment("2020-06-01T10:00:00Z")).value == Approx(293.15).epsilon(1e-12));
  const auto celsius =
      parse_temperature_table("temperature_c,utc\n-3,2020-06-01T10:00:00Z\n", "roof.csv");
  CHECK(celsius.at(moment("2020-06-01T10:00:00Z")).value == Approx(270.15).epsilon(1e-12));
  CHECK(
      table_message("utc,roof\n2020-06-01T10:00:00Z,1\n", "roof") ==
      "roof.csv: error: the name of column \"roof\" must end in _k or _c, which tells its unit\n");
}

TEST_CASE("a moment outside a table of temperatures is a mistake", "[sim][temperature]") {
  const TemperatureTable table = parse_temperature_table(two_hours, "roof.csv");
  CHECK(support::message_of([&] { (void)table.at(moment("2020-06-01T09:59:59Z")); }) ==
        "roof.csv: error: the table runs from 2020-06-01T10:00:00Z to 2020-06-01T12:30:00Z, which "
        "does not cover 2020-06-01T09:59:59Z\n");
  CHECK_THROWS_AS(table.at(moment("2021-06-01T11:00:00Z")), InputError);
}

TEST_CASE("all mistakes in a table of temperatures have their places", "[sim][temperature]") {
  CHECK(table_message("utc,temperature_k\n2020-06-01T10:00:00,290\n2020-06-01T11:00:00Z,-4\n"
                      "2020-06-01T12:00:00Z,warm\n2020-06-01T12:00:00Z,290,\n"
                      "2020-06-01T12:00:00Z,290\n2020-06-01T12:00:00Z,6001\n"
                      "2020-06-01T12:00:00Z,290\n")
            .find("roof.csv:2:1: error: ") == 0);
  CHECK(table_message("utc,temperature_k\n2020-06-01T11:00:00Z,-4\n2020-06-01T12:00:00Z,warm\n"
                      "2020-06-01T12:00:00Z,290,\n2020-06-01T12:00:00Z,290\n"
                      "2020-06-01T12:00:00Z,290\n") ==
        "roof.csv:2:22: error: the temperature -4 K is not from 0 to 6000 K\n"
        "    2 | 2020-06-01T11:00:00Z,-4\n"
        "      |                      ^\n"
        "    hint: a column in degrees Celsius ends in _c\n"
        "roof.csv:3:22: error: expected a finite temperature, found \"warm\"\n"
        "    3 | 2020-06-01T12:00:00Z,warm\n"
        "      |                      ^\n"
        "roof.csv:4:1: error: expected 2 cells, found 3\n"
        "    4 | 2020-06-01T12:00:00Z,290,\n"
        "      | ^\n"
        "roof.csv:6:1: error: times must ascend: this one follows 2020-06-01T12:00:00Z\n"
        "    6 | 2020-06-01T12:00:00Z,290\n"
        "      | ^\n");
  CHECK(table_message("time,temperatur_k\n1,2\n") ==
        "roof.csv:1:1: error: there is no column utc\n"
        "    1 | time,temperatur_k\n"
        "      | ^\n"
        "roof.csv:1:1: error: there is no column temperature_k or temperature_c\n"
        "    1 | time,temperatur_k\n"
        "      | ^\n");
  CHECK(table_message("") ==
        "roof.csv: error: the table is empty: its first row names the columns\n");
  CHECK(table_message("utc,temperature_k\n") == "roof.csv: error: the table has no rows\n");
}
