#include <filesystem>
#include <fstream>

#include "scenario_support.hpp"
#include "support/catch.hpp"

using namespace nadir;
using namespace nadir::sim;
using test::minimal_text;
using test::mistake_lines;
using test::replaced;

namespace {

constexpr const char* still_platform = "<local east_m=\"0\" north_m=\"0\" up_m=\"1000\"/>";
constexpr const char* aimed = "<euler yaw_deg=\"0\" pitch_deg=\"-90\"/>";

/// The minimal scenario with another position (line 15) and attitude (line 16).
std::string flying(const std::string& position, const std::string& attitude = aimed,
                   const std::string& more = {}) {
  std::string text = replaced(minimal_text(), still_platform, position);
  text = replaced(text, aimed, attitude);
  return replaced(text, "</attitude>", "</attitude>" + more);
}

PlatformInput read_platform(const std::string& text) {
  Diagnostics diagnostics;
  return parse_scenario(text, test::data_folder() / "test.xml", diagnostics).platform;
}

constexpr const char* orbit =
    "<circular_orbit latitude_deg=\"36\" longitude_deg=\"-84\" height_m=\"705000\" "
    "inclination_deg=\"98.2\" direction=\"descending\"/>";

}  // namespace

TEST_CASE("a platform has a name and knows where its parts stand", "[scenario][platform]") {
  const PlatformInput platform =
      read_platform(replaced(minimal_text(), "<platform>", "<platform name=\"Drone 7\">"));
  CHECK(platform.name == "Drone 7");
  CHECK(platform.stands_still());
  CHECK(platform.where.line == 14);
  CHECK(platform.position_where.line == 15);
  CHECK(platform.position_where.column == 15);
  CHECK(platform.attitude_where.line == 16);
  CHECK(read_platform(minimal_text()).name.empty());
}

TEST_CASE("flights are read with their places", "[scenario][platform]") {
  const auto straight = std::get<StraightInput>(
      read_platform(flying("<straight azimuth_deg=\"45\" speed_m_s=\"70\"><geodetic "
                           "latitude_deg=\"36\" longitude_deg=\"-84\" height_m=\"2000\"/>"
                           "</straight>"))
          .position);
  CHECK(straight.azimuth_deg == 45.0);
  CHECK(straight.speed_m_s == 70.0);
  CHECK(straight.climb_m_s == 0.0);
  CHECK(std::get<geometry::Geodetic>(straight.place.where).height_m == 2000.0);
  const auto circle = std::get<CircleInput>(
      read_platform(flying("<circle radius_m=\"300\" speed_m_s=\"20\" azimuth_deg=\"90\" "
                           "turn=\"anticlockwise\"><local east_m=\"1\" north_m=\"2\" "
                           "up_m=\"120\"/></circle>"))
          .position);
  CHECK(circle.radius_m == 300.0);
  CHECK(circle.speed_m_s == 20.0);
  CHECK(circle.azimuth_deg == 90.0);
  CHECK_FALSE(circle.clockwise);
  CHECK(std::get<Vec3>(circle.centre.where) == Vec3{1.0, 2.0, 120.0});
}

TEST_CASE("orbits are read with their elements", "[scenario][platform]") {
  const auto overpass = std::get<sensor::Overpass>(read_platform(flying(orbit)).position);
  CHECK(overpass.latitude_deg == 36.0);
  CHECK(overpass.longitude_deg == -84.0);
  CHECK(overpass.height_m == 705000.0);
  CHECK(overpass.inclination_deg == 98.2);
  CHECK_FALSE(overpass.ascending);
  const auto elements = std::get<sensor::KeplerElements>(
      read_platform(
          flying("<kepler_orbit epoch=\"2026-06-21T00:00:00Z\" semi_major_axis_km=\"7083\" "
                 "eccentricity=\"0.001\" inclination_deg=\"98\" ascending_node_deg=\"10\" "
                 "argument_of_perigee_deg=\"20\" mean_anomaly_deg=\"30\"/>"))
          .position);
  CHECK(elements.epoch.to_string() == "2026-06-21T00:00:00Z");
  CHECK(elements.semi_major_axis_m == 7.083e6);
  CHECK(elements.eccentricity == 0.001);
  CHECK(elements.inclination_deg == 98.0);
  CHECK(elements.ascending_node_deg == 10.0);
  CHECK(elements.argument_of_perigee_deg == 20.0);
  CHECK(elements.mean_anomaly_deg == 30.0);
}

TEST_CASE("ways from files are named by absolute path", "[scenario][platform]") {
  const test::TemporaryFolder folder;
  const std::string file = (folder / "way.csv").string();
  std::ofstream{file} << "x";
  const auto way = std::get<WaypointsInput>(
      read_platform(flying("<waypoints file=\"" + file + "\" interpolation=\"straight\"/>"))
          .position);
  CHECK(way.file == file);
  CHECK(way.straight);
  CHECK_FALSE(way.max_gap_s);
  const auto tle = std::get<TwoLineInput>(
      read_platform(flying("<tle file=\"" + file + "\" satellite=\"39084\"/>")).position);
  CHECK(tle.file == file);
  CHECK(tle.satellite == "39084");
  const auto oem = std::get<EphemerisInput>(
      read_platform(flying("<oem file=\"" + file + "\" max_gap_s=\"90\"/>")).position);
  CHECK(oem.file == file);
  CHECK(oem.max_gap_s == 90.0);
  const auto table = std::get<AttitudeTableInput>(
      read_platform(flying(still_platform, "<attitude_table file=\"" + file +
                                               "\" reference=\"earth\" max_gap_s=\"2\"/>"))
          .attitude);
  CHECK(table.file == file);
  CHECK(table.reference == sensor::Reference::earth);
  CHECK(table.max_gap_s == 2.0);
}

TEST_CASE("attitudes of moving platforms are read", "[scenario][platform]") {
  const auto nadir = std::get<sensor::TrackAttitude>(
      read_platform(flying(orbit, "<nadir yaw_deg=\"1\" pitch_deg=\"2\" roll_deg=\"3\"/>"))
          .attitude);
  CHECK(nadir.aim == sensor::TrackAttitude::Aim::nadir);
  CHECK_FALSE(nadir.inertial);
  CHECK(nadir.yaw.value == degrees(1.0).value);
  CHECK(nadir.pitch.value == degrees(2.0).value);
  CHECK(nadir.roll.value == degrees(3.0).value);
  const auto velocity = std::get<sensor::TrackAttitude>(
      read_platform(flying(orbit, "<velocity inertial=\"true\"/>")).attitude);
  CHECK(velocity.aim == sensor::TrackAttitude::Aim::velocity);
  CHECK(velocity.inertial);
  const auto given = std::get<QuaternionInput>(
      read_platform(flying(still_platform,
                           "<quaternion reference=\"local\" w=\"0.6\" x=\"0.8\" y=\"0\" "
                           "z=\"0\"/>"))
          .attitude);
  CHECK(given.reference == sensor::Reference::local);
  CHECK(given.orientation.w == Approx(0.6).epsilon(1e-15));
  CHECK(given.orientation.x == Approx(0.8).epsilon(1e-15));
}

TEST_CASE("mounts nest from the platform outwards", "[scenario][platform]") {
  const PlatformInput platform = read_platform(flying(
      still_platform, aimed,
      "<jitter white_x_urad=\"1\" white_z_urad=\"3\" seed=\"9\"/>"
      "<mounts><mount x_m=\"1\" y_m=\"2\" z_m=\"3\" yaw_deg=\"10\" pitch_deg=\"20\" "
      "roll_deg=\"30\"><stare><local east_m=\"5\" north_m=\"6\" up_m=\"0\"/></stare>"
      "<mount><scan axis=\"y\" first_deg=\"-55\" last_deg=\"55\" start_s=\"-0.1\" sweep_s=\"0.5\" "
      "period_s=\"1.5\"/><mount><scan axis=\"x\" first_deg=\"0\" last_deg=\"1\" sweep_s=\"2\" "
      "motion=\"swing\"/></mount></mount></mount></mounts>"));
  REQUIRE(platform.jitter);
  CHECK(platform.jitter->white_urad == Vec3{1.0, 0.0, 3.0});
  CHECK(platform.jitter->seed == 9);
  CHECK_FALSE(platform.jitter->spectrum);
  REQUIRE(platform.mounts.size() == 3);
  const MountInput& outer = platform.mounts[0];
  CHECK(outer.offset_m == Vec3{1.0, 2.0, 3.0});
  CHECK(outer.yaw_deg == 10.0);
  CHECK(outer.pitch_deg == 20.0);
  CHECK(outer.roll_deg == 30.0);
  CHECK(std::get<Vec3>(std::get<PlaceInput>(outer.law).where) == Vec3{5.0, 6.0, 0.0});
  const auto& scan = std::get<sensor::ScanMount>(platform.mounts[1].law);
  CHECK(scan.motion == sensor::ScanMount::Motion::sweep);
  CHECK(scan.axis == Vec3{0.0, 1.0, 0.0});
  CHECK(scan.first_rad == degrees(-55.0).value);
  CHECK(scan.last_rad == degrees(55.0).value);
  CHECK(scan.start_s == -0.1);
  CHECK(scan.sweep_s == 0.5);
  CHECK(scan.period_s == 1.5);
  const auto& swing = std::get<sensor::ScanMount>(platform.mounts[2].law);
  CHECK(swing.motion == sensor::ScanMount::Motion::swing);
  CHECK(swing.axis == Vec3{1.0, 0.0, 0.0});
  CHECK(swing.period_s == 2.0);  // as long as the sweep where nothing else is said
}

TEST_CASE("a platform whose position or attitude is not one is told", "[scenario][platform]") {
  CHECK(mistake_lines(flying("<circel radius_m=\"1\" speed_m_s=\"2\" azimuth_deg=\"0\"><local "
                             "east_m=\"0\" north_m=\"0\" up_m=\"9\"/></circel>")) ==
        "15:15: <position> may not hold <circel> (did you mean \"circle\"?)\n");
  CHECK(mistake_lines(flying("")) ==
        "15:5: <position> needs <geodetic> or <local> or <straight> or <circle> or <waypoints> or "
        "<circular_orbit> or <kepler_orbit> or <tle> or <oem>\n");
  CHECK(mistake_lines(flying(std::string{still_platform} + orbit)) ==
        "15:58: <position> holds only one <geodetic> or <local> or <straight> or <circle> or "
        "<waypoints> or <circular_orbit> or <kepler_orbit> or <tle> or <oem>; <local> stands in "
        "line 15 already\n");
  CHECK(mistake_lines(flying(still_platform, "")) ==
        "16:5: <attitude> needs <look_at> or <euler> or <quaternion> or <nadir> or <velocity> or "
        "<attitude_table>\n");
  CHECK(mistake_lines(flying("<straight azimuth_deg=\"0\"><local east_m=\"0\" north_m=\"0\" "
                             "up_m=\"9\"/></straight>")) ==
        "15:15: <straight> lacks its attribute \"speed_m_s\" (it is a number above 0 and at most "
        "20000 [m/s])\n");
  CHECK(mistake_lines(flying("<waypoints file=\"hut.obj\"/>")) ==
        "15:26: attribute \"file\" of <waypoints>: \"hut.obj\", expected a file *.csv\n");
}

TEST_CASE("what a platform means is checked", "[scenario][platform]") {
  CHECK(mistake_lines(flying(still_platform, "<nadir/>")) ==
        "16:15: <nadir> follows the platform's way, but the platform stands still (a camera that "
        "stands still looks by <look_at> or <euler>)\n");
  CHECK(mistake_lines(flying(still_platform,
                             "<quaternion reference=\"orbit\" w=\"1\" x=\"0\" y=\"0\" "
                             "z=\"0\"/>")) ==
        "16:27: <quaternion> follows the platform's way, but the platform stands still (a camera "
        "that stands still looks by <look_at> or <euler>)\n");
  CHECK(mistake_lines(flying(still_platform,
                             "<quaternion reference=\"scene\" w=\"0.5\" x=\"0\" y=\"0\" "
                             "z=\"0\"/>")) ==
        "16:15: <quaternion> has length 0.5, expected 1 within 0.001\n");
  CHECK(mistake_lines(
            flying("<kepler_orbit epoch=\"2026-06-21T00:00:00Z\" semi_major_axis_km=\"7000\" "
                   "eccentricity=\"0.1\" inclination_deg=\"98\" ascending_node_deg=\"10\" "
                   "argument_of_perigee_deg=\"20\" mean_anomaly_deg=\"30\"/>")) ==
        "15:84: the orbit's perigee lies 78 km below the ground\n");
  CHECK(mistake_lines(flying(still_platform, aimed, "<jitter seed=\"2\"/>")) ==
        "16:62: <jitter> shakes nothing (give white_x_urad, white_y_urad, white_z_urad or "
        "spectrum)\n");
  CHECK(mistake_lines(flying(still_platform, aimed, "<mounts/>")) ==
        "16:62: <mounts> lacks <mount> (What turns the camera, or a further mount inside this one, "
        "against its carrier. At rest its axes are the carrier's after three right-handed turns "
        "about its own axes: Rz(yaw) Rx(pitch) Ry(roll). It stays so, or scans or "
        "stares.)\n");
  const std::string scan = "<scan axis=\"x\" first_deg=\"0\" last_deg=\"1\" sweep_s=\"2\"";
  CHECK(mistake_lines(flying(still_platform, aimed,
                             "<mounts><mount>" + scan +
                                 "/><stare><local east_m=\"5\" "
                                 "north_m=\"6\" up_m=\"0\"/></stare></mount></mounts>")) ==
        "16:132: a <mount> holds <scan> or <stare>, not both (put one mount inside the other)\n");
  CHECK(mistake_lines(flying(still_platform, aimed,
                             "<mounts><mount>" + scan + " period_s=\"1\"/></mount></mounts>")) ==
        "16:131: period_s is 1, shorter than sweep_s, 2\n");
  CHECK(mistake_lines(
            flying(still_platform, aimed,
                   "<mounts><mount>" + replaced(scan, "\"1\"", "\"0\"") + "/></mount></mounts>")) ==
        "16:106: <scan> begins and ends at the same angle\n");
  CHECK(mistake_lines(
            flying("<circle radius_m=\"3\" speed_m_s=\"2\" azimuth_deg=\"0\"><local "
                   "east_m=\"0\" north_m=\"0\" up_m=\"9\" on_terrain=\"true\"/></circle>")) ==
        "15:105: <local> of <circle> counts from the terrain, but <geometry> has no <terrain>\n");
}
