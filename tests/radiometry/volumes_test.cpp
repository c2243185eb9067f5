#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include "radiometry/volume_helpers.hpp"
#include "radiometry/volumes/passage.hpp"
#include "spectral/exp_minus.hpp"

namespace nadir::radiometry {
namespace {

using namespace volume_test;  // NOLINT: the helpers of these tests alone

constexpr double volumes_pi = std::numbers::pi;

// Lanes are float: exp(-tau) carries the rounding of tau, 6e-8 tau.
double lane_rounding(double tau) { return 4e-7 + 1.5e-7 * tau; }

TEST_CASE("a homogeneous volume lets through exp(-tau), lane by lane", "[radiometry][volumes]") {
  const double tau = GENERATE(1e-8, 1e-3, 1.0, 30.0, 80.0, 1e3);
  // Three lanes with extinctions 1 : 0.5 : 0.1, in a slab of 10 m.
  const BoundVolumes volumes{{slab(0.1 * tau * coloured(), spectral::Curve::constant(0.0))},
                             lanes()};
  const geometry::Ray ray = downwards();
  const auto t = volumes.transmittance(ray, 100.0, numbers(1));
  const auto segment = volumes.segment(ray, 100.0, numbers(1));
  for (int lane = 0; lane < 3; ++lane) {
    const double depth = tau * share_of(lane), exact = std::exp(-depth);
    CAPTURE(tau, lane);
    CHECK(t[lane] == Approx(exact).epsilon(lane_rounding(depth)).margin(1e-37));
    CHECK(segment.transmittance[lane] == Approx(exact).epsilon(lane_rounding(depth)).margin(1e-37));
  }
  CHECK_FALSE(segment.event.has_value());
}

// The stated bound, and the path length (1 - exp(-tau)) / tau from 1e-8 on.
TEST_CASE("the exponential of lanes is within 2e-7", "[radiometry][volumes]") {
  double worst = 0.0, worst_path = 0.0;
  for (float tau = 1e-8F; tau < 87.0F; tau *= 1.003F) {
    const auto exact = static_cast<double>(tau);
    worst = std::max(
        worst, std::abs(static_cast<double>(spectral::exp_minus(tau)) / std::exp(-exact) - 1.0));
    const double path = -std::expm1(-exact) / exact;
    const auto found = static_cast<double>(passage(spectral::Spectrum{1, tau}, 1.0).path[0]);
    worst_path = std::max(worst_path, std::abs(found / path - 1.0));
  }
  CAPTURE(worst, worst_path);
  CHECK(worst < 2e-7);
  CHECK(worst_path < 5e-7);
  CHECK(spectral::exp_minus(0.0F) == 1.0F);
  CHECK(spectral::exp_minus(1e30F) == 0.0F);
}

TEST_CASE("only the part of a ray before its end counts", "[radiometry][volumes]") {
  const BoundVolumes volumes{{slab(0.1 * coloured(), spectral::Curve::constant(0.0))}, lanes()};
  geometry::Ray ray = downwards();  // meets the slab from 10 m to 20 m
  CHECK_FALSE(volumes.crossed(ray, 9.9));
  CHECK(volumes.crossed(ray, 10.1));
  CHECK(volumes.transmittance(ray, 9.9, numbers(1))[0] == 1.0F);
  CHECK(volumes.transmittance(ray, 14.0, numbers(1))[0] == Approx(std::exp(-0.4)).epsilon(1e-6));
  ray.max_distance = 12.0;
  CHECK(volumes.transmittance(ray, 1e9, numbers(1))[0] == Approx(std::exp(-0.2)).epsilon(1e-6));
  const geometry::Ray aside{{2000.0, 0.0, 20.0}, {0.0, 0.0, -1.0}};
  CHECK_FALSE(volumes.crossed(aside, 100.0));
}

TEST_CASE("an isothermal slab that does not scatter emits (1 - exp(-tau)) B exactly",
          "[radiometry][volumes]") {
  const double tau = GENERATE(1e-8, 1e-3, 1.0, 1e3);
  Volume volume = slab(0.1 * tau * coloured(), spectral::Curve::constant(0.0));
  volume.temperature = Kelvin{900.0};
  const BoundVolumes volumes{{volume}, lanes()};
  const auto segment = volumes.segment(downwards(), 100.0, numbers(1));
  spectral::Spectrum throughput{3, 1.0F};
  spectral::SpectrumSum radiance{3};
  CHECK_FALSE(volumes.fly(downwards(), 100.0, numbers(1), throughput, radiance).has_value());
  for (int lane = 0; lane < 3; ++lane) {
    const double b = spectral::planck(lanes()[lane], 900.0_K).value;
    const double exact = -std::expm1(-tau * share_of(lane)) * b;
    CAPTURE(tau, lane);
    CHECK(segment.emission[lane] == Approx(exact).epsilon(1e-6));
    CHECK(radiance[lane] == Approx(exact).epsilon(1e-6));
  }
}

TEST_CASE("the share of absorption scales a volume's own emission", "[radiometry][volumes]") {
  // sigma_a / sigma_t (1 - exp(-tau)) B leaves a slab before anything is scattered.
  Volume volume = slab(spectral::Curve::constant(0.02), spectral::Curve::constant(0.06));
  volume.temperature = Kelvin{500.0};
  const BoundVolumes volumes{{volume}, lanes()};
  const auto segment = volumes.segment(downwards(), 100.0, numbers(1));
  const double b = spectral::planck(lanes()[2], 500.0_K).value;
  CHECK(segment.emission[2] == Approx(0.25 * -std::expm1(-0.8) * b).epsilon(1e-6));
}

// Chandrasekhar, Radiative Transfer (1960), section 24: once-scattered light of a slab, isotropic:
// w / (4 pi) E mu0 / (mu + mu0) (1 - exp(-tau (1 / mu + 1 / mu0))), here with E on the horizontal.
TEST_CASE("light scattered once by a slab under a sun has its closed form",
          "[radiometry][volumes]") {
  const double tau = GENERATE(1e-8, 0.02, 1.0, 1e3);
  const bool gridded = GENERATE(false, true);
  const Vec3 sun = support::direction(0.6, 0.0);
  Volume volume = slab(0.04 * tau * coloured(), 0.06 * tau * coloured());
  if (gridded) volume.density = grid({3, 3, 7}, [](double) { return 1.0; });
  const BoundVolumes volumes{{volume}, lanes()};
  std::vector<Welford> estimate(3);
  for (std::uint32_t i = 0; i < 3000; ++i) {
    const auto segment = volumes.segment(downwards(), 100.0, numbers(i));
    REQUIRE(segment.event.has_value());
    const geometry::Ray shadow{segment.event->position, sun};
    const auto t = volumes.transmittance(shadow, 1e5, numbers(i).child(1));
    const auto p = segment.event->phase->eval(sun, {0.0, 0.0, 1.0});
    for (int lane = 0; lane < 3; ++lane) {
      estimate[static_cast<std::size_t>(lane)].add(
          static_cast<double>(segment.event->weight[lane] * t[lane] * p[lane]));
    }
  }
  for (int lane = 0; lane < 3; ++lane) {
    const double slant = 1.0 + 1.0 / 0.6;  // view straight down
    const double exact =
        0.6 / (4.0 * volumes_pi) / slant * -std::expm1(-tau * share_of(lane) * slant);
    CAPTURE(tau, lane, gridded);
    CHECK(within_error(estimate[static_cast<std::size_t>(lane)], exact, 24));
  }
}

// A path in a cloud that absorbs nothing, in a field that is the same everywhere, arrives with
// that field at every lane, however thick the cloud.
TEST_CASE("a white cloud in a uniform field gives back that field", "[radiometry][volumes]") {
  const double tau = GENERATE(0.1, 3.0, 30.0);
  const bool gridded = GENERATE(false, true);
  Volume volume = slab(spectral::Curve::constant(0.0), 0.5 * tau * coloured());
  volume.medium.phase = materials::HenyeyGreenstein{spectral::Curve::constant(0.7)};
  if (gridded) {
    volume.region = geometry::Region{geometry::Box{{-1, -1, -1}, {1, 1, 1}}, Affine{}};
    volume.density = grid({9, 9, 9}, [](double z) { return 0.3 + z; });
  } else {
    volume.region = geometry::Region{geometry::Sphere{{0.0, 0.0, 0.0}, 1.0}, Affine{}};
  }
  const BoundVolumes volumes{{volume}, lanes()};
  std::vector<Welford> estimate(3);
  for (std::uint32_t i = 0; i < 1500; ++i) {
    const auto arrived = walk({{0.2, 0.1, 9.0}, {0.0, 0.0, -1.0}}, volumes, numbers(i));
    for (int lane = 0; lane < 3; ++lane) {
      estimate[static_cast<std::size_t>(lane)].add(arrived[lane]);
    }
  }
  for (const Welford& lane : estimate) {
    CAPTURE(tau, gridded, lane.mean(), lane.estimate().standard_error);
    CHECK(within_error(lane, 1.0, 18));
  }
}

// Kirchhoff: in surroundings of its own temperature a volume cannot be seen, whatever it absorbs
// and scatters.
TEST_CASE("an isothermal furnace shows nothing of a volume in it", "[radiometry][volumes]") {
  const double tau = GENERATE(1e-8, 1.0, 1e3);
  const bool gridded = GENERATE(false, true);
  Volume volume = slab(0.3 * tau * coloured(), spectral::Curve::constant(0.7 * tau));
  volume.region = geometry::Region{geometry::Box{{-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5}}, Affine{}};
  volume.temperature = Kelvin{400.0};
  if (gridded) {
    volume.density = grid({5, 5, 5}, [](double z) { return 0.2 + 0.8 * z; });
    volume.temperature = grid({2, 2, 2}, [](double) { return 400.0; });
  }
  const BoundVolumes volumes{{volume}, lanes()};
  const auto b = spectral::planck(lanes(), 400.0_K);
  std::vector<Welford> estimate(3);
  for (std::uint32_t i = 0; i < 600; ++i) {
    const auto arrived = walk({{0.1, 0.2, 5.0}, {0.0, 0.0, -1.0}}, volumes, numbers(i), &b);
    for (int lane = 0; lane < 3; ++lane) {
      estimate[static_cast<std::size_t>(lane)].add(arrived[lane] / static_cast<double>(b[lane]));
    }
  }
  for (const Welford& lane : estimate) {
    CAPTURE(tau, gridded, lane.mean(), lane.estimate().standard_error);
    CHECK(within_error(lane, 1.0, 18));
  }
}

// Plane albedo of a half space that scatters isotropically: 1 - H(mu0) sqrt(1 - w), with
// Chandrasekhar's H; Radiative Transfer (1960), sections 34 and 38.
TEST_CASE("a half space reflects what Chandrasekhar's H says", "[radiometry][volumes]") {
  // Single-scattering albedos 0.5, 0.9 and 0.98 in one path of three lanes.
  const spectral::Curve absorption = per_lane({50.0, 10.0, 2.0});
  const spectral::Curve scattering = per_lane({50.0, 90.0, 98.0});
  Volume volume = slab(absorption, scattering);  // 10 m: an optical depth of 1000
  const BoundVolumes volumes{{volume}, lanes()};
  const double mu0 = 0.5;
  const Vec3 wo = support::direction(mu0, 1.0);
  std::vector<Welford> estimate(3);
  for (std::uint32_t i = 0; i < 2500; ++i) {
    const auto arrived = walk({100.0 * wo, -wo}, volumes, numbers(i));
    for (int lane = 0; lane < 3; ++lane) {
      estimate[static_cast<std::size_t>(lane)].add(arrived[lane]);
    }
  }
  const double albedo[] = {0.5, 0.9, 0.98};
  for (int lane = 0; lane < 3; ++lane) {
    const double w = albedo[lane];
    const double exact = 1.0 - h_function(w, mu0) * std::sqrt(1.0 - w);
    const Welford& found = estimate[static_cast<std::size_t>(lane)];
    CAPTURE(w, exact, found.mean(), found.estimate().standard_error);
    CHECK(within_error(found, exact, 3));
  }
}

// The test's own H must be right: its value at w = 0.5, mu = 1 is 1.2513 (Chandrasekhar 1960, table
// XI), and its integral over mu is 2 / w (1 - sqrt(1 - w)) (section 38, theorem 2).
TEST_CASE("the H function of these tests has Chandrasekhar's values", "[radiometry][volumes]") {
  CHECK(h_function(0.5, 1.0) == Approx(1.2513).margin(2e-4));
  double integral = 0.0;
  for (int i = 0; i < 20; ++i) integral += h_function(0.9, (i + 0.5) / 20) / 20;
  // 1e-3: the midpoint rule at the steep rise next to mu = 0.
  CHECK(integral == Approx(2.0 / 0.9 * (1.0 - std::sqrt(0.1))).epsilon(1e-3));
}

}  // namespace
}  // namespace nadir::radiometry
