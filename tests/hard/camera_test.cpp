#include <chrono>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>
#include <vector>

#include "core/error.hpp"
#include "sensor/flat_field.hpp"
#include "sensor/moving_camera.hpp"
#include "support/catch.hpp"
#include "support/floating_point_traps.hpp"

// Cameras at 0.1 m and at 36,000 km, of one pixel and of 100,000, exposed for no time at all.

namespace nadir::sensor {
namespace {

using flat_field::clean;
using flat_field::photons;
using support::perspective;

Pose above(double height_m) { return look_at({0.0, 0.0, height_m}, {}, Mat3{}, 0.0_deg); }

TEST_CASE("pixels are pitch / focal length times the distance wide, at 0.1 m and 36,000 km",
          "[hard][camera]") {
  const double height_m = GENERATE(0.1, 100.0, 36e6);
  const double pitch_m = 5e-6, focal_length_m = height_m < 1.0 ? 0.01 : 5.0;
  const DetectorArray array = perspective(1001, 1001, pitch_m, focal_length_m);
  const Platform still{above(height_m)};
  const double pixel_m = height_m * pitch_m / focal_length_m;
  for (const int sample : {0, 499, 500, 1000}) {
    const auto centre = [&](double at) {
      return support::on_ground(image_view(array, still, {at, 500.5}).ray);
    };
    const Vec3 here = centre(sample + 0.5);
    CAPTURE(height_m, sample);
    // Doubles hold 36,000 km to 7 nm: directions to 1e-16 put a place to 4 nm times the slope.
    CHECK(here.x == Approx((sample - 500) * pixel_m).margin(1e-15 * height_m));
    CHECK(here.y == Approx(0.0).margin(1e-15 * height_m));
    CHECK((centre(sample + 1.0) - centre(sample)).x == Approx(pixel_m).margin(2e-15 * height_m));
  }
}

TEST_CASE("a camera of one pixel looks along its axis, whatever the place in the pixel",
          "[hard][camera]") {
  DetectorArray array = perspective(1, 1, 5e-6, 0.05);
  array.bands = {{"band", flat_field::red}};
  check(array);
  const Platform still{above(10.0)};
  CHECK(length(image_view(array, still, {0.5, 0.5}).ray.direction - Vec3{0.0, 0.0, -1.0}) < 1e-15);
  for (std::uint32_t i = 0; i < 1000; ++i) {
    const PathView view = path_view(array, still, 0, 0, Sampler{7, i});
    const Vec3 place = support::on_ground(view.ray);
    REQUIRE(std::abs(place.x) <= 0.5e-3 + 1e-12);  // 10 m 5 um / 50 mm = 1 mm
    REQUIRE(std::abs(place.y) <= 0.5e-3 + 1e-12);
    REQUIRE(length(view.ray.direction) == Approx(1.0).epsilon(1e-14));
  }
}

TEST_CASE("an exposure of 0 is a moment: every path of a moving camera has the same time",
          "[hard][camera]") {
  DetectorArray array = support::pushbroom(3, 5, 5e-6, 0.05, 0.01);
  array.timing.exposure_s = 0.0;
  const Platform moving =
      support::platform_of(support::straight_way(700e3, {0.0, 7000.0, 0.0}, 1.0), 1.0);
  for (int line = 0; line < 5; ++line) {
    for (std::uint32_t i = 0; i < 50; ++i) {
      const PathView view = path_view(array, moving, 1, line, Sampler{7, i});
      REQUIRE(view.time_s == Approx((line - 2) * 0.01).margin(1e-15));
    }
  }
}

TEST_CASE("without an exposure a detector counts nothing, and that is refused or zero, not NaN",
          "[hard][camera]") {
  Detector detector = clean();
  const DetectorArray array = flat_field::frame(4, 0.0, flat_field::red);
  try {
    const auto image = flat_field::expose(array, detector, 100.0, 1);
    for (const auto dn : image.dn) CHECK(dn == 0);
    for (const auto noise : image.noise) CHECK(std::isfinite(noise));
  } catch (const InputError& error) {
    CHECK(std::string(error.what()).find("exposure") != std::string::npos);
  }
}

TEST_CASE("darkness, light beyond the well and what is no number each have a digital number",
          "[hard][camera]") {
  Detector detector = clean(2e4);
  detector.digitiser = {.bits = 12, .black_level_dn = 100.0};
  photons(detector).read_noise_e = 10.0;
  const DetectorArray array = flat_field::frame(8, flat_field::exposure_s, flat_field::red);
  SignalChain chain{array, 0, detector, 1};
  const float infinite = std::numeric_limits<float>::infinity();
  const std::vector<float> line{0.0F,     1e-30F,    1e30F, 3e37F,
                                infinite, -infinite, -1.0F, std::nanf("")};
  std::vector<std::uint16_t> dn(8);
  std::vector<float> electrons(8), noise(8);
  chain.expose(line, {.dn = dn, .electrons = electrons, .noise = noise});
  CHECK(std::abs(dn[0] - 100) <= 20);  // read noise: 10 electrons are 2 DN
  CHECK(std::abs(dn[1] - 100) <= 20);
  CHECK(dn[2] >= 4075);  // a full well, 4095, with the read noise above
  CHECK(dn[3] >= 4075);
  for (const std::size_t i : {4U, 5U, 7U}) CHECK(dn[i] == 0);  // not finite: 0
  for (const std::uint16_t value : dn) CHECK(value <= 4095);
  for (std::size_t i = 0; i < 4; ++i) CHECK(std::isfinite(noise[i]));
}

TEST_CASE("a line of 100,000 pixels takes no more memory than its line and a second of time",
          "[hard][camera]") {
  constexpr int columns = 100'000;
  DetectorArray array = support::pushbroom(columns, 3, 5e-6, 1.0, 0.001);
  array.bands = {{"band", flat_field::red}};
  array.timing.exposure_s = 0.001;
  check(array);
  const auto begin = std::chrono::steady_clock::now();
  Detector detector = clean();
  detector.dead_share = 1e-3;
  photons(detector).prnu = 0.01;
  SignalChain chain{array, 0, detector, 1};
  const std::vector<float> radiance(columns, 50.0F);
  std::vector<std::uint16_t> dn(columns);
  int dead = 0;
  for (int line = 0; line < array.lines; ++line)
    chain.expose(radiance, {.dn = dn, .electrons = {}, .noise = {}});
  for (const std::uint16_t value : dn) dead += value == 0 ? 1 : 0;
  CHECK(dead == Approx(100).margin(50));  // five standard deviations of 100
  const Platform still{above(500e3)};
  for (int sample = 0; sample < columns; ++sample) {
    const Vec3 towards = image_view(array, still, {sample + 0.5, 1.5}).ray.direction;
    REQUIRE(towards.x == Approx((sample + 0.5 - columns / 2) * 5e-6).epsilon(0.04));
  }
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;
  CHECK(taken.count() < 5.0);  // 0.1 s on a free processor; others run beside this test
}

TEST_CASE("arrays without pixels, pitch or focal length, and with NaN in them, are refused",
          "[hard][camera]") {
  const double nothing = std::nan("");
  const nadir::support::WithoutTraps compares_nan;
  const auto refused = [](const DetectorArray& array) {
    CHECK_THROWS_AS(check(array), InputError);
  };
  refused(perspective(0, 1, 5e-6, 0.05));
  refused(perspective(1, 0, 5e-6, 0.05));
  refused(perspective(-1, 1, 5e-6, 0.05));
  refused(perspective(1, 1, 0.0, 0.05));
  refused(perspective(1, 1, nothing, 0.05));
  refused(perspective(1, 1, 5e-6, 0.0));
  refused(perspective(1, 1, 5e-6, nothing));
  DetectorArray array = perspective(4, 4, 5e-6, 0.05);
  array.timing.exposure_s = nothing;
  refused(array);
  array.timing.exposure_s = -1.0;
  refused(array);
}

}  // namespace
}  // namespace nadir::sensor
