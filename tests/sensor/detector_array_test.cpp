#include "sensor/camera/detector_array.hpp"

#include <cmath>
#include <numbers>

#include "core/error.hpp"
#include "core/frame.hpp"
#include "support/catch.hpp"

namespace nadir::sensor {
namespace {

// Rounding of a few unit-vector operations in double: a few 1e-16.
constexpr double rounding = 1e-14;

void check_same(Vec3 a, Vec3 b, double margin = rounding) {
  CAPTURE(a.x, a.y, a.z, b.x, b.y, b.z);
  CHECK(length(a - b) <= margin);
}

DetectorArray perspective(int samples, int lines, double pitch_m, double focal_length_m) {
  return {"a", samples, lines, Perspective{focal_length_m}, pitch_m, 0.0, 0.0, {}};
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

TEST_CASE("a place on the line of sight of a pixel is in view, one beside or behind is not",
          "[sensor]") {
  const Pose pose = from_euler({4.0, 5.0, 6.0}, Mat3{}, 70.0_deg, degrees(-40.0), 10.0_deg);
  DetectorArray shifted = perspective(100, 60, 1e-5, 0.01);
  shifted.offset_x_m = 2e-4;
  const DetectorArray parallel{"o", 100, 60, Orthographic{}, 0.5, 3.0, -1.0, {}};
  for (const DetectorArray& array : {shifted, parallel}) {
    const auto place = [&](double sample, double line, double distance) {
      const geometry::Ray ray = view_ray(array, pose, sample, line);
      return ray.origin + distance * ray.direction;
    };
    CHECK(in_view(array, pose, place(0.1, 0.1, 50.0)));
    CHECK(in_view(array, pose, place(99.9, 59.9, 3.0)));
    CHECK_FALSE(in_view(array, pose, place(-0.1, 30.0, 50.0)));
    CHECK_FALSE(in_view(array, pose, place(50.0, 60.1, 50.0)));
    CHECK_FALSE(in_view(array, pose, place(50.0, 30.0, -50.0)));
  }
}

TEST_CASE("an array's offset moves its view on the focal plane", "[sensor]") {
  DetectorArray array = perspective(2, 2, 1e-5, 0.1);
  array.offset_x_m = 3e-5;
  const geometry::Ray ray = view_ray(array, Pose{}, 1.0, 1.0);
  CHECK(ray.direction.x / ray.direction.z == Approx(3e-4).epsilon(rounding));
}

}  // namespace
}  // namespace nadir::sensor
