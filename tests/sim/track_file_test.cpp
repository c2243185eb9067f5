#include "sim/files/track_file.hpp"

#include "sim/message_of.hpp"
#include "support/catch.hpp"

using namespace nadir;
using namespace nadir::sim;

namespace {

const char* const noon = "2026-06-21T12:00:00Z";

TrackFile parse_track(const std::string& text) {
  return parse_track_file(text, "way.csv", ephemeris::Instant::parse_utc(noon));
}
std::string track_message(const std::string& text) {
  return support::message_of([&] { (void)parse_track(text); });
}

}  // namespace

TEST_CASE("a way has its times and places in any of three axes", "[sim][track_file]") {
  const TrackFile geodetic = parse_track(
      "# flown\nlongitude_deg, latitude_deg, height_m, "
      "time_s\n-84,36,1000,-1.5\n-84.1,36,1001,2\n");
  CHECK(geodetic.axes == TrackFile::Axes::geodetic);
  CHECK(geodetic.times_s == std::vector<double>{-1.5, 2.0});
  REQUIRE(geodetic.points.size() == 2);
  CHECK(geodetic.points[0] == Vec3{36.0, -84.0, 1000.0});
  CHECK(geodetic.points[1] == Vec3{36.0, -84.1, 1001.0});
  const TrackFile earth = parse_track("time_s,x_m,y_m,z_m\n0,7e6,1,2\n1,7e6,3,4\n");
  CHECK(earth.axes == TrackFile::Axes::earth);
  CHECK(earth.points[1] == Vec3{7e6, 3.0, 4.0});
  const TrackFile scene = parse_track("time_s,east_m,north_m,up_m\n0,1,2,3\n1,4,5,6\n");
  CHECK(scene.axes == TrackFile::Axes::scene);
  CHECK(scene.points[1] == Vec3{4.0, 5.0, 6.0});
}

TEST_CASE("moments in UTC count from the origin, leap seconds included", "[sim][track_file]") {
  const TrackFile way = parse_track(
      "time_utc,east_m,north_m,up_m\n2026-06-21T11:59:59.5Z,0,0,1\n2026-06-21T12:00:10Z,0,1,1\n");
  REQUIRE(way.times_s.size() == 2);
  // Instants are good to 1e-10 s.
  CHECK(way.times_s[0] == Approx(-0.5).margin(1e-9));
  CHECK(way.times_s[1] == Approx(10.0).margin(1e-9));
  const TrackFile leap = parse_track_file(
      "time_utc,east_m,north_m,up_m\n2016-12-31T23:59:60Z,0,0,1\n"
      "2017-01-01T00:00:00Z,0,1,1\n",
      "way.csv", ephemeris::Instant::parse_utc("2016-12-31T23:59:59Z"));
  CHECK(leap.times_s[0] == Approx(1.0).margin(1e-9));
  CHECK(leap.times_s[1] == Approx(2.0).margin(1e-9));
}

TEST_CASE("columns of a way that are missing, unknown or too many are told", "[sim][track_file]") {
  CHECK(track_message("time_s,latitude_deg,longitude_deg\n0,36,-84\n1,36,-84\n") ==
        "way.csv:1:1: error: the column \"height_m\" is missing\n"
        "    1 | time_s,latitude_deg,longitude_deg\n"
        "      | ^\n");
  CHECK(track_message("time_s,lattitude_deg,longitude_deg,height_m\n0,36,-84,1\n1,36,-84,1\n") ==
        "way.csv:1:8: error: unknown column \"lattitude_deg\"\n"
        "    1 | time_s,lattitude_deg,longitude_deg,height_m\n"
        "      |        ^\n"
        "    hint: did you mean \"latitude_deg\"?\n");
  CHECK(track_message("time_s,time_utc\n0,2026-06-21T12:00:00Z\n1,2026-06-21T12:00:01Z\n") ==
        "way.csv:1:1: error: expected the columns latitude_deg, longitude_deg, height_m or x_m, "
        "y_m, z_m or east_m, north_m, up_m\n"
        "    1 | time_s,time_utc\n"
        "      | ^\n"
        "way.csv:1:1: error: give either the column time_s or time_utc, not both\n"
        "    1 | time_s,time_utc\n"
        "      | ^\n");
  CHECK(track_message("x_m,y_m,z_m,up_m\n1,2,3,4\n1,2,3,5\n") ==
        "way.csv:1:1: error: give either the columns x_m, y_m, z_m or east_m, north_m, up_m, not "
        "both\n"
        "    1 | x_m,y_m,z_m,up_m\n"
        "      | ^\n"
        "way.csv:1:1: error: expected the column time_s or time_utc\n"
        "    1 | x_m,y_m,z_m,up_m\n"
        "      | ^\n");
}

TEST_CASE("rows of a way that make no sense have their places", "[sim][track_file]") {
  CHECK(track_message(
            "time_s,latitude_deg,longitude_deg,height_m\n0,91,-84,1\n1,36,-84,1e9\n1,x,-84,1\n") ==
        "way.csv:2:3: error: latitude_deg must lie from -90 to 90\n"
        "    2 | 0,91,-84,1\n"
        "      |   ^\n"
        "way.csv:3:10: error: height_m must lie from -10000 to 1e+08\n"
        "    3 | 1,36,-84,1e9\n"
        "      |          ^\n"
        "way.csv:4:3: error: expected a finite number for latitude_deg, found \"x\"\n"
        "    4 | 1,x,-84,1\n"
        "      |   ^\n");
  CHECK(track_message("east_m,north_m,up_m,time_s\n1,2,3, 5\n1,2,3, 5\n1,2,3, 4\n") ==
        "way.csv:3:8: error: time_s must ascend: 5 follows 5\n"
        "    3 | 1,2,3, 5\n"
        "      |        ^\n"
        "way.csv:4:8: error: time_s must ascend: 4 follows 5\n"
        "    4 | 1,2,3, 4\n"
        "      |        ^\n");
  CHECK(track_message("time_utc,east_m,north_m,up_m\n2026-02-30T00:00:00Z,1,2,3\n") ==
        "way.csv:2:1: error: time_utc: time \"2026-02-30T00:00:00Z\": month 2 of 2026 has 28 days\n"
        "    2 | 2026-02-30T00:00:00Z,1,2,3\n"
        "      | ^\n");
  CHECK(track_message("time_s,east_m,north_m,up_m\n0,1,2,3\n") ==
        "way.csv: error: a way needs at least two rows\n");
}
