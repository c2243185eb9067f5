#include "sim/run/load_platform.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/scene_builder.hpp"
#include "sensor/orbit/sgp4.hpp"
#include "sim/files/tle_file.hpp"
#include "sim/platform_loading.hpp"
#include "support/catch.hpp"

using namespace nadir;
using namespace nadir::sim;
using support::PlatformLoading;

namespace {

double platform_largest_difference(const Mat3& a, const Mat3& b) {
  return std::max({length(a.x - b.x), length(a.y - b.y), length(a.z - b.z)});
}
bool identical(const sensor::Pose& a, const sensor::Pose& b) {
  return a.position == b.position && a.axes.x == b.axes.x && a.axes.y == b.axes.y &&
         a.axes.z == b.axes.z;
}

/// Flat ground of 200 m by 200 m at a height.
TerrainProbe flat_ground(double height_m) {
  geometry::SceneBuilder builder;
  builder.add({geometry::Shape{geometry::Plane{{}, 200.0, 200.0}}, {0}},
              Affine{{}, {0.0, 0.0, height_m}}, 0);
  return TerrainProbe{builder.build()};
}

const geometry::Geodetic high{36.1, -84.1, 3000.0};

}  // namespace

TEST_CASE("a camera that stands still has the pose of its words, to the last bit",
          "[sim][platform]") {
  PlatformLoading loading;
  loading.platform().attitude = EulerInput{30.0, -40.0, 5.0};
  const Vec3 place{0.0, 0.0, 1000.0};
  CHECK(identical(loading.load({-1.0, 5.0}).at(2.0),
                  sensor::from_euler(place, Mat3{}, degrees(30.0), degrees(-40.0), degrees(5.0))));
  loading.platform().position = high;
  loading.platform().attitude = LookAtInput{Vec3{10.0, 20.0, 0.0}, false, 7.0};
  const geometry::LocalFrame frame = loading.frame();
  CHECK(identical(loading.load().at(0.0), sensor::look_at(frame.enu(high), {10.0, 20.0, 0.0},
                                                          frame.axes_at(high), degrees(7.0))));
  CHECK(loading.load().is_fixed());
  loading.platform().attitude = LookAtInput{Vec3{0.0, 0.0, 2.0}, true, 0.0};
  CHECK(loading.load({}, flat_ground(50.0)).at(0.0).axes.z ==
        normalised(Vec3{0.0, 0.0, 52.0} - frame.enu(high)));
}

TEST_CASE("a still camera that shakes keeps the same pose below it", "[sim][platform]") {
  PlatformLoading loading;
  loading.platform().position = Vec3{30000.0, 0.0, 1000.0};  // where up is not the scene's any more
  loading.platform().attitude = EulerInput{30.0, -40.0, 5.0};
  const sensor::Pose plain = loading.load().at(0.0);
  loading.platform().jitter = JitterInput{{1.0, 2.0, 3.0}, std::nullopt, 4, {}};
  const sensor::Platform shaking = loading.load({0.0, 1.0});
  CHECK(shaking.has_white_jitter());
  // Through a quaternion and back: rounding.
  CHECK(platform_largest_difference(shaking.steady(0.5).axes, plain.axes) < 1e-14);
  CHECK(shaking.steady(0.5).position == plain.position);
  const sensor::PlatformDescription description = loading.describe();
  CHECK(description.jitter.white_rms_rad.y == Approx(2e-6).epsilon(1e-15));
  CHECK(description.jitter.seed == 4);
}

TEST_CASE("spectra of shaking go to the axes that they name", "[sim][platform]") {
  PlatformLoading loading;
  loading.platform().jitter =
      JitterInput{{}, loading.text("s.csv", "frequency_hz,y_rad2_hz\n1,1e-12\n100,1e-12\n"), 1, {}};
  const sensor::PlatformDescription description = loading.describe();
  CHECK(description.jitter.spectra[0].frequencies_hz.empty());
  CHECK(description.jitter.spectra[1].density_rad2_hz == std::vector<double>{1e-12, 1e-12});
  CHECK(loading.files().all().size() == 1);
}

TEST_CASE("flights pass their place at the scenario's time", "[sim][platform]") {
  PlatformLoading loading;
  loading.platform().position = StraightInput{{high, false}, 90.0, 70.0, 2.0};
  const geometry::LocalFrame frame = loading.frame();
  const sensor::Platform straight = loading.load({-10.0, 10.0});
  // 1e-5 m: what sensor::tabulated keeps to.
  CHECK(length(straight.at(0.0).position - frame.enu(high)) < 1e-5);
  const geometry::Geodetic later = frame.geodetic(straight.at(10.0).position);
  CHECK(later.height_m == Approx(3020.0).margin(1e-4));
  const Vec3 gone =
      frame.axes_at(high).transposed() * (straight.at(10.0).position - frame.enu(high));
  // The chord is (700 m)^3 / (24 R^2) shorter than the arc, a micrometre; climbing stretches it by
  // 10 m / R of itself, a millimetre.
  CHECK(gone.x == Approx(700.0).margin(2e-3));
  loading.platform().position =
      CircleInput{{Vec3{0.0, 0.0, 500.0}, false}, 300.0, 20.0, 90.0, true};
  const sensor::Platform circle = loading.load({0.0, 30.0});
  CHECK(length(circle.at(0.0).position - Vec3{300.0, 0.0, 500.0}) < 1e-5);
  const double angle = 20.0 * 30.0 / 300.0;  // clockwise: from east towards south
  CHECK(length(circle.at(30.0).position -
               Vec3{300.0 * std::cos(angle), -300.0 * std::sin(angle), 500.0}) < 2e-5);
}

TEST_CASE("way points may be given in any axes", "[sim][platform]") {
  PlatformLoading loading;
  const geometry::LocalFrame frame = loading.frame();
  const auto row = [](double t, Vec3 p) {
    const auto text = [](double v) { return std::to_string(v); };  // six decimals
    return text(t) + "," + text(p.x) + "," + text(p.y) + "," + text(p.z) + "\n";
  };
  const Vec3 a{0.0, 0.0, 2000.0}, b{100.0, 200.0, 2100.0}, c{300.0, 200.0, 2000.0};
  const auto ecef = [&](Vec3 p) { return frame.ecef(p); };
  const auto load = [&](const std::string& name, const std::string& text, bool straight) {
    loading.platform().position = WaypointsInput{loading.text(name, text), straight};
    return loading.load({0.0, 4.0}).at(1.0).position;
  };
  const std::string scene = "time_s,east_m,north_m,up_m\n" + row(0, a) + row(2, b) + row(4, c);
  CHECK(length(load("a.csv", scene, true) - 0.5 * (a + b)) < 1e-9);
  // The parabola through three points: 3/8 a + 6/8 b - 1/8 c a quarter of the way.
  const Vec3 curved = 0.375 * a + 0.75 * b - 0.125 * c;
  CHECK(length(load("b.csv", scene, false) - curved) < 1e-9);
  const std::string earth =
      "time_s,x_m,y_m,z_m\n" + row(0, ecef(a)) + row(2, ecef(b)) + row(4, ecef(c));
  CHECK(length(load("c.csv", earth, false) - curved) < 2e-6);  // six decimals of a metre
  const auto round = [&](const geometry::Geodetic& g) {
    return Vec3{g.latitude_deg, g.longitude_deg, g.height_m};
  };
  const std::string geodetic = "time_s,latitude_deg,longitude_deg,height_m\n" +
                               row(0, round(frame.geodetic(a))) + row(2, round(frame.geodetic(b))) +
                               row(4, round(frame.geodetic(c)));
  CHECK(length(load("d.csv", geodetic, false) - curved) < 0.2);  // six decimals of a degree
}

TEST_CASE("a gap among the way points that are used is told", "[sim][platform]") {
  PlatformLoading loading;
  std::string rows = "time_s,east_m,north_m,up_m\n";
  const auto add = [&](double time_s) {
    rows += std::to_string(time_s) + ",0," + std::to_string(70.0 * time_s) + ",900\n";
  };
  for (int i = 0; i < 20; ++i) add(i);
  for (int i = 25; i < 45; ++i) add(i);
  const auto told = [&](bool straight, std::optional<double> max_gap_s, sensor::TimeSpan span) {
    loading.platform().position = WaypointsInput{loading.text("w.csv", rows), straight, max_gap_s};
    const std::string message = loading.message(span);
    if (message == "(nothing thrown)") return false;
    CHECK(message.substr(0, message.find(" may lie")) ==
          "a.xml:15:15: error: gap in the trajectory: w.csv has no place for 6 s, from 19 s to 25 "
          "s after the scenario's time; at most " +
              std::string{max_gap_s ? "2 s" : "5 s"});
    return true;
  };
  CHECK(told(false, {}, {20.0, 21.0}));
  CHECK(told(false, {}, {16.0, 16.5}));        // uses 13 to 19 and 25
  CHECK_FALSE(told(false, {}, {15.0, 15.5}));  // uses 12 to 19
  CHECK_FALSE(told(false, {}, {28.5, 30.0}));  // uses 25 to 33
  CHECK_FALSE(told(false, 6.0, {20.0, 21.0}));
  CHECK_FALSE(told(true, {}, {20.0, 21.0}));  // sparse on purpose
  CHECK(told(true, 2.0, {18.5, 19.5}));
  CHECK_FALSE(told(true, 2.0, {17.0, 19.0}));
  rows = "time_s,east_m,north_m,up_m\n";
  for (const double time_s : {0.0, 1.0, 2.0, 3.0, 4.0, 40.0, 41.0}) add(time_s);  // too few
  CHECK_FALSE(told(false, {}, {10.0, 20.0}));
}

TEST_CASE("a circular orbit passes over its place at the scenario's time", "[sim][platform]") {
  PlatformLoading loading;
  loading.platform().position = sensor::Overpass{36.0, -84.0, 705e3, 98.2, false};
  loading.platform().attitude = sensor::TrackAttitude{};
  const sensor::Platform platform = loading.load({-1.0, 1.0});
  const geometry::LocalFrame frame = loading.frame();
  const sensor::Pose over = platform.at(0.0);
  const geometry::Geodetic below = frame.geodetic(over.position);
  // 1e-5 m of the table on the way.
  CHECK(below.latitude_deg == Approx(36.0).margin(1e-9));
  CHECK(below.longitude_deg == Approx(-84.0).margin(1e-9));
  CHECK(below.height_m == Approx(705e3).margin(1e-3));
  CHECK(frame.geodetic(platform.at(1.0).position).latitude_deg < 36.0);
  CHECK(length(over.axes.z + frame.axes_at(below).z) < 1e-8);
  const Vec3 way = platform.at(0.01).position - platform.at(-0.01).position;
  CHECK(dot(over.axes.y, normalised(way)) > 0.999);  // ahead, but for the climb of the ellipsoid
  // The same by elements at another epoch.
  const auto elements =
      sensor::circular_orbit({36.0, -84.0, 705e3, 98.2, false}, loading.scenario().time);
  loading.platform().position = elements;
  CHECK(length(loading.load({-1.0, 1.0}).at(0.5).position - platform.at(0.5).position) < 2e-5);
}

TEST_CASE("two-line elements give the place that SGP4 gives", "[sim][platform]") {
  PlatformLoading loading;
  // Vallado's verification set, AIAA 2006-6753.
  const std::string tle =
      "1 00005U 58002B   00179.78495062  .00000023  00000-0  28098-4 0  4753\n"
      "2 00005  34.2682 348.7242 1859667 331.7664  19.3264 10.82419157413667\n";
  loading.scenario().time = ephemeris::Instant::parse_utc("2000-06-28T00:00:00Z", Seconds{0.2});
  loading.platform().position = TwoLineInput{loading.text("v.tle", tle), "5"};
  loading.platform().attitude = sensor::TrackAttitude{};
  const Vec3 position = loading.load({0.0, 2.0}).at(1.0).position;
  const sensor::Sgp4 model{parse_two_line_elements(tle, "v.tle")};
  const ephemeris::Instant time = loading.scenario().time + Seconds{1.0};
  const auto ecef =
      sensor::ecef_from_teme(model.teme_km((time - model.epoch()).value / 60.0), time);
  // The tolerance of the table.
  CHECK(length(position - loading.frame().enu_from_ecef(1e3 * ecef.position)) < 2e-5);
  loading.platform().position = TwoLineInput{loading.text("v.tle", tle), "6"};
  CHECK(loading.message({0.0, 2.0}) ==
        "a.xml:15:15: error: there is no satellite \"6\" in v.tle\n"
        "    hint: the file has 00005\n");
}

TEST_CASE("an orbit ephemeris gives the place between its states", "[sim][platform]") {
  PlatformLoading loading;
  // UT1 - UTC counts where the message's axes do not turn with the earth: 0.2 s are 100 m.
  const ephemeris::Instant time =
      ephemeris::Instant::parse_utc("2026-06-21T16:00:00Z", Seconds{0.2});
  loading.scenario().time = time;
  const auto elements = sensor::circular_orbit({36.0, -84.0, 705e3, 98.2, false}, time);
  std::string text =
      "CCSDS_OEM_VERS = 2.0\nCREATION_DATE = 2026-06-21T00:00:00\nORIGINATOR = TEST\n"
      "META_START\nOBJECT_NAME = S\nOBJECT_ID = 2026-001A\nCENTER_NAME = EARTH\n"
      "REF_FRAME = TEME\nTIME_SYSTEM = UTC\nSTART_TIME = 2026-06-21T15:55:00\n"
      "STOP_TIME = 2026-06-21T16:05:00\nMETA_STOP\n";
  for (int i = -10; i <= 10; ++i) {  // every 30 s
    const ephemeris::Instant moment = time + Seconds{30.0 * i};
    const auto state = sensor::teme_from_ecef(sensor::orbit_state(elements, moment), moment);
    std::string utc = moment.to_string();
    utc.pop_back();  // the Z
    text += utc;
    for (const Vec3& v : {state.position, state.velocity}) {
      for (const double x : {v.x, v.y, v.z}) text += " " + std::to_string(1e-3 * x);  // a mm
    }
    text += "\n";
  }
  loading.platform().position = EphemerisInput{loading.text("s.oem", text)};
  loading.platform().attitude = sensor::TrackAttitude{};
  const sensor::Platform platform = loading.load({-10.0, 10.0});
  const auto state = sensor::orbit_state(elements, time + Seconds{7.0});
  // Places of a millimetre; the polynomial through eight of them, 30 s apart, keeps that.
  CHECK(length(platform.at(7.0).position - loading.frame().enu_from_ecef(state.position)) < 3e-3);
  // A minute and a half without states among steps of 30 s is usual, three minutes are not.
  const auto without = [&](int first, int last) {
    std::string holed = text;
    for (int i = first; i <= last; ++i) {
      std::string utc = (time + Seconds{30.0 * i}).to_string();
      utc.pop_back();
      const std::size_t at = holed.find(utc + " ");
      holed.erase(at, holed.find('\n', at) + 1 - at);
    }
    return loading.text("holed.oem", holed);
  };
  loading.platform().position = EphemerisInput{without(2, 3)};
  CHECK(loading.message({-10.0, 10.0}) == "(nothing thrown)");
  loading.platform().position = EphemerisInput{without(2, 6)};
  CHECK(
      loading.message({-10.0, 10.0}) ==
      "a.xml:15:15: error: gap in the trajectory: holed.oem has no place for 180 s, from 30 s to "
      "210 s after the scenario's time; at most 150 s may lie between two places\n"
      "    hint: max_gap_s says how long it may be; unless it does, five times the median step\n");
  CHECK(loading.message({-200.0, -190.0}) == "(nothing thrown)");  // far from the gap
  loading.platform().position = EphemerisInput{without(2, 6), 180.0};
  CHECK(loading.message({-10.0, 10.0}) == "(nothing thrown)");
  loading.platform().position = EphemerisInput{loading.text("s.oem", text)};
  CHECK(loading.message({0.0, 301.0}) ==
        "a.xml:15:15: error: time outside the trajectory: the camera looks from 0 s to 301 s after "
        "the scenario's time, but s.oem covers -300 s to 300 s\n");
}

TEST_CASE("nested mounts turn by their own axes, one after the other", "[sim][platform]") {
  PlatformLoading loading;
  loading.platform().attitude = EulerInput{0.0, -90.0, 0.0};
  const Mat3 down = loading.load().at(0.0).axes;  // x east, y south, z down
  const auto with = [&](const MountInput& mount) {
    loading.platform().mounts = {mount};
    return loading.load();
  };
  const double s = std::sin(degrees(10.0).value);
  const auto in_carrier = [&](const sensor::Platform& p) {
    return down.transposed() * p.at(0.0).axes;
  };
  MountInput mount;
  mount.pitch_deg = 10.0;  // to the image's top
  CHECK(in_carrier(with(mount)).z.y == Approx(-s).margin(1e-12));
  mount = {};
  mount.roll_deg = 10.0;  // to the image's right
  CHECK(in_carrier(with(mount)).z.x == Approx(s).margin(1e-12));
  mount = {};
  mount.yaw_deg = 10.0;  // the image's right turns towards its bottom
  CHECK(in_carrier(with(mount)).x.y == Approx(s).margin(1e-12));
  mount = {{1.0, 2.0, 3.0}, 10.0, 20.0, 30.0, {}};
  const sensor::Platform turned = with(mount);
  CHECK(turned.is_fixed());
  CHECK(length(turned.at(0.0).position - Vec3{1.0, -2.0, 997.0}) < 1e-9);
  const Mat3 expected = rotation({0, 0, 1}, degrees(10.0).value) *
                        rotation({1, 0, 0}, degrees(20.0).value) *
                        rotation({0, 1, 0}, degrees(30.0).value);
  CHECK(platform_largest_difference(in_carrier(turned), expected) < 1e-12);
  loading.platform().mounts = {mount, mount};
  CHECK(platform_largest_difference(in_carrier(loading.load()), expected * expected) < 1e-12);
}

TEST_CASE("mounts that scan or stare move the line of sight", "[sim][platform]") {
  PlatformLoading loading;
  MountInput mount;
  sensor::ScanMount scan;
  scan.last_rad = 0.1;
  mount.law = scan;
  loading.platform().mounts = {mount};
  const sensor::Platform scanning = loading.load({0.0, 0.5});
  CHECK_FALSE(scanning.is_fixed());
  CHECK(scanning.at(0.5).axes.z.x == Approx(std::sin(0.05)).margin(1e-12));
  mount.law = PlaceInput{Vec3{50.0, 0.0, 0.0}, true};
  loading.platform().mounts = {mount};
  loading.platform().position = StraightInput{{Vec3{0.0, 0.0, 1000.0}, false}, 0.0, 70.0, 0.0};
  loading.platform().attitude = sensor::TrackAttitude{};
  const sensor::Platform staring = loading.load({0.0, 3.0}, flat_ground(20.0));
  const sensor::Pose pose = staring.at(3.0);
  CHECK(length(pose.axes.z - normalised(Vec3{50.0, 0.0, 20.0} - pose.position)) < 1e-12);
}
