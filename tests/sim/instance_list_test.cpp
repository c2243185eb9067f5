#include "sim/files/instance_list.hpp"

#include <numbers>

#include "core/error.hpp"
#include "support/catch.hpp"

using namespace nadir;
using namespace nadir::sim;

namespace {

std::vector<InputIssue> instance_list_issues_of(const std::string& text) {
  try {
    (void)parse_instance_list(text, "trees.csv");
  } catch (const InputError& error) {
    return error.issues();
  }
  return {};
}

double distance(Vec3 a, Vec3 b) { return length(a - b); }

}  // namespace

TEST_CASE("a list of instances needs east and north and defaults the rest") {
  const auto list = parse_instance_list("# trees\neast_m,north_m\n1.5,-2\n\n3,4\r\n", "trees.csv");
  REQUIRE(list.size() == 2);
  CHECK(list[0].position == Vec3{1.5, -2.0, 0.0});
  CHECK(list[0].scale == Vec3{1.0, 1.0, 1.0});
  CHECK(list[0].yaw_deg == 0.0);
  CHECK(list[1].position == Vec3{3.0, 4.0, 0.0});
}

TEST_CASE("the columns of a list come in any order") {
  const auto list = parse_instance_list(
      "scale_z, north_m, east_m, up_m, yaw_deg, pitch_deg, roll_deg, scale_x\n"
      "2, 1, 0, 5, 90, 10, -20, 0.5\n",
      "trees.csv");
  REQUIRE(list.size() == 1);
  CHECK(list[0].line == 2);
  CHECK(list[0].position == Vec3{0.0, 1.0, 5.0});
  CHECK(list[0].scale == Vec3{0.5, 1.0, 2.0});
  CHECK(list[0].yaw_deg == 90.0);
  CHECK(list[0].pitch_deg == 10.0);
  CHECK(list[0].roll_deg == -20.0);
  const auto uniform = parse_instance_list("east_m,north_m,scale\n0,0,3\n", "a.csv");
  CHECK(uniform[0].scale == Vec3{3.0, 3.0, 3.0});
}

TEST_CASE("yaw is an azimuth, pitch lifts the nose, roll lowers the right side") {
  Placement p;
  p.yaw_deg = 90.0;  // the nose (y) points east, the right side (x) south
  CHECK(affine(p).vector({0, 1, 0}) == Vec3{1, 0, 0});
  CHECK(affine(p).vector({1, 0, 0}) == Vec3{0, -1, 0});
  p.yaw_deg = 30.0;
  CHECK(distance(affine(p).vector({0, 1, 0}), {0.5, std::sqrt(0.75), 0.0}) < 1e-15);
  p = {};
  p.pitch_deg = 90.0;
  CHECK(affine(p).vector({0, 1, 0}) == Vec3{0, 0, 1});
  p = {};
  p.roll_deg = 90.0;
  CHECK(affine(p).vector({1, 0, 0}) == Vec3{0, 0, -1});
}

TEST_CASE("scale comes first, then roll, pitch, yaw and the position") {
  Placement p;
  p.position = {10.0, 20.0, 30.0};
  p.yaw_deg = 40.0;
  p.pitch_deg = 25.0;
  p.roll_deg = -70.0;
  p.scale = {2.0, 3.0, 0.5};
  const double degree = std::numbers::pi / 180.0;
  const Mat3 expected = rotation({0, 0, 1}, -40.0 * degree) * rotation({1, 0, 0}, 25.0 * degree) *
                        rotation({0, 1, 0}, -70.0 * degree) * scaling(p.scale);
  for (const Vec3 v : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}}) {
    CHECK(distance(affine(p).vector(v), expected * v) < 1e-14);
  }
  CHECK(affine(p).point({}) == p.position);
  CHECK(affine(p).linear.determinant() == Approx(3.0).epsilon(1e-14));
}

TEST_CASE("quarter turns are exact, however often they go round") {
  for (int quarter = -9; quarter <= 9; ++quarter) {
    Placement p;
    p.yaw_deg = 90.0 * quarter;
    const int turn = ((quarter % 4) + 4) % 4;
    const Vec3 noses[4] = {{0, 1, 0}, {1, 0, 0}, {0, -1, 0}, {-1, 0, 0}};
    CHECK(affine(p).vector({0, 1, 0}) == noses[turn]);
  }
}

TEST_CASE("a list in a list is flattened by composing its placements") {
  Placement village, house;
  village.position = {100.0, 0.0, 0.0};
  village.yaw_deg = 90.0;
  house.position = {0.0, 10.0, 0.0};
  const auto all = flatten({Affine{}, affine(village)}, {affine(house), Affine{}, affine(house)});
  REQUIRE(all.size() == 6);
  CHECK(all[0].point({}) == Vec3{0, 10, 0});
  CHECK(all[3].point({}) == Vec3{110, 0, 0});  // ten metres ahead of a village that faces east
  CHECK(all[4].point({}) == Vec3{100, 0, 0});
}

TEST_CASE("all mistakes in a list have their places") {
  const auto issues =
      instance_list_issues_of("east_m,north_m,scale\n1,2,x\n1,2\n1,,1\n1,2,0\n1e999, 1,5 \n");
  REQUIRE(issues.size() == 5);
  const int places[5][2] = {{2, 5}, {3, 1}, {4, 3}, {5, 5}, {6, 1}};
  for (std::size_t i = 0; i < 5; ++i) {
    CHECK(issues[i].where.line == places[i][0]);
    CHECK(issues[i].where.column == places[i][1]);
  }
  CHECK(issues[0].message == "expected a finite number for scale, found \"x\"");
  CHECK(issues[1].message == "expected 3 cells, found 2");
  CHECK(issues[3].message == "scale must lie between 1e-6 and 1e6, or their negatives");
}

TEST_CASE("a list with wrong columns says which are right") {
  auto issues = instance_list_issues_of("east_m,nort_m,yaw\n1,2,3\n");
  REQUIRE(issues.size() == 3);
  CHECK(issues[0].hint == "did you mean \"north_m\"?");
  CHECK(issues[0].where.column == 8);
  CHECK(issues[2].message == "the column \"north_m\" is missing");
  CHECK(instance_list_issues_of("east_m,north_m,east_m\n").size() == 1);
  CHECK(instance_list_issues_of("east_m,north_m,scale,scale_x\n").size() == 1);
  CHECK(instance_list_issues_of("").size() == 1);
  CHECK_THROWS_AS(read_instance_list("/nowhere/trees.csv"), InputError);
}
