#include "sim/files/view_table_file.hpp"

#include <cmath>
#include <numbers>

#include "message_of.hpp"
#include "support/catch.hpp"

using namespace nadir;
using nadir::sim::support::message_of;

namespace {

std::string told_of_view_table(const std::string& text) {
  return message_of([&] { static_cast<void>(sim::parse_view_table(text, "views.csv")); });
}

}  // namespace

TEST_CASE("a view table of directions arrives on its grid, whatever the order of its rows",
          "[files][view_table]") {
  const auto table = sim::parse_view_table(
      "line,sample,x,y,z\n"
      "4.5,10.5,0.1,0.2,1\n0.5,0.5,-0.1,0,1\n0.5,10.5,0.1,0,2\n4.5,0.5,0,0,5\n",
      "views.csv");
  CHECK(table.samples == 2);
  CHECK(table.lines == 2);
  CHECK(table.sample_step == 10.0);
  CHECK(table.line_step == 4.0);
  REQUIRE(table.directions.size() == 4);
  const double size = std::sqrt(0.1 * 0.1 + 4.0);
  // margins: rounding of a root and a division
  CHECK(table.directions[1].x == Approx(0.1 / size).epsilon(1e-14));
  CHECK(table.directions[1].z == Approx(2.0 / size).epsilon(1e-14));
  CHECK(table.directions[2].z == Approx(1.0).epsilon(1e-14));
  CHECK(table.directions[3].y == Approx(0.2 / std::sqrt(1.05)).epsilon(1e-14));
}

TEST_CASE("angles count from the line of sight, to image right and image down",
          "[files][view_table]") {
  const auto table = sim::parse_view_table(
      "# one row of a pushbroom\nsample,across_deg,along_deg\n0.5,-10,1\n1.5,10,1\n", "views.csv");
  CHECK(table.lines == 1);
  CHECK(table.sample_step == 1.0);
  const Vec3 right = table.directions[1];
  const double deg = std::numbers::pi / 180.0;
  CHECK(right.x / right.z == Approx(std::tan(10.0 * deg)).epsilon(1e-14));  // rounding
  CHECK(right.y / right.z == Approx(std::tan(1.0 * deg)).epsilon(1e-14));
  CHECK(table.directions[0].x == -right.x);
  CHECK(length(right) == Approx(1.0).epsilon(1e-14));
}

TEST_CASE("what is no grid of lines of sight is told of with its place", "[files][view_table]") {
  const std::string head = "sample,line,x,y,z\n";
  CHECK(told_of_view_table(head + "1,0.5,0,0,1\n2,0.5,0,0,1\n") ==
        "views.csv:2: error: the first sample is 1, expected 0.5, the centre of the first pixel\n");
  CHECK(told_of_view_table(head + "0.5,0.5,0,0,1\n1.5,0.5,0,0,1\n3.5,0.5,0,0,1\n") ==
        "views.csv:3: error: sample 1.5 is not on an even grid: 3 from 0.5 to 3.5 have one at 2\n");
  CHECK(told_of_view_table(head + "0.5,0.5,0,0,1\n1.5,0.5,0,0,1\n0.5,1.5,0,0,1\n") ==
        "views.csv: error: the grid lacks the pixel at sample 1.5, line 1.5\n");
  CHECK(told_of_view_table(head + "0.5,0.5,0,0,1\n1.5,0.5,0,0,1\n1.5,0.5,0,0,1\n") ==
        "views.csv:4: error: this pixel is there already, in line 3\n");
  CHECK(told_of_view_table(head + "0.5,0.5,0,0,1\n1.5,0.5,0,0,0\n") ==
        "views.csv:3: error: the direction x, y, z has no length\n");
  CHECK(told_of_view_table(head + "0.5,0.5,0,0,1\n") ==
        "views.csv: error: a view table needs at least two samples\n");
  CHECK(told_of_view_table("sample,x,y,along_deg\n0.5,0,0,1\n") ==
        "views.csv: error: lines of sight are given by the columns x, y and z, or by across_deg "
        "and along_deg\n");
  CHECK(told_of_view_table("sample,across_deg,along_deg\n0.5,90,0\n1.5,nan,0\n") ==
        "views.csv:2:5: error: across_deg must lie from -89 to 89\n"
        "    2 | 0.5,90,0\n"
        "      |     ^\n"
        "views.csv:3:5: error: expected a finite number for across_deg, found \"nan\"\n"
        "    3 | 1.5,nan,0\n"
        "      |     ^\n");
}
