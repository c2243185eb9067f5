#include "sensor/camera/detector_array.hpp"

#include <cmath>
#include <numbers>

#include "core/error.hpp"
#include "core/frame.hpp"
#include "sensor/camera/path_view.hpp"
#include "sensor/moving_camera.hpp"
#include "support/catch.hpp"

namespace nadir::sensor {
namespace {

// Rounding of a few unit-vector operations in double: a few 1e-16.
constexpr double rounding = 1e-14;

void check_same(Vec3 a, Vec3 b, double margin = rounding) {
  CAPTURE(a.x, a.y, a.z, b.x, b.y, b.z);
  CHECK(length(a - b) <= margin);
}

using support::perspective;

geometry::Ray view_ray(const DetectorArray& array, const Pose& pose, double sample, double line) {
  return image_view(array, Platform{pose}, {sample, line}).ray;
}

void check_axes_are_right_handed(const Mat3& m) {
  check_same(cross(m.x, m.y), m.z);
  CHECK(dot(m.x, m.y) == Approx(0.0).margin(rounding));
  CHECK(m.determinant() == Approx(1.0).epsilon(rounding));
}

TEST_CASE("camera axes are orthonormal and right-handed for any attitude", "[sensor]") {
  for (const double yaw : {0.0, 37.0, 200.0}) {
    for (const double pitch : {-90.0, -30.0, 0.0, 60.0}) {
      for (const double roll : {0.0, -20.0, 135.0}) {
        CAPTURE(yaw, pitch, roll);
        const Pose pose = from_euler({}, Mat3{}, degrees(yaw), degrees(pitch), degrees(roll));
        check_axes_are_right_handed(pose.axes);
        check_same(pose.axes.z, direction_enu(degrees(yaw).value, degrees(pitch).value));
      }
    }
  }
}

TEST_CASE("a camera that looks straight down has north at the top and east at the right",
          "[sensor]") {
  const Pose euler = from_euler({}, Mat3{}, 0.0_deg, Angle{-std::numbers::pi / 2}, 0.0_deg);
  check_same(euler.axes.x, {1.0, 0.0, 0.0});
  check_same(euler.axes.y, {0.0, -1.0, 0.0});
  const Pose aimed = look_at({0.0, 0.0, 700e3}, {}, Mat3{}, 0.0_deg);
  check_same(aimed.axes.x, {1.0, 0.0, 0.0});
  check_same(aimed.axes.y, {0.0, -1.0, 0.0});
}

TEST_CASE("a level camera that looks north has east at the right and the sky at the top",
          "[sensor]") {
  const Pose pose = look_at({}, {0.0, 5.0, 0.0}, Mat3{}, 0.0_deg);
  check_same(pose.axes.x, {1.0, 0.0, 0.0});
  check_same(pose.axes.y, {0.0, 0.0, -1.0});
}

TEST_CASE("look-at and Euler angles agree on the same attitude", "[sensor]") {
  const Vec3 sight = direction_enu(degrees(124.0).value, degrees(-22.0).value);
  const Pose a = look_at({1.0, 2.0, 3.0}, Vec3{1.0, 2.0, 3.0} + 9.0 * sight, Mat3{}, 11.0_deg);
  const Pose b = from_euler({1.0, 2.0, 3.0}, Mat3{}, 124.0_deg, degrees(-22.0), 11.0_deg);
  check_same(a.axes.x, b.axes.x);
  check_same(a.axes.y, b.axes.y);
}

TEST_CASE("positive roll turns the camera clockwise, so that the image top leans to the right",
          "[sensor]") {
  const Pose pose = look_at({}, {0.0, 5.0, 0.0}, Mat3{}, 90.0_deg);
  check_same(-pose.axes.y, {1.0, 0.0, 0.0});  // image top: what lay to the right, east
}

TEST_CASE("a camera cannot look at its own position", "[sensor]") {
  CHECK_THROWS_AS(look_at({1.0, 2.0, 3.0}, {1.0, 2.0, 3.0}, Mat3{}, 0.0_deg), InputError);
}

TEST_CASE("the centre of the image is the line of sight", "[sensor]") {
  const Pose pose = from_euler({4.0, 5.0, 6.0}, Mat3{}, 70.0_deg, degrees(-40.0), 0.0_deg);
  const geometry::Ray ray = view_ray(perspective(101, 77, 5e-6, 0.05), pose, 50.5, 38.5);
  check_same(ray.direction, pose.axes.z);
  check_same(ray.origin, pose.position);
}

TEST_CASE("the first pixel's centre is (0.5, 0.5), half the array from the middle", "[sensor]") {
  const DetectorArray array = perspective(4, 2, 1e-3, 1.0);
  const geometry::Ray ray = view_ray(array, Pose{}, 0.5, 0.5);
  CHECK(ray.direction.x / ray.direction.z == Approx(-1.5e-3).epsilon(rounding));
  CHECK(ray.direction.y / ray.direction.z == Approx(-0.5e-3).epsilon(rounding));
}

TEST_CASE("ground sample distance at nadir is height times pitch over focal length", "[sensor]") {
  const double height_m = 705e3, pitch_m = 36e-6, focal_length_m = 0.886;  // Landsat 8 OLI
  const Pose pose = look_at({0.0, 0.0, height_m}, {}, Mat3{}, 0.0_deg);
  const DetectorArray array = perspective(2, 2, pitch_m, focal_length_m);
  const auto ground_x = [&](double sample) {
    const geometry::Ray ray = view_ray(array, pose, sample, 1.0);
    return ray.origin.x - ray.origin.z * ray.direction.x / ray.direction.z;
  };
  const double gsd_m = ground_x(1.5) - ground_x(0.5);
  CHECK(gsd_m == Approx(height_m * pitch_m / focal_length_m).epsilon(1e-12));
}

TEST_CASE("orthographic lines of sight are parallel and spaced by the pitch", "[sensor]") {
  const DetectorArray array{"o", 10, 10, Orthographic{}, 2.5, 100.0, -50.0, {}};
  const Pose pose = look_at({0.0, 0.0, 1000.0}, {}, Mat3{}, 0.0_deg);
  const geometry::Ray a = view_ray(array, pose, 5.0, 5.0), b = view_ray(array, pose, 6.0, 7.0);
  check_same(a.direction, b.direction);
  check_same(a.origin, {100.0, 50.0, 1000.0}, 1e-12);
  check_same(b.origin - a.origin, {2.5, -5.0, 0.0}, 1e-12);
}

TEST_CASE("an array's offset moves its view on the focal plane", "[sensor]") {
  DetectorArray array = perspective(2, 2, 1e-5, 0.1);
  array.offset_x_m = 3e-5;
  const geometry::Ray ray = view_ray(array, Pose{}, 1.0, 1.0);
  CHECK(ray.direction.x / ray.direction.z == Approx(3e-4).epsilon(rounding));
}

TEST_CASE("pixels need not be square", "[sensor]") {
  DetectorArray array = perspective(4, 2, 1e-3, 1.0);
  array.pitch_y_m = 3e-3;
  const Vec2 place = focal_place(array, {0.5, 0.5});
  CHECK(place.x == Approx(-1.5e-3).epsilon(rounding));
  CHECK(place.y == Approx(-1.5e-3).epsilon(rounding));
}

TEST_CASE("a pushbroom has one row, in the array's middle", "[sensor]") {
  DetectorArray array = perspective(4, 1000, 1e-3, 1.0);
  array.timing.scan = Pushbroom{0.0, 0.1};
  array.offset_y_m = 5e-3;
  for (const double line : {0.0, 17.0, 999.0}) {
    CHECK(focal_place(array, {1.0, line + 0.5}).y == Approx(5e-3).epsilon(rounding));
    CHECK(focal_place(array, {1.0, line + 0.75}).y == Approx(5.25e-3).epsilon(rounding));
  }
}

TEST_CASE("a whiskbroom has one column, in the array's middle", "[sensor]") {
  DetectorArray array = perspective(500, 40, 1e-3, 1.0);
  array.timing.scan = Whiskbroom{0.0, 1e-4, 1.0, 10};
  for (const double line : {0.5, 10.5, 30.5}) {
    const Vec2 place = focal_place(array, {123.75, line});
    CHECK(place.x == Approx(0.25e-3).epsilon(1e-10));  // 123.75 has lost some digits
    CHECK(place.y == Approx(-4.5e-3).epsilon(rounding));
  }
}

TEST_CASE("modules are displaced, and turned about their middles", "[sensor]") {
  DetectorArray array = perspective(30, 1, 1e-3, 1.0);
  array.timing.scan = Pushbroom{0.0, 0.1};
  const double turn = 0.01;
  array.modules = {{0, 10}, {10, 20, 2e-4, -3e-3, turn}};
  check_same({focal_place(array, {5.0, 0.5}).x, focal_place(array, {5.0, 0.5}).y, 0.0},
             {-0.010, 0.0, 0.0});
  // The second's middle, sample 20, is where the perfect array has it and the offset farther.
  const Vec2 middle = focal_place(array, {20.0, 0.5});
  check_same({middle.x, middle.y, 0.0}, {0.0052, -0.003, 0.0});
  // Turned from x to y: samples to the right lie farther down.
  const Vec2 right = focal_place(array, {24.0, 0.5});
  check_same({right.x, right.y, 0.0},
             {0.0052 + 0.004 * std::cos(turn), -0.003 + 0.004 * std::sin(turn), 0.0});
  const Vec2 below = focal_place(array, {20.0, 0.75});
  check_same({below.x, below.y, 0.0},
             {0.0052 - 0.00025 * std::sin(turn), -0.003 + 0.00025 * std::cos(turn), 0.0});
}

TEST_CASE("a lens bends the line of sight back to where the undistorted one goes", "[sensor]") {
  DetectorArray array = perspective(10, 10, 1e-3, 0.02);
  const Distortion lens{.k1 = -0.3, .k2 = 0.1, .p1 = 1e-3, .p2 = 2e-3};
  array.projection = Perspective{0.02, lens};
  const Vec2 bent = distorted(lens, {0.15, -0.2});
  check_same(camera_direction(array, {0.02 * bent.x, 0.02 * bent.y}),
             normalised(Vec3{0.15, -0.2, 1.0}));
}

TEST_CASE("a view table's lines of sight are those of its pixels", "[sensor]") {
  DetectorArray array = perspective(3, 2, 1e-3, 1.0);
  ViewTable table{3, 2, 1.0, 1.0, {}};
  for (int i = 0; i < 6; ++i) table.directions.push_back({0.01 * (i % 3), 0.02 * (i / 3), 1.0});
  array.projection = checked(table);
  const Vec2 last = focal_place(array, {2.5, 1.5});
  check_same(camera_direction(array, last), normalised(Vec3{0.02, 0.02, 1.0}));
}

DetectorArray swath() {
  DetectorArray array = perspective(30, 100, 1e-5, 0.1);
  array.timing = {Pushbroom{0.0, 0.01}, 0.008};
  array.modules = {{0, 10, 0.0, 2e-4}, {10, 10, 0.0, -2e-4}, {20, 10, 0.0, 2e-4}};
  return array;
}

template <class Change>
void refuses(const Change& change, const std::string& message) {
  DetectorArray array = swath();
  change(array);
  CHECK_THROWS_WITH(check(array), "error: " + message + "\n");
}

TEST_CASE("arrays that can be built pass", "[sensor][check]") {
  CHECK_NOTHROW(check(swath()));
  CHECK_NOTHROW(check(perspective(4, 4, 1e-6, 0.01)));
  DetectorArray whisk = perspective(100, 20, 1e-5, 0.1);
  whisk.timing = {Whiskbroom{0.0, 1e-3, 0.1, 10}, 1e-3};
  CHECK_NOTHROW(check(whisk));
}

TEST_CASE("sizes that cannot be are refused", "[sensor][check]") {
  refuses([](DetectorArray& a) { a.samples = 0; }, "an array has at least 1 sample and 1 line");
  refuses([](DetectorArray& a) { a.pitch_m = 0.0; }, "the pixels' pitch must be above 0 m");
  refuses([](DetectorArray& a) { a.fill_y = 1.2; },
          "the sensitive part of the pitch is 1.2, allowed range is (0, 1]");
  refuses([](DetectorArray& a) { a.projection = Perspective{-0.1}; },
          "the focal length must be above 0 m");
  refuses([](DetectorArray& a) { a.offset_x_m = std::nan(""); },
          "the array's offset is not finite");
}

TEST_CASE("timings that cannot be are refused", "[sensor][check]") {
  refuses([](DetectorArray& a) { a.timing.exposure_s = 0.02; },
          "the exposure, 0.02 s, is longer than the line period, 0.01 s");
  refuses([](DetectorArray& a) { a.timing.lag_s = 0.01; },
          "a detector has an exposure or a time constant, not both");
  refuses([](DetectorArray& a) { a.timing.tdi_stages = 0; },
          "time-delay integration has at least 1 stage");
  refuses(
      [](DetectorArray& a) {
        a.timing.scan = GlobalShutter{};
        a.timing.tdi_stages = 4;
      },
      "time-delay integration is for pushbrooms only");
  refuses(
      [](DetectorArray& a) {
        a.timing.scan = Pushbroom{0.0, 0.0};
      },
      "the line period of a pushbroom must be above 0 s");
}

TEST_CASE("whiskbrooms that cannot be are refused", "[sensor][check]") {
  const auto whisk_refused = [](Whiskbroom broom, const std::string& message) {
    DetectorArray array = perspective(100, 25, 1e-5, 0.1);
    array.timing.scan = broom;
    CHECK_THROWS_WITH(check(array), "error: " + message + "\n");
  };
  whisk_refused({0.0, 1e-3, 0.2, 10},
                "a whiskbroom's 25 lines are not a whole number of scans of 10 lines");
  whisk_refused({0.0, 1e-3, 0.05, 5},
                "a sweep of 100 samples takes 0.1 s, longer than the scan period, 0.05 s");
  whisk_refused({0.0, 0.0, 0.05, 5}, "the periods of a whiskbroom must be above 0 s");
}

TEST_CASE("modules that overlap or leave gaps are refused", "[sensor][check]") {
  refuses([](DetectorArray& a) { a.modules[1].first_sample = 8; },
          "module 2 begins at sample 8 and overlaps the one before, which ends at 10");
  refuses([](DetectorArray& a) { a.modules[1].first_sample = 12; },
          "module 2 begins at sample 12 and leaves a gap after 10");
  refuses([](DetectorArray& a) { a.modules.pop_back(); },
          "the modules have 20 samples, the array 30");
  refuses(
      [](DetectorArray& a) {
        a.modules[1] = {10, 10, -2e-5, 2e-4};
      },
      "modules 1 and 2 overlap on the focal plane");
}

TEST_CASE("view tables of another size are refused", "[sensor][check]") {
  const auto flat = [](int samples, int lines) {
    ViewTable table{samples, lines, 1.0, 1.0, {}};
    for (int i = 0; i < samples * lines; ++i) table.directions.push_back({0.0, 0.0, 1.0});
    return checked(table);
  };
  refuses([&](DetectorArray& a) { a.projection = flat(30, 1); },
          "a view table holds the places of all pixels: it takes no offset and no modules");
  refuses(
      [&](DetectorArray& a) {
        a.modules.clear();
        a.projection = flat(29, 1);
      },
      "the view table ends at sample 28.5, the array's last is 29.5");
  refuses(
      [&](DetectorArray& a) {
        a.modules.clear();
        a.projection = flat(30, 2);
      },
      "the view table of a pushbroom has one line");
  refuses(
      [&](DetectorArray& a) {
        a.modules.clear();
        a.timing.scan = GlobalShutter{};
        a.projection = flat(30, 99);
      },
      "the view table ends at line 98.5, the array's last is 99.5");
}

TEST_CASE("a lens that folds within the array's corners is refused", "[sensor][check]") {
  DetectorArray array = perspective(800, 600, 1e-5, 0.01);  // corner at half a focal length
  array.projection = Perspective{0.01, {.k1 = -0.5}};
  CHECK_NOTHROW(check(array));
  array.offset_x_m = 3e-3;
  CHECK_THROWS_AS(check(array), InputError);
}

TEST_CASE("arrays on one focal plane lie apart", "[sensor][check]") {
  DetectorArray red = swath(), green = swath();
  red.name = "red";
  green.name = "green";
  green.offset_y_m = 1e-3;
  CHECK_NOTHROW(check_apart({red, green}));
  green.offset_y_m = 4e-4;  // its odd modules lie on the even ones of the other
  green.offset_x_m = 1e-4;
  CHECK_THROWS_WITH(check_apart({red, green}),
                    "error: arrays \"red\" and \"green\" overlap on the focal plane\n");
}

}  // namespace
}  // namespace nadir::sensor
