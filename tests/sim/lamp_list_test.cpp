#include "sim/files/lamp_list.hpp"

#include "core/error.hpp"
#include "sim/message_of.hpp"
#include "support/catch.hpp"

using namespace nadir;
using namespace nadir::sim;

TEST_CASE("a list of lamps needs a place and takes what else it is given", "[sim][lamps]") {
  const auto plain = parse_lamp_list("# street\neast_m,north_m\n1.5,-2\n\n3,4\r\n", "lamps.csv");
  REQUIRE(plain.size() == 2);
  CHECK(plain[0].position == Vec3{1.5, -2.0, 0.0});
  CHECK_FALSE(plain[0].lumens);
  CHECK(plain[1].line == 5);
  const auto full = parse_lamp_list(
      "lumens, colour_temperature_k, yaw_deg, up_m, north_m, east_m\n"
      "8000, 3000, 90, 8, 2, 1\n",
      "lamps.csv");
  REQUIRE(full.size() == 1);
  CHECK(full[0].position == Vec3{1.0, 2.0, 8.0});
  CHECK(full[0].yaw_deg == 90.0);
  CHECK(full[0].lumens == 8000.0);
  CHECK(full[0].colour_temperature_k == 3000.0);
}

TEST_CASE("all mistakes in a list of lamps have their places", "[sim][lamps]") {
  const auto message = [](const char* text) {
    return support::message_of([&] { (void)parse_lamp_list(text, "lamps.csv"); });
  };
  CHECK(message("east_m,north_m,lumens\n1,2,-5\n1,2\n1,,3\n") ==
        "lamps.csv:2:5: error: lumens must lie from 0 to 1e+12\n"
        "    2 | 1,2,-5\n"
        "      |     ^\n"
        "lamps.csv:3:1: error: expected 3 cells, found 2\n"
        "    3 | 1,2\n"
        "      | ^\n"
        "lamps.csv:4:3: error: expected a finite number for north_m, found \"\"\n"
        "    4 | 1,,3\n"
        "      |   ^\n");
  CHECK(message("east_m,nort_m,east_m\n1,2,3\n") ==
        "lamps.csv:1:8: error: unknown column \"nort_m\"\n"
        "    1 | east_m,nort_m,east_m\n"
        "      |        ^\n"
        "    hint: did you mean \"north_m\"?\n"
        "lamps.csv:1:15: error: the column \"east_m\" is there twice\n"
        "    1 | east_m,nort_m,east_m\n"
        "      |               ^\n"
        "lamps.csv:1:1: error: the column \"north_m\" is missing\n"
        "    1 | east_m,nort_m,east_m\n"
        "      | ^\n");
  CHECK(message("") == "lamps.csv: error: the table is empty: its first row names the columns\n");
  CHECK(message("east_m,north_m\n") == "lamps.csv: error: the table has no rows\n");
  CHECK_THROWS_AS(read_lamp_list("/nowhere/lamps.csv"), InputError);
}
