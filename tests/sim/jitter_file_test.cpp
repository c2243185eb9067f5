#include "sim/files/jitter_file.hpp"

#include "sim/message_of.hpp"
#include "support/catch.hpp"

using namespace nadir;
using namespace nadir::sim;

namespace {

std::string jitter_message(const std::string& text) {
  return support::message_of([&] { (void)parse_jitter_file(text, "shake.csv"); });
}

}  // namespace

TEST_CASE("a spectrum of shaking has the axes that its columns name", "[sim][jitter_file]") {
  const JitterFile jitter =
      parse_jitter_file("frequency_hz,z_rad2_hz,x_rad2_hz\n1,2e-12,1e-12\n10,0,3e-12\n", "a.csv");
  CHECK(jitter.frequencies_hz == std::vector<double>{1.0, 10.0});
  CHECK(jitter.density_rad2_hz[0] == std::vector<double>{1e-12, 3e-12});
  CHECK(jitter.density_rad2_hz[1].empty());
  CHECK(jitter.density_rad2_hz[2] == std::vector<double>{2e-12, 0.0});
}

TEST_CASE("mistakes in a spectrum of shaking have their places", "[sim][jitter_file]") {
  CHECK(jitter_message("frequency_hz,y_rad_hz\n1,2\n") ==
        "shake.csv:1:14: error: unknown column \"y_rad_hz\"\n"
        "    1 | frequency_hz,y_rad_hz\n"
        "      |              ^\n"
        "    hint: did you mean \"y_rad2_hz\"?\n");
  CHECK(jitter_message("x_rad2_hz\n1\n") ==
        "shake.csv:1:1: error: the column \"frequency_hz\" is missing\n"
        "    1 | x_rad2_hz\n"
        "      | ^\n");
  CHECK(jitter_message("frequency_hz\n1\n2\n") ==
        "shake.csv:1:1: error: expected at least one of the columns x_rad2_hz, y_rad2_hz, "
        "z_rad2_hz\n"
        "    1 | frequency_hz\n"
        "      | ^\n");
  CHECK(jitter_message("frequency_hz,x_rad2_hz\n0,1e-12\n2,-1e-12\n") ==
        "shake.csv:2:1: error: frequency_hz must lie from 1e-09 to 1e+09\n"
        "    2 | 0,1e-12\n"
        "      | ^\n"
        "shake.csv:3:3: error: x_rad2_hz must lie from 0 to 1000\n"
        "    3 | 2,-1e-12\n"
        "      |   ^\n");
  CHECK(jitter_message("frequency_hz,x_rad2_hz\n5,1e-12\n2,1e-12\n") ==
        "shake.csv:3:1: error: frequency_hz must ascend: 2 follows 5\n"
        "    3 | 2,1e-12\n"
        "      | ^\n");
  CHECK(jitter_message("frequency_hz,x_rad2_hz\n5,1e-12\n") ==
        "shake.csv: error: a spectrum needs at least two rows\n");
}
