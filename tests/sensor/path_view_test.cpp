#include "sensor/camera/path_view.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#include "sensor/moving_camera.hpp"
#include "support/catch.hpp"

namespace nadir::sensor {
namespace {

using namespace support;

constexpr int draws = 4096;

/// Calls of(view) for many paths of one pixel: one scrambled low-discrepancy set.
template <class Of>
void every_path(const DetectorArray& array, const Platform& platform, int sample, int line,
                const Of& of) {
  for (std::uint32_t i = 0; i < draws; ++i) {
    of(path_view(array, platform, sample, line, Sampler{99, i}));
  }
}

// Images of cameras that stand still must stay what they were, to the last bit: (x, y, f) turned,
// then made a unit.
TEST_CASE("a plain camera's path leaves its pixel as it always did, to the bit", "[sensor][path]") {
  const Pose pose = from_euler({4.1, -5.2, 6.3}, Mat3{}, 70.0_deg, degrees(-40.0), 12.0_deg);
  DetectorArray array = perspective(101, 77, 5.3e-6, 0.0517);
  array.offset_x_m = 1.7e-5;
  array.offset_y_m = -3.1e-5;
  DetectorArray parallel = array;
  parallel.projection = Orthographic{};
  const Platform platform{pose};
  for (std::uint32_t i = 0; i < 500; ++i) {
    const Sampler numbers{i, i % 7};
    const int sample = static_cast<int>(i % 101), line = static_cast<int>(i % 77);
    const Vec2 inside = numbers.point(0);
    const double x = array.offset_x_m + ((sample + inside.x) - 0.5 * 101) * array.pitch_m;
    const double y = array.offset_y_m + ((line + inside.y) - 0.5 * 77) * array.pitch_m;
    const geometry::Ray ray = path_view(array, platform, sample, line, numbers).ray;
    CHECK(ray.origin == pose.position);
    CHECK(ray.direction == normalised(pose.axes * Vec3{x, y, 0.0517}));
    const geometry::Ray straight = path_view(parallel, platform, sample, line, numbers).ray;
    CHECK(straight.origin == pose.position + pose.axes * Vec3{x, y, 0.0});
    CHECK(straight.direction == pose.axes.z);
  }
}

TEST_CASE("paths fill the sensitive part of the pixel and no more", "[sensor][path]") {
  DetectorArray array = perspective(10, 10, 1.0, 1.0);
  array.projection = Orthographic{};
  array.fill_x = 0.5;
  array.fill_y = 0.8;
  double left = 9.0, right = -9.0, top = 9.0, bottom = -9.0;
  every_path(array, Platform{}, 7, 2, [&](const PathView& view) {
    left = std::min(left, view.ray.origin.x);
    right = std::max(right, view.ray.origin.x);
    top = std::min(top, view.ray.origin.y);
    bottom = std::max(bottom, view.ray.origin.y);
  });
  // 4096 points of a net leave no strip of 1/4096 empty.
  CHECK(left == Approx(2.25).margin(2.5e-4));
  CHECK(right == Approx(2.75).margin(2.5e-4));
  CHECK(top == Approx(-2.9).margin(2.5e-4));
  CHECK(bottom == Approx(-2.1).margin(2.5e-4));
}

TEST_CASE("an exposure smears by speed times its length, evenly", "[sensor][path]") {
  const double height = 1000.0, speed = 50.0, exposure = 0.02;
  const Platform platform = platform_of(straight_way(height, {0.0, speed, 0.0}, 10.0), 5.0);
  // A pixel that is next to nothing, so that only the motion spreads it.
  DetectorArray array = perspective(1, 1, 1e-12, 0.1);
  array.timing = {GlobalShutter{2.0}, exposure};
  double first = 1e9, last = -1e9, sum = 0.0;
  every_path(array, platform, 0, 0, [&](const PathView& view) {
    const double y = on_ground(view.ray).y;
    CHECK(y == Approx(speed * view.time_s).margin(1e-7));
    first = std::min(first, y);
    last = std::max(last, y);
    sum += y;
  });
  CHECK(last - first == Approx(speed * exposure).epsilon(1e-3));  // the net's ends: 2/4096
  CHECK(sum / draws == Approx(speed * 2.0).margin(1e-3));
}

TEST_CASE("a bolometer's age is exponential, before it is read", "[sensor][path]") {
  const Platform platform{Pose{}};
  DetectorArray array = perspective(4, 4, 1e-6, 0.1);
  array.timing.scan = RollingShutter{1.0, 0.001};
  array.timing.lag_s = 0.01;
  double sum = 0.0, squares = 0.0, oldest = 0.0;
  int beyond_two = 0;
  every_path(array, platform, 0, 3, [&](const PathView& view) {
    const double age = (1.003 - view.time_s) / 0.01;
    CHECK(age >= -1e-12);
    sum += age;
    squares += age * age;
    oldest = std::max(oldest, age);
    beyond_two += age > 2.0 ? 1 : 0;
  });
  // Stratified numbers: mean 1, mean square 2, a share exp(-2) older than two time constants; the
  // last stratum's unknown age is worth (ln 4096) / 4096 = 0.002 of the mean, 0.02 of the square.
  CHECK(sum / draws == Approx(1.0).margin(0.004));
  CHECK(squares / draws == Approx(2.0).margin(0.05));
  CHECK(beyond_two / static_cast<double>(draws) == Approx(std::exp(-2.0)).margin(5e-4));
  CHECK(oldest <= most_lags);
}

TEST_CASE("a bolometer's memory ends after twelve time constants", "[sensor][path]") {
  DetectorArray array = perspective(1, 1, 1e-6, 0.1);
  array.timing.lag_s = 1.0;
  double oldest = 0.0;
  for (std::uint32_t key = 0; key < 300'000; ++key) {
    oldest = std::max(oldest, -path_view(array, Platform{}, 0, 0, Sampler{key, 0}).time_s);
  }
  CHECK(oldest == most_lags);  // two in 300,000 would be older
}

struct Stages {
  double spread_m = 0.0, mean_m = 0.0;  // along the way, on the ground
  int stages = 0;
};

// Where the stages of one pixel look, from first to last.
Stages stages_on_ground(double speed_ratio, bool reversed) {
  const double height = 1000.0, focal = 0.1, pitch = 1e-5, gsd = height * pitch / focal;
  const double period = 0.002, speed = (reversed ? -1.0 : 1.0) * speed_ratio * gsd / period;
  const Platform platform = platform_of(straight_way(height, {0.0, speed, 0.0}, 10.0), 5.0);
  DetectorArray array = pushbroom(1, 100, pitch, focal, period);
  array.fill_x = array.fill_y = 1e-9;
  array.timing.tdi_stages = 8;
  array.timing.tdi_reversed = reversed;
  const double here = on_ground(image_view(array, platform, {0.5, 50.5}).ray).y;
  double low = 1e9, high = -1e9, sum = 0.0;
  every_path(array, platform, 0, 50, [&](const PathView& view) {
    const double y = on_ground(view.ray).y - here;
    low = std::min(low, y);
    high = std::max(high, y);
    sum += y;
  });
  return {(high - low) / gsd, sum / draws / gsd};
}

TEST_CASE("time-delay integration that matches the motion sees one place", "[sensor][path][tdi]") {
  for (const bool reversed : {false, true}) {
    const Stages matched = stages_on_ground(1.0, reversed);
    CHECK(matched.spread_m < 1e-6);  // in pixels: the pixel left to it is 1e-9 wide
    CHECK(std::abs(matched.mean_m) < 1e-6);
  }
}

// Stage j looks j - 3.5 pixels ahead, (j - 3.5) periods before, in which the camera moves by
// `ratio` pixels each: (j - 3.5)(1 - ratio).
TEST_CASE("mismatched, the stages drift apart by the mismatch of each", "[sensor][path][tdi]") {
  for (const bool reversed : {false, true}) {
    CHECK(stages_on_ground(0.9, reversed).spread_m == Approx(7 * 0.1).margin(1e-6));
    CHECK(stages_on_ground(1.2, reversed).spread_m == Approx(7 * 0.2).margin(1e-6));
  }
}

TEST_CASE("the point-spread function displaces on the focal plane", "[sensor][path]") {
  DetectorArray array = perspective(1, 1, 1e-12, 0.1);
  array.projection = Orthographic{};
  SpreadDescription blur;
  blur.gaussians = {{3e-6, 5e-6}};
  array.spread = std::make_shared<const PointSpread>(
      blur,
      std::vector<spectral::Response>{spectral::BoxResponse{Micrometres{0.5}, Micrometres{0.6}}});
  double xx = 0.0, yy = 0.0, xy = 0.0;
  every_path(array, Platform{}, 0, 0, [&](const PathView& view) {
    const Vec3 place = view.ray.origin;
    CHECK(place.x == Approx(view.spread.displacement_m.x).margin(2e-12));
    xx += place.x * place.x;
    yy += place.y * place.y;
    xy += place.x * place.y;
  });
  // Second moments of scrambled points converge like 1/draws with a logarithm: 1 % is ample.
  CHECK(std::sqrt(xx / draws) == Approx(3e-6).epsilon(0.01));
  CHECK(std::sqrt(yy / draws) == Approx(5e-6).epsilon(0.01));
  CHECK(xy / draws == Approx(0.0).margin(0.03 * 15e-12));
}

TEST_CASE("jitter without memory is normal, about each axis by itself", "[sensor][path]") {
  PlatformDescription way = straight_way(1000.0, {}, 10.0);
  way.jitter.white_rms_rad = {2e-5, 3e-5, 4e-5};
  const Platform platform = platform_of(way, 5.0);
  DetectorArray array = perspective(1, 1, 1e-12, 0.1);
  double across = 0.0, along = 0.0, turned = 0.0;
  for (std::uint32_t i = 0; i < draws; ++i) {
    const geometry::Ray ray = path_view(array, platform, 0, 0, Sampler{5, i}).ray;
    const Vec3 seen = facing_down.transposed() * ray.direction;
    across += seen.x * seen.x;
    along += seen.y * seen.y;
  }
  // A corner far off the axis sees the turn about the line of sight as well.
  array.offset_x_m = 10.0;
  for (std::uint32_t i = 0; i < draws; ++i) {
    const geometry::Ray ray = path_view(array, platform, 0, 0, Sampler{6, i}).ray;
    const double y = (facing_down.transposed() * ray.direction).y;
    turned += y * y;
  }
  // Turns about y move the line of sight along x, and the other way round. 2 %: as above.
  CHECK(std::sqrt(across / draws) == Approx(3e-5).epsilon(0.02));
  CHECK(std::sqrt(along / draws) == Approx(2e-5).epsilon(0.02));
  CHECK(std::sqrt(turned / draws) == Approx(4e-5).epsilon(0.03));
}

TEST_CASE("what one random number serves, no other effect uses", "[sensor][path]") {
  // The correlation of exposure time, stage and place in the pixel, in thousands of paths.
  DetectorArray array = pushbroom(1, 10, 1.0, 1.0, 1.0);
  array.projection = Orthographic{};
  array.timing.exposure_s = 1.0;
  double tx = 0.0, ty = 0.0;
  every_path(array, Platform{}, 0, 0, [&](const PathView& view) {
    const double t = view.time_s - image_time_s(array, {0.5, 0.5});
    CHECK(std::abs(t) <= 0.5);
    tx += 12.0 * t * view.ray.origin.x;
    ty += 12.0 * t * view.ray.origin.y;
  });
  CHECK(std::abs(tx / draws) < 0.02);  // independent draws would give 1/64 each
  CHECK(std::abs(ty / draws) < 0.02);
}

TEST_CASE("image coordinates count time in every kind of scan", "[sensor][path]") {
  DetectorArray array = perspective(100, 40, 1e-5, 0.1);
  array.timing.scan = GlobalShutter{2.0};
  CHECK(image_time_s(array, {3.0, 7.0}) == 2.0);
  array.timing.scan = RollingShutter{1.0, 0.25};
  CHECK(image_time_s(array, {3.0, 4.5}) == 2.0);
  array.timing.scan = Pushbroom{1.0, 0.25};
  CHECK(image_time_s(array, {3.0, 0.5}) == 1.0);
  CHECK(image_time_s(array, {3.0, 4.5}) == 2.0);
  array.timing.scan = Whiskbroom{1.0, 0.5, 100.0, 10};
  CHECK(image_time_s(array, {4.5, 9.9}) == 3.0);
  CHECK(image_time_s(array, {4.5, 10.1}) == 103.0);
  // And a path without exposure is drawn at that time.
  CHECK(path_view(array, Platform{}, 4, 25, Sampler{1, 2}).time_s == 203.0);
}

TEST_CASE("a path through a pixel's middle is the line of sight of its place", "[sensor][path]") {
  const Platform platform = platform_of(straight_way(700.0, {3.0, 40.0, 0.0}, 30.0), 20.0);
  DetectorArray array = pushbroom(30, 40, 1e-5, 0.1, 0.01);
  array.offset_y_m = 3e-4;
  const auto check_both = [&](const DetectorArray& tested) {
    DetectorArray point = tested;  // a sensitive area that is next to nothing
    point.fill_x = point.fill_y = 1e-9;
    const geometry::Ray path = path_view(point, platform, 12, 17, Sampler{1, 2}).ray;
    const geometry::Ray sight = image_view(tested, platform, {12.5, 17.5}).ray;
    CHECK(length(path.direction - sight.direction) < 1e-12);
    CHECK(length(path.origin - sight.origin) < 1e-9);
  };
  check_both(array);
  array.modules = {{0, 10, 0.0, 1e-4}, {10, 20, 1e-5, -1e-4, 1e-3}};
  check_both(array);
  array.modules.clear();
  array.timing.scan = RollingShutter{0.3, 0.02};
  check_both(array);
  array.timing.scan = Whiskbroom{0.1, 0.001, 0.1, 10};
  check_both(array);
}

}  // namespace
}  // namespace nadir::sensor
