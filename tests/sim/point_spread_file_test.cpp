#include "sim/files/point_spread_file.hpp"

#include "message_of.hpp"
#include "support/catch.hpp"

using namespace nadir;
using nadir::sim::support::message_of;

namespace {

const std::string point_spread_head = "# nadir-point-spread: 1\n# title: a test\n# pitch_um: 2.5\n";

std::string told_of(const std::string& text) {
  return message_of([&] { static_cast<void>(sim::parse_point_spread(text, "psf.csv")); });
}

}  // namespace

TEST_CASE("a point spread table arrives as it stands in the file", "[files][point_spread]") {
  const auto spread = sim::parse_point_spread(
      "\xEF\xBB\xBF" + point_spread_head +
          "# free remark\nwavelength_um, 0.55\n0, 0.25, 0\n0.125,0.5,0.125\n\r\n"
          "wavelength_um,0.85\r\n0.25,0.25,0.25\r\n0.125,0,0.125\r\n",
      "psf.csv");
  CHECK(spread.columns == 3);
  CHECK(spread.rows == 2);
  CHECK(spread.pitch_m == Approx(2.5e-6).epsilon(1e-15));  // one product of doubles
  REQUIRE(spread.slices.size() == 2);
  CHECK(spread.slices[0].wavelength_um == 0.55);
  CHECK(spread.slices[0].weights == std::vector<double>{0.0, 0.25, 0.0, 0.125, 0.5, 0.125});
  CHECK(spread.slices[1].wavelength_um == 0.85);
  CHECK(spread.slices[1].weights.back() == 0.125);
}

TEST_CASE("a point spread that does not sum to one is told of with its sum",
          "[files][point_spread]") {
  CHECK(told_of(point_spread_head + "wavelength_um,0.5\n0.5,0.49\nwavelength_um,0.6\n0.5,0.49\n"
                                    "wavelength_um,0.7\n0.5,0.4995\n") ==
        "psf.csv:4:1: error: the weights of this wavelength sum to 0.99, not to 1\n"
        "    4 | wavelength_um,0.5\n"
        "      | ^\n"
        "psf.csv:6:1: error: the weights of this wavelength sum to 0.99, not to 1\n"
        "    6 | wavelength_um,0.6\n"
        "      | ^\n");
}

TEST_CASE("every mistake of a point spread table has its place", "[files][point_spread]") {
  CHECK(told_of(point_spread_head +
                "wavelength_um,0.5\n0.5,-0.5\n0.5,x\nwavelength_um,0.4\n0.5,0.5,0\n1,0\n") ==
        "psf.csv:5:5: error: expected a weight of 0 or more, found \"-0.5\"\n"
        "    5 | 0.5,-0.5\n"
        "      |     ^\n"
        "psf.csv:6:5: error: expected a weight of 0 or more, found \"x\"\n"
        "    6 | 0.5,x\n"
        "      |     ^\n"
        "psf.csv:7:15: error: wavelengths must ascend: 0.4 follows 0.5\n"
        "    7 | wavelength_um,0.4\n"
        "      |               ^\n"
        "psf.csv:8:1: error: expected 2 weights, found 3\n"
        "    8 | 0.5,0.5,0\n"
        "      | ^\n");
  CHECK(told_of(point_spread_head +
                "wavelength_um,0.5\n0.5\n0.5\nwavelength_um,0.6\n1\nwavelength_um,0.7\n") ==
        "psf.csv:7:1: error: expected 2 rows of weights, found 1\n"
        "    7 | wavelength_um,0.6\n"
        "      | ^\n"
        "psf.csv:9:1: error: no weights follow\n"
        "    9 | wavelength_um,0.7\n"
        "      | ^\n");
  CHECK(told_of("# nadir-point-spread: 1\n# pitch_m: 2\nwavelength_um,550\n1\n") ==
        "psf.csv:2:3: error: unknown key \"pitch_m\"\n"
        "    2 | # pitch_m: 2\n"
        "      |   ^\n"
        "    hint: did you mean \"pitch_um\"?\n"
        "psf.csv:3:15: error: expected a wavelength from 0.1 to 100 um, found \"550\"\n"
        "    3 | wavelength_um,550\n"
        "      |               ^\n");
  CHECK(told_of("# nadir-point-spread: 1\nwavelength_um,0.5\n1\n") ==
        "psf.csv: error: the table has no line \"# pitch_um: ...\"\n");
}

TEST_CASE("another kind of file is not taken for a point spread", "[files][point_spread]") {
  CHECK(told_of("a,b\n1,2\n").find("psf.csv:1:1: error: expected \"# nadir-point-spread: 1\"") ==
        0);
  CHECK(told_of("").find("psf.csv:1:1: error: expected \"# nadir-point-spread: 1\"") == 0);
  CHECK(told_of(point_spread_head + "0.5,0.5\n") ==
        "psf.csv:4:1: error: expected \"wavelength_um, ...\" before the first weights\n"
        "    4 | 0.5,0.5\n"
        "      | ^\n");
  CHECK(told_of(point_spread_head) == "psf.csv: error: the table has no \"wavelength_um, ...\"\n");
}
