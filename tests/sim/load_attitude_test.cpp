#include "sim/run/load_attitude.hpp"

#include <algorithm>

#include "geometry/scene_builder.hpp"
#include "sim/platform_loading.hpp"
#include "support/catch.hpp"

using namespace nadir;
using namespace nadir::sim;
using support::PlatformLoading;

namespace {

double axes_apart(const Mat3& a, const Mat3& b) {
  return std::max({length(a.x - b.x), length(a.y - b.y), length(a.z - b.z)});
}

/// A platform that flies north over the site.
class Northward : public PlatformLoading {
 public:
  Northward() {
    platform().position = StraightInput{{Vec3{0.0, 0.0, 2000.0}, false}, 0.0, 70.0, 0.0};
  }

  void table(const std::string& content, sensor::Reference reference,
             std::optional<double> max_gap_s = {}) {
    platform().attitude = AttitudeTableInput{text("turn.csv", content), reference, max_gap_s};
  }
};

TerrainProbe ground_at(double height_m) {
  geometry::SceneBuilder builder;
  builder.add({geometry::Shape{geometry::Plane{{}, 200.0, 200.0}}, {0}},
              Affine{{}, {0.0, 0.0, height_m}}, 0);
  return TerrainProbe{builder.build()};
}

}  // namespace

// 1e-8: Platform keeps to 1e-9 rad of the law.
TEST_CASE("angles of a table are those of the elements of the same name", "[sim][platform]") {
  Northward flight;
  flight.platform().attitude = EulerInput{30.0, -60.0, 10.0};
  const Mat3 euler = flight.load({0.0, 2.0}).at(1.0).axes;
  flight.table("time_s,yaw_deg,pitch_deg,roll_deg\n0,30,-60,10\n", sensor::Reference::local);
  CHECK(axes_apart(flight.load({0.0, 2.0}).at(1.0).axes, euler) < 1e-8);
  sensor::TrackAttitude track;
  track.yaw = degrees(3.0);
  track.pitch = degrees(4.0);
  track.roll = degrees(5.0);
  flight.platform().attitude = track;
  const Mat3 nadir = flight.load({0.0, 2.0}).at(1.0).axes;
  flight.table("time_s,yaw_deg,pitch_deg,roll_deg\n0,3,4,5\n2,3,4,5\n", sensor::Reference::orbit);
  CHECK(axes_apart(flight.load({0.0, 2.0}).at(1.0).axes, nadir) < 1e-8);
  // Signs against the flight north: pitch looks ahead, roll to the right, which is east.
  CHECK(nadir.z.y > 0.05);
  CHECK(nadir.z.x > 0.05);
}

TEST_CASE("between the rows of a table a platform turns evenly, whatever their signs",
          "[sim][platform]") {
  Northward flight;
  const double c = std::cos(degrees(20.0).value), s = std::sin(degrees(20.0).value);
  flight.table(
      "time_s,w,x,y,z\n0,1,0,0,0\n4," + std::to_string(-c) + ",0,0," + std::to_string(-s) + "\n",
      sensor::Reference::scene);
  // Half the way: 20 of 40 degrees. 2e-6: the table's six decimals.
  CHECK(axes_apart(flight.load({0.0, 4.0}).at(2.0).axes,
                   rotation({0.0, 0.0, 1.0}, degrees(20.0).value)) < 2e-6);
}

TEST_CASE("quaternions are taken against the axes that they name", "[sim][platform]") {
  Northward flight;
  flight.platform().attitude = QuaternionInput{sensor::Reference::earth, {}};
  const sensor::Platform inertial = flight.load({0.0, 1.0});
  const geometry::LocalFrame frame = flight.frame();
  const Vec3 pole = frame.enu_from_ecef({0.0, 0.0, 1.0}) - frame.enu_from_ecef({});
  CHECK(length(inertial.at(0.5).axes.z - pole) < 1e-8);
  flight.platform().position = Vec3{0.0, 0.0, 5.0};
  flight.platform().attitude = QuaternionInput{sensor::Reference::scene, {0.0, 1.0, 0.0, 0.0}};
  const sensor::Platform still = flight.load();
  CHECK(still.is_fixed());
  CHECK(length(still.at(0.0).axes.z - Vec3{0.0, 0.0, -1.0}) < 1e-15);
}

TEST_CASE("times outside a way or a table of attitudes say both spans", "[sim][platform]") {
  Northward flight;
  flight.table("time_s,w,x,y,z\n0,1,0,0,0\n2,1,0,0,0\n", sensor::Reference::scene);
  CHECK(flight.message({0.0, 2.0}) == "(nothing thrown)");
  CHECK(flight.message({-0.5, 2.0}) ==
        "a.xml:16:15: error: attitude gap: the camera looks from -0.5 s to 2 s after the "
        "scenario's time, but turn.csv covers 0 s to 2 s\n");
  flight.platform().position = WaypointsInput{
      flight.text("way.csv", "time_s,east_m,north_m,up_m\n0,0,0,9\n1.5,1,0,9\n"), false};
  CHECK(flight.message({0.0, 2.0}) ==
        "a.xml:15:15: error: time outside the trajectory: the camera looks from 0 s to 2 s after "
        "the scenario's time, but way.csv covers 0 s to 1.5 s\n");
}

TEST_CASE("a table of attitudes may not have gaps", "[sim][platform]") {
  Northward flight;
  const std::string holed = "time_s,w,x,y,z\n0,1,0,0,0\n1,1,0,0,0\n9,1,0,0,0\n10,1,0,0,0\n";
  flight.table(holed, sensor::Reference::scene, 2.0);
  CHECK(flight.message({0.0, 1.0}) == "(nothing thrown)");
  CHECK(flight.message({9.0, 10.0}) == "(nothing thrown)");
  CHECK(flight.message({0.0, 1.5}) ==
        "a.xml:16:15: error: attitude gap: the camera looks between 1 s and 9 s, where no row "
        "stands for 8 s; max_gap_s is 2\n");
  std::string long_one = "time_s,w,x,y,z\n";
  for (const char* time : {"0", "1", "2", "3", "4", "9.5", "10.5", "11.5", "12.5"}) {
    long_one += std::string{time} + ",1,0,0,0\n";
  }
  flight.table(long_one, sensor::Reference::scene);
  CHECK(flight.message({0.0, 4.0}) == "(nothing thrown)");
  CHECK(flight.message({4.0, 4.0}) == "(nothing thrown)");
  CHECK(flight.message({3.0, 4.5}) ==
        "a.xml:16:15: error: attitude gap: the camera looks between 4 s and 9.5 s, where no row "
        "stands for 5.5 s; without max_gap_s the limit is five times the median step, 5\n");
  flight.table(long_one, sensor::Reference::scene, 6.0);
  CHECK(flight.message({3.0, 4.5}) == "(nothing thrown)");
  flight.table("time_s,w,x,y,z\n0,1,0,0,0\n2,0,0,0,1\n", sensor::Reference::scene);
  CHECK(flight.message({0.0, 2.0}) ==
        "turn.csv:3: error: attitude gap: the platform turns by 180.0 degrees between 0 s and 2 s; "
        "at most 90 can be told from the other way round\n");
  flight.table("time_s,yaw_deg,pitch_deg,roll_deg\n0,3,4,5\n", sensor::Reference::earth);
  CHECK(flight.message() ==
        "a.xml:16:15: error: yaw_deg, pitch_deg, roll_deg mean nothing in the axes of the earth: "
        "give w, x, y, z, or another reference\n");
}

TEST_CASE("a camera under ground is refused where there is ground", "[sim][platform]") {
  PlatformLoading still;
  still.platform().position = Vec3{10.0, 20.0, 29.5};
  CHECK(still.message({}, ground_at(30.0)) ==
        "a.xml:15:15: error: camera under ground: it lies 0.500 m below the terrain\n");
  CHECK(still.message() == "(nothing thrown)");
  still.platform().position = Vec3{1000.0, 20.0, -5.0};  // beside the terrain
  CHECK(still.message({}, ground_at(30.0)) == "(nothing thrown)");
  still.platform().position = Vec3{10.0, 20.0, 0.0};
  still.platform().on_terrain = true;
  CHECK(still.message({}, ground_at(30.0)) == "(nothing thrown)");
  Northward sinking;
  sinking.platform().position = WaypointsInput{
      sinking.text("way.csv", "time_s,east_m,north_m,up_m\n0,0,0,40\n4,0,0,20\n"), true};
  CHECK(sinking.message({0.0, 1.0}, ground_at(30.0)) == "(nothing thrown)");
  CHECK(sinking.message({0.0, 3.0}, ground_at(30.0)) ==
        "a.xml:15:15: error: camera under ground: it lies 5.000 m below the terrain 3 s after the "
        "scenario's time\n");
  // Above ground in the beginning, in the middle and at the end, but not at a place of the way.
  sinking.platform().position =
      WaypointsInput{sinking.text("dip.csv",
                                  "time_s,east_m,north_m,up_m\n0,0,0,40\n1.0001,0,0,40\n"
                                  "1.0003,0,0,20\n1.0005,0,0,40\n4,0,0,40\n"),
                     true};
  CHECK(sinking.message({0.0, 4.0}, ground_at(30.0)) ==
        "a.xml:15:15: error: camera under ground: it lies 10.000 m below the terrain 1.0003 s "
        "after the scenario's time\n");
  CHECK(sinking.message({2.0, 4.0}, ground_at(30.0)) == "(nothing thrown)");
  // The same between the places of a way: the ground ends 100 m from its middle.
  sinking.platform().position = WaypointsInput{
      sinking.text("through.csv", "time_s,east_m,north_m,up_m\n0,-900,0,20\n4,500,0,20\n"), true};
  CHECK_THAT(sinking.message({0.0, 4.0}, ground_at(30.0)),
             Catch::Contains("it lies 10.000 m below the terrain"));
}

TEST_CASE("laws that mean nothing where the platform is are told at the element",
          "[sim][platform]") {
  Northward flight;
  flight.platform().position = sensor::Overpass{36.0, -84.0, 705e3, 20.0, true};
  CHECK(flight.message({0.0, 1.0}).starts_with("a.xml:15:15: error: "));
  flight.platform().position = Vec3{0.0, 0.0, 5.0};
  flight.platform().attitude = LookAtInput{Vec3{0.0, 0.0, 5.0}, false, 0.0};
  CHECK(flight.message() == "a.xml:16:15: error: the camera looks at its own position\n");
  flight.platform().position = Vec3{0.0, 0.0, 5.0};
  flight.platform().on_terrain = true;
  CHECK(flight.message() ==
        "a.xml:15:15: error: a height counts from the terrain, but there is no terrain\n");
}
