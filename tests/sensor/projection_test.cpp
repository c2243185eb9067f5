#include "sensor/camera/projection.hpp"

#include <array>
#include <cmath>
#include <numbers>

#include "sensor/moving_camera.hpp"
#include "support/catch.hpp"

namespace nadir::sensor {
namespace {

using namespace support;

// The promise of image_of.
constexpr double undone_px = 1e-7;

/// A place somewhere on the line of sight through a place of the image.
Vec3 place_at(const DetectorArray& array, const Platform& platform, ImagePoint image,
              double distance) {
  const geometry::Ray ray = image_view(array, platform, image).ray;
  return ray.origin + distance * ray.direction;
}

void check_undone(const DetectorArray& array, const Platform& platform, ImagePoint image,
                  double distance) {
  CAPTURE(array.name, image.sample, image.line, distance);
  const auto found = image_of(array, platform, place_at(array, platform, image, distance));
  REQUIRE(found);
  CHECK(std::hypot(found->sample - image.sample, found->line - image.line) < undone_px);
}

Pose random_pose(std::uint32_t index) {
  const Angle yaw = degrees(some(index, 1, 0.0, 360.0)), pitch = degrees(some(index, 2, -90, 90)),
              roll = degrees(some(index, 3, -180.0, 180.0));
  return from_euler({some(index, 4, -1e4, 1e4), some(index, 5, -1e4, 1e4), 300.0}, Mat3{}, yaw,
                    pitch, roll);
}

TEST_CASE("frames undo their lines of sight, whatever the lens, pose and distance",
          "[sensor][projection]") {
  for (std::uint32_t i = 0; i < 60; ++i) {
    DetectorArray array = perspective(900, 700, 5e-6, 0.008);
    array.projection = Perspective{0.008,
                                   {.k1 = some(i, 6, -0.3, 0.3),
                                    .k2 = some(i, 7, -0.05, 0.1),
                                    .p1 = some(i, 8, -2e-3, 2e-3),
                                    .p2 = some(i, 9, -2e-3, 2e-3),
                                    .k3 = some(i, 10, -0.02, 0.02)}};
    array.offset_x_m = some(i, 11, -1e-4, 1e-4);
    array.pitch_y_m = some(i, 12, 4e-6, 6e-6);
    check(array);
    const Platform platform{random_pose(i)};
    const ImagePoint image{some(i, 13, 0.0, 900.0), some(i, 14, 0.0, 700.0)};
    for (const double distance : {0.5, 120.0, 7e5, 3.6e7}) {
      check_undone(array, platform, image, distance);
    }
    array.projection = Orthographic{};
    array.pitch_m = array.pitch_y_m = 0.25;  // 5 um would drown in the rounding of 10 km
    check_undone(array, platform, image, 120.0);
  }
}

TEST_CASE("frames made of modules undo their lines of sight", "[sensor][projection]") {
  DetectorArray array = perspective(300, 100, 1e-5, 0.1);
  array.modules = {
      {0, 100, -2e-5, 1e-4, 1e-2}, {100, 120, 0.0, -2e-4, -2e-2}, {220, 80, 3e-5, 0.0}};
  const Platform platform{random_pose(3)};
  for (std::uint32_t i = 0; i < 100; ++i) {
    // One percent of turn takes half a pixel off a module's corners: stay inside.
    const std::size_t module = i % 3;
    const std::array<ImagePoint, 3> middles{{{50.0, 0.0}, {160.0, 0.0}, {260.0, 0.0}}};
    check_undone(array, platform,
                 {middles[module].sample + some(i, 1, -35.0, 35.0), some(i, 2, 5.0, 95.0)}, 40.0);
  }
}

TEST_CASE("places behind the camera and far outside the image have no place in it",
          "[sensor][projection]") {
  const Platform platform{random_pose(1)};
  DetectorArray array = perspective(100, 60, 1e-4, 0.01);
  DetectorArray parallel = array;
  parallel.projection = Orthographic{};
  for (const DetectorArray& tested : {array, parallel}) {
    CHECK_FALSE(image_of(tested, platform, place_at(tested, platform, {50.0, 30.0}, -5.0)));
    CHECK(image_of(tested, platform, place_at(tested, platform, {109.0, 30.0}, 5.0)));
    CHECK_FALSE(image_of(tested, platform, place_at(tested, platform, {111.0, 30.0}, 5.0)));
    CHECK(image_of(tested, platform, place_at(tested, platform, {50.0, -5.0}, 5.0)));
    CHECK_FALSE(image_of(tested, platform, place_at(tested, platform, {50.0, -7.0}, 5.0)));
  }
}

TEST_CASE("where the polynomial of a lens folds back, nothing appears twice",
          "[sensor][projection]") {
  DetectorArray array = perspective(100, 100, 1e-4, 0.02);
  const Distortion lens{.k1 = -0.3};
  array.projection = Perspective{0.02, lens};
  // r (1 - 0.3 r^2) is 0.2 at r = 0.2025 and again, after it has folded, at r = 1.7163.
  const double again = 1.7163;
  CHECK(distorted(lens, {again, 0.0}).x == Approx(0.2).margin(1e-3));
  CHECK(image_of(array, Platform{}, {0.2025, 0.0, 1.0}));
  CHECK_FALSE(image_of(array, Platform{}, {again, 0.0, 1.0}));
}

TEST_CASE("a place on the line of sight of a pixel is in view, one beside or behind is not",
          "[sensor][projection]") {
  const Platform platform{from_euler({4.0, 5.0, 6.0}, Mat3{}, 70.0_deg, degrees(-40.0), 10.0_deg)};
  DetectorArray shifted = perspective(100, 60, 1e-5, 0.01);
  shifted.offset_x_m = 2e-4;
  const DetectorArray parallel{"o", 100, 60, Orthographic{}, 0.5, 3.0, -1.0, {}};
  for (const DetectorArray& array : {shifted, parallel}) {
    const auto place = [&](double sample, double line, double distance) {
      return place_at(array, platform, {sample, line}, distance);
    };
    CHECK(in_view(array, platform, place(0.1, 0.1, 50.0)));
    CHECK(in_view(array, platform, place(99.9, 59.9, 3.0)));
    CHECK_FALSE(in_view(array, platform, place(-0.1, 30.0, 50.0)));
    CHECK_FALSE(in_view(array, platform, place(50.0, 60.1, 50.0)));
    CHECK_FALSE(in_view(array, platform, place(50.0, 30.0, -50.0)));
  }
}

TEST_CASE("view tables are undone as well, of frames and of pushbrooms", "[sensor][projection]") {
  ViewTable table{11, 7, 9.9, 59.0 / 6.0, {}};
  for (int i = 0; i < 77; ++i) {
    const double x = 0.01 * (i % 11 - 5), y = 0.012 * (i / 11 - 3);
    table.directions.push_back({x + 0.8 * y * y, y - 0.5 * x * x, 1.0});
  }
  DetectorArray frame = perspective(100, 60, 1e-5, 1.0);
  frame.projection = checked(table);
  check(frame);
  for (std::uint32_t i = 0; i < 50; ++i) {
    check_undone(frame, Platform{random_pose(i)}, {some(i, 6, -5, 105), some(i, 7, -3, 63)}, 1e3);
  }
  ViewTable row{11, 1, 9.9, 1.0, {}};
  for (int i = 0; i < 11; ++i) row.directions.push_back({0.01 * (i - 5), 1e-4 * i * i, 1.0});
  DetectorArray broom = pushbroom(100, 500, 1e-5, 1.0, 0.01);
  broom.projection = checked(row);
  check(broom);
  const Platform platform = platform_of(straight_way(1e4, {0.0, 1000.0, 0.0}, 30.0), 4.0);
  for (std::uint32_t i = 0; i < 50; ++i) {
    check_undone(broom, platform, {some(i, 6, 0, 100), some(i, 7, 0, 500)}, 1e4);
  }
}

TEST_CASE("rolling shutters undo their lines of sight", "[sensor][projection]") {
  PlatformDescription way = straight_way(80.0, {12.0, -20.0, 1.0}, 10.0);
  TabulatedAttitude turning{Reference::scene, {}, {}};
  for (int i = 0; i <= 40; ++i) {  // a turn of 0.4 rad/s
    const double t = -10.0 + 0.5 * i;
    turning.times_s.push_back(t);
    turning.orientations.push_back(
        to_quaternion(rotation(normalised(Vec3{1.0, 2.0, 3.0}), 0.4 * t) * facing_down));
  }
  way.attitude = turning;
  const Platform platform = platform_of(way, 5.0);
  DetectorArray array = perspective(640, 512, 1e-5, 0.01);
  array.projection = Perspective{0.01, {.k1 = -0.1, .p1 = 1e-3}};
  array.timing.scan = RollingShutter{-0.2, 1e-3};
  for (std::uint32_t i = 0; i < 60; ++i) {
    check_undone(array, platform, {some(i, 1, 0, 640), some(i, 2, 0, 512)}, some(i, 3, 0.5, 200));
  }
}

// A wall x = const seen from a camera that flies along x: a line later by dt sees it displaced by
// speed x dt, in pixels f / (h pitch) of it. The image of an upright line leans by that a line.
TEST_CASE("a rolling shutter skews what passes by: speed x period x f / (height x pitch) a line",
          "[sensor][projection]") {
  const double height = 50.0, speed = 10.0, period = 30e-6, focal = 0.01, pitch = 1e-5;
  const Platform platform = platform_of(straight_way(height, {-speed, 0.0, 0.0}, 10.0), 5.0);
  DetectorArray array = perspective(640, 512, pitch, focal);
  array.timing.scan = RollingShutter{0.0, period};
  // x is to the west, the camera flies west: the ground's image moves to the left.
  const double skew = -speed * period * focal / (height * pitch);
  const auto top = image_of(array, platform, {0.0, -12.0, 0.0});
  const auto bottom = image_of(array, platform, {0.0, 12.0, 0.0});
  REQUIRE((top && bottom));
  CHECK(bottom->line - top->line == Approx(480.0).margin(1e-6));
  CHECK(bottom->sample - top->sample == Approx(480.0 * skew).margin(1e-6));
}

TEST_CASE("pushbrooms undo their lines of sight, from drone to geostationary orbit",
          "[sensor][projection]") {
  struct Flight {
    double distance, speed;
  };
  for (const Flight flight : {Flight{0.5, 0.2}, Flight{120.0, 15.0}, Flight{9e3, 230.0}}) {
    const double gsd = flight.distance * 1e-5 / 0.05, period = gsd / flight.speed;
    const double seconds = 1500 * period;
    const Platform platform = platform_of(
        straight_way(flight.distance, {0.3 * flight.speed, flight.speed, 0.02 * flight.speed},
                     2.0 * seconds),
        seconds);
    DetectorArray array = pushbroom(800, 2000, 1e-5, 0.05, period);
    array.projection = Perspective{0.05, {.k1 = -0.4, .p2 = 1e-3}};
    array.offset_y_m = 6e-4;
    check(array);
    for (std::uint32_t i = 0; i < 30; ++i) {
      check_undone(array, platform, {some(i, 1, 0, 800), some(i, 2, 0, 2000)}, flight.distance);
    }
  }
  for (const double radius : {7.08e6, 4.2e7}) {
    const double rate = std::sqrt(3.986004418e14 / (radius * radius * radius));
    const double height = radius - 6.378e6, period = height * 1e-5 / (rate * 6.378e6);
    const Platform platform = orbit_of(radius, rate, 1500 * period);
    DetectorArray array = pushbroom(2000, 2000, 1e-5, 1.0, period);
    array.offset_y_m = -3e-3;
    for (std::uint32_t i = 0; i < 30; ++i) {
      check_undone(array, platform, {some(i, 1, 0, 2000), some(i, 2, 0, 2000)}, height);
    }
  }
}

TEST_CASE("staggered modules that turn undo their lines of sight", "[sensor][projection]") {
  DetectorArray array = pushbroom(300, 1000, 1e-5, 0.1, 0.01);
  array.modules = {
      {0, 100, -1e-5, 2e-3, 1e-3}, {100, 100, 0.0, -2e-3, -1e-3}, {200, 100, 1e-5, 2e-3}};
  const Platform platform = platform_of(straight_way(1e3, {0.0, 10.0, 0.0}, 30.0), 8.0);
  for (std::uint32_t i = 0; i < 90; ++i) {
    check_undone(array, platform, {some(i, 1, 0, 300), some(i, 2, 0, 1000)}, 1e3);
  }
}

TEST_CASE("where modules overlap on the ground, the line of sight found passes through the place",
          "[sensor][projection]") {
  DetectorArray array = pushbroom(200, 1000, 1e-5, 0.1, 0.01);
  array.modules = {{0, 100, 1e-4, 2e-3}, {100, 100, -1e-4, -2e-3}};  // 20 pixels twice
  const Platform platform = platform_of(straight_way(1e3, {0.0, 10.0, 0.0}, 30.0), 8.0);
  for (double sample = 70.5; sample < 130.0; sample += 1.7) {
    const Vec3 place = on_ground(image_view(array, platform, {sample, 400.0}).ray);
    const auto found = image_of(array, platform, place);
    REQUIRE(found);
    CHECK(miss_m(image_view(array, platform, *found).ray, place) < 1e-7);
  }
}

// An array n pixels towards +y sees the same ground n line periods before the boresight's: so its
// image of one place lies n lines above.
TEST_CASE("a band ahead of another by n pixels sees a place n lines before it",
          "[sensor][projection]") {
  const double height = 700.0, focal = 0.1, pitch = 1e-5, period = 0.005;
  const double speed = height * pitch / focal / period;  // matched
  const Platform platform = platform_of(straight_way(height, {0.0, speed, 0.0}, 30.0), 9.0);
  const DetectorArray red = pushbroom(100, 2000, pitch, focal, period);
  DetectorArray green = red;
  green.offset_y_m = 40 * pitch;
  const Vec3 place{0.01, 3.0, 0.0};
  const auto in_red = image_of(red, platform, place), in_green = image_of(green, platform, place);
  REQUIRE((in_red && in_green));
  CHECK(in_red->line - in_green->line == Approx(40.0).margin(1e-6));
  CHECK(in_red->sample == Approx(in_green->sample).margin(1e-6));
  // A tower's top, height t, is seen from nearer: (1 - t / height) of the way to the other band.
  const Vec3 top{0.01, 3.0, 70.0};
  const auto top_red = image_of(red, platform, top), top_green = image_of(green, platform, top);
  REQUIRE((top_red && top_green));
  CHECK(top_red->line - top_green->line == Approx(40.0 * 0.9).margin(1e-6));
}

TEST_CASE("an image motion: a line period's way over the ground is one line",
          "[sensor][projection]") {
  const double speed = 25.0, period = 0.004;
  const Platform platform = platform_of(straight_way(200.0, {0.0, speed, 0.0}, 30.0), 9.0);
  const DetectorArray array = pushbroom(100, 2000, 1e-5, 0.1, period);
  const auto here = image_of(array, platform, {0.0, 0.0, 0.0});
  const auto there = image_of(array, platform, {0.0, 10.0, 0.0});
  REQUIRE((here && there));
  CHECK(there->line - here->line == Approx(10.0 / (speed * period)).margin(1e-6));
  // The middle of 2000 lines, at time 0, stands right above the origin.
  CHECK(here->line == Approx(1000.0).margin(1e-6));
  CHECK(here->sample == Approx(50.0).margin(1e-6));
}

TEST_CASE("a pushbroom on a turning circle finds the time of a place among several",
          "[sensor][projection]") {
  // Looks down from a circle of radius 300 m, one turn in 60 s.
  PlatformDescription way;
  std::vector<double> times;
  std::vector<Vec3> places;
  TabulatedAttitude turning;
  for (int i = 0; i <= 400; ++i) {
    const double t = -40.0 + 0.2 * i, angle = 2.0 * std::numbers::pi * t / 60.0;
    const Vec3 ahead{-std::sin(angle), std::cos(angle), 0.0}, down{0.0, 0.0, -1.0};
    times.push_back(t);
    places.push_back({300.0 * std::cos(angle), 300.0 * std::sin(angle), 150.0});
    turning.orientations.push_back(to_quaternion(Mat3{cross(ahead, down), ahead, down}));
  }
  turning.times_s = times;
  way.track = Track{times, places};
  way.attitude = turning;
  const Platform platform = platform_of(way, 35.0);
  DetectorArray array = pushbroom(400, 5000, 1e-4, 0.1, 0.012);
  for (std::uint32_t i = 0; i < 40; ++i) {
    check_undone(array, platform, {some(i, 1, 0, 400), some(i, 2, 10, 4990)}, 150.0);
  }
}

TEST_CASE("a row that does not move sees the same in every line: the first has it",
          "[sensor][projection]") {
  const DetectorArray array = pushbroom(100, 50, 1e-5, 0.1, 0.01);
  const Platform platform{random_pose(2)};
  const Vec3 place = place_at(array, platform, {30.25, 20.0}, 10.0);
  const auto found = image_of(array, platform, place);
  REQUIRE(found);
  CHECK(found->sample == Approx(30.25).margin(1e-9));
  CHECK(found->line == 0.5);
}

struct Scanner {
  DetectorArray array;
  Platform platform;
};

// Ten detectors swept across the way by 55 degrees to both sides, like MODIS.
Scanner scanner(double overlap) {
  const double height = 705e3, speed = 6.8e3, ifov = 1.42e-3, scan_period = 1.4771;
  const double rows = speed * scan_period * overlap / (height * ifov);
  Scanner made;
  made.array = perspective(1354, 200, ifov, 1.0);
  made.array.pitch_y_m = ifov * rows / 10.0;
  const double sample_period = 333e-6;
  made.array.timing.scan = Whiskbroom{-14.0, sample_period, scan_period, 10};
  PlatformDescription way = straight_way(height, {0.0, speed, 0.0}, 100.0);
  ScanMount mirror;
  mirror.axis = {0.0, 1.0, 0.0};
  mirror.first_rad = -0.96;
  mirror.last_rad = 0.96;
  mirror.start_s = -14.0 - 0.5 * sample_period;
  mirror.sweep_s = 1354 * sample_period;
  mirror.period_s = scan_period;
  way.mounts = {{{}, {}, mirror}};
  made.platform = platform_of(way, 60.0);
  check(made.array);
  return made;
}

TEST_CASE("whiskbrooms undo their lines of sight", "[sensor][projection]") {
  const Scanner made = scanner(0.9);  // sweeps that leave gaps right below
  for (std::uint32_t i = 0; i < 40; ++i) {
    // Near the middle, where sweeps do not overlap.
    const ImagePoint image{some(i, 1, 600.0, 750.0), some(i, 2, 0.0, 200.0)};
    check_undone(made.array, made.platform, image, 705e3);
  }
}

TEST_CASE("where sweeps overlap, the earliest one that has the place counts",
          "[sensor][projection]") {
  const Scanner made = scanner(1.0);
  int earlier = 0;
  for (std::uint32_t i = 0; i < 60; ++i) {
    const ImagePoint image{some(i, 1, 0.0, 200.0), some(i, 2, 40.0, 160.0)};
    const Vec3 place = on_ground(image_view(made.array, made.platform, image).ray);
    const auto found = image_of(made.array, made.platform, place);
    REQUIRE(found);
    CHECK(miss_m(image_view(made.array, made.platform, *found).ray, place) < 1e-3);
    const double scan = std::floor(image.line / 10), found_scan = std::floor(found->line / 10);
    CHECK(found_scan <= scan);
    CHECK(scan - found_scan <= 2);  // at 55 degrees lines are twice as wide
    earlier += found_scan < scan ? 1 : 0;
  }
  CHECK(earlier >= 15);
}

}  // namespace
}  // namespace nadir::sensor
