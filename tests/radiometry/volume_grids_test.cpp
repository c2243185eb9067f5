#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "radiometry/planck_table.hpp"
#include "radiometry/volume_helpers.hpp"
#include "support/quadrature.hpp"

namespace nadir::radiometry {
namespace {

using namespace volume_test;  // NOLINT: the helpers of these tests alone

const float nan = std::numeric_limits<float>::quiet_NaN();

/// A box of 1 m with a grid in it.
Volume cube(spectral::Curve absorption, spectral::Curve scattering,
            std::shared_ptr<const ScalarGrid> density) {
  Volume volume = slab(std::move(absorption), std::move(scattering));
  volume.name = "cube";
  volume.region = geometry::Region{geometry::Box{{0, 0, 0}, {1, 1, 1}}, Affine{}};
  volume.density = std::move(density);
  return volume;
}
geometry::Ray through_cube() { return {{0.4, 0.6, 3.0}, {0.0, 0.0, -1.0}}; }

/// Density 4 z + 0.2 between the outermost centres of 40 cells, held beyond.
double ramp(double z) { return 0.2 + 4.0 * std::clamp(z, 0.0125, 0.9875); }
std::shared_ptr<const ScalarGrid> ramp_grid() { return grid({2, 3, 40}, ramp); }

TEST_CASE("a grid of one density is the homogeneous volume, to the last digit of the exact part",
          "[radiometry][volumes]") {
  const double tau = GENERATE(1e-8, 1.0, 50.0);
  const BoundVolumes plain{{cube(tau * coloured(), tau * coloured(), nullptr)}, lanes()};
  const BoundVolumes gridded{{cube(0.5 * tau * coloured(), 0.5 * tau * coloured(),
                                   grid({7, 9, 11}, [](double) { return 2.0; }))},
                             lanes()};
  const geometry::Ray slanted{{-1.0, -0.7, 2.2}, normalised({1.0, 0.8, -1.2})};
  const auto a = plain.transmittance(slanted, 1e3, numbers(1));
  const auto b = gridded.transmittance(slanted, 1e3, numbers(2));
  const auto c = gridded.segment(slanted, 1e3, numbers(3)).transmittance;
  // 3e-6: float, times the optical depth of 50 that the exponent sums up block by block.
  for (int lane = 0; lane < 3; ++lane) {
    CHECK(b[lane] == Approx(a[lane]).epsilon(3e-6 * std::max(1.0, tau)));
    CHECK(c[lane] == Approx(a[lane]).epsilon(3e-6 * std::max(1.0, tau)));
  }
}

TEST_CASE("a grid's transmittance is exp of the integral of its density", "[radiometry][volumes]") {
  const double sigma = GENERATE(1e-8, 0.3, 3.0);
  const BoundVolumes volumes{
      {cube(sigma * coloured(), spectral::Curve::constant(0.0), ramp_grid())}, lanes()};
  std::vector<Welford> shadow(3), view(3);
  for (std::uint32_t i = 0; i < 4000; ++i) {
    const auto t = volumes.transmittance(through_cube(), 1e3, numbers(i));
    const auto s = volumes.segment(through_cube(), 1e3, numbers(i)).transmittance;
    for (int lane = 0; lane < 3; ++lane) {
      REQUIRE((t[lane] >= 0.0F && t[lane] <= 1.0F));
      shadow[static_cast<std::size_t>(lane)].add(static_cast<double>(t[lane]));
      view[static_cast<std::size_t>(lane)].add(static_cast<double>(s[lane]));
    }
  }
  // The ramp is linear, and symmetric about the middle: its mean is 2.2.
  for (int lane = 0; lane < 3; ++lane) {
    const double exact = std::exp(-2.2 * sigma * share_of(lane));
    const Welford& of_shadow = shadow[static_cast<std::size_t>(lane)];
    CAPTURE(sigma, lane, exact, of_shadow.mean());
    CHECK(within_error(of_shadow, exact, 18));
    CHECK(within_error(view[static_cast<std::size_t>(lane)], exact, 18));
  }
}

TEST_CASE("a grid's emission at its own temperatures is the integral along the ray",
          "[radiometry][volumes]") {
  const double sigma = GENERATE(1e-8, 0.5, 20.0);
  const bool flies = GENERATE(false, true);
  Volume volume = cube(sigma * coloured(), spectral::Curve::constant(0.0), ramp_grid());
  volume.temperature = grid({1, 1, 40}, [](double z) { return 300.0 + 500.0 * z; });
  const BoundVolumes volumes{{volume}, lanes()};
  std::vector<Welford> estimate(3);
  for (std::uint32_t i = 0; i < 3000; ++i) {
    spectral::Spectrum throughput{3, 1.0F};
    spectral::SpectrumSum radiance{3};
    if (flies) {
      CHECK_FALSE(volumes.fly(through_cube(), 1e3, numbers(i), throughput, radiance).has_value());
    } else {
      radiance.add(volumes.segment(through_cube(), 1e3, numbers(i)).emission);
    }
    for (int lane = 0; lane < 3; ++lane) {
      estimate[static_cast<std::size_t>(lane)].add(radiance[lane]);
    }
  }
  for (int lane = 0; lane < 3; ++lane) {
    const double s = sigma * share_of(lane);
    // From the top down; above 0.9875 and below 0.0125 the grid is held.
    constexpr int steps = 4000;
    double exact = 0.0, depth = 0.0;
    for (int i = 0; i < steps; ++i) {
      const double z = 1.0 - (i + 0.5) / steps, within = std::clamp(z, 0.0125, 0.9875);
      const double piece = s * ramp(z) / steps;
      const double b = spectral::planck(lanes()[lane], Kelvin{300.0 + 500.0 * within}).value;
      exact += std::exp(-depth) * -std::expm1(-piece) * b;
      depth += piece;
    }
    const Welford& found = estimate[static_cast<std::size_t>(lane)];
    CAPTURE(sigma, flies, lane, exact, found.mean(), found.estimate().standard_error);
    CHECK(within_error(found, exact, 18));
  }
}

// Two ways to the same mean: where light is scattered, and how much, in overlapping media of
// different colours and densities, one of them a grid.
TEST_CASE("flights and segments scatter the same light at the same places",
          "[radiometry][volumes]") {
  const bool gridded = GENERATE(false, true);
  Volume first = cube(0.2 * coloured(), 2.0 * coloured(), gridded ? ramp_grid() : nullptr);
  Volume second = cube(per_lane({0.1, 0.0, 1.0}), per_lane({0.2, 1.0, 3.0}), nullptr);
  second.region = geometry::Region{geometry::Box{{0.0, 0.0, 0.1}, {1.0, 1.0, 0.9}}, Affine{}};
  if (gridded) second.density = ramp_grid();
  second.medium.phase = materials::RayleighPhase{};
  const BoundVolumes volumes{{first, second}, lanes()};
  const auto inside = [](double z) { return std::abs(z - 0.5) < 0.4; };
  std::vector<Welford> flown(9), seen(9), far(6);
  const auto note = [&](std::vector<Welford>& means, int lane, double weight, double z) {
    means[static_cast<std::size_t>(lane)].add(weight);
    means[static_cast<std::size_t>(lane + 3)].add(weight * z);
    means[static_cast<std::size_t>(lane + 6)].add(weight * z * z);
  };
  for (std::uint32_t i = 0; i < 6000; ++i) {
    spectral::Spectrum throughput{3, 1.0F};
    spectral::SpectrumSum radiance{3};
    const auto event = volumes.fly(through_cube(), 1e3, numbers(i), throughput, radiance);
    const auto segment = volumes.segment(through_cube(), 1e3, numbers(i));
    for (int lane = 0; lane < 3; ++lane) {
      const auto kept = static_cast<double>(throughput[lane]);
      note(flown, lane, event ? kept : 0.0, event ? event->position.z : 0.0);
      far[static_cast<std::size_t>(lane)].add(event ? 0.0 : kept);
      note(seen, lane, static_cast<double>(segment.event->weight[lane]), segment.event->position.z);
    }
  }
  for (int lane = 0; lane < 3; ++lane) {
    const auto s1 = [&](double c, double z) {
      return c * share_of(lane) * (gridded ? ramp(z) : 1.0);
    };
    const double s2 = second.medium.scattering.at(lanes())[lane];
    const double a2 = second.medium.absorption.at(lanes())[lane];
    const auto density2 = [&](double z) {
      return !inside(z) ? 0.0 : gridded ? ramp((z - 0.1) / 0.8) : 1.0;
    };
    constexpr int steps = 20000;
    double depth = 0.0, moments[3] = {};
    for (int i = 0; i < steps; ++i) {
      const double z = 1.0 - (i + 0.5) / steps;
      const double scattering = s1(2.0, z) + s2 * density2(z);
      const double extinction = scattering + s1(0.2, z) + a2 * density2(z);
      const double left = std::exp(-depth - 0.5 * extinction / steps);
      for (int k = 0; k < 3; ++k) moments[k] += left * scattering * std::pow(z, k) / steps;
      depth += extinction / steps;
    }
    CAPTURE(gridded, lane);
    CHECK(within_error(far[static_cast<std::size_t>(lane)], std::exp(-depth), 42));
    for (int k = 0; k < 3; ++k) {
      const auto at = static_cast<std::size_t>(lane + 3 * k);
      CAPTURE(k, moments[k], flown[at].mean(), seen[at].mean());
      CHECK(within_error(flown[at], moments[k], 42));
      CHECK(within_error(seen[at], moments[k], 42));
    }
  }
}

// The hot foot of a cold thick plume: its light comes through an optical depth of 8.8, where
// roulette has long set in.
TEST_CASE("light through a thick grid is not lost to roulette", "[radiometry][volumes]") {
  const bool flies = GENERATE(false, true);
  Volume volume = cube(spectral::Curve::constant(4.0), spectral::Curve::constant(0.0), ramp_grid());
  volume.temperature = grid({1, 1, 1}, [](double) { return 0.0; });
  Volume lamp = volume;
  lamp.density = nullptr;
  lamp.medium.absorption = spectral::Curve::constant(1e-3);
  lamp.temperature = Kelvin{1000.0};
  lamp.region = geometry::Region{geometry::Box{{0, 0, -1}, {1, 1, 0}}, Affine{}};
  const BoundVolumes volumes{{volume, lamp}, lanes()};
  Welford estimate;
  for (std::uint32_t i = 0; i < 4000; ++i) {
    spectral::Spectrum throughput{3, 1.0F};
    spectral::SpectrumSum radiance{3};
    if (flies) {
      static_cast<void>(volumes.fly(through_cube(), 1e3, numbers(i), throughput, radiance));
    } else {
      radiance.add(volumes.segment(through_cube(), 1e3, numbers(i)).emission);
    }
    estimate.add(radiance[2]);
  }
  const double exact =
      std::exp(-8.8) * -std::expm1(-1e-3) * spectral::planck(10.0_um, 1000.0_K).value;
  CAPTURE(flies, exact, estimate.mean(), estimate.estimate().standard_error);
  CHECK(within_error(estimate, exact, 2));
  // The error bar is narrow enough to tell: a roulette without its factor would be 10 times too
  // low.
  CHECK(estimate.estimate().standard_error < 0.15 * exact);
}

TEST_CASE("no weight is negative, infinite or beyond what the lanes allow",
          "[radiometry][volumes]") {
  const double tau = GENERATE(1e-8, 1.0, 1e3);
  Volume thick = cube(tau * per_lane({0.0, 1e-3, 1.0}).max_value() * coloured(),
                      per_lane({tau, 1e-6 * tau, 0.0}), ramp_grid());
  thick.temperature = grid({1, 1, 3}, [](double z) { return 6000.0 * z; });
  const BoundVolumes volumes{{thick}, lanes()};
  for (std::uint32_t i = 0; i < 300; ++i) {
    spectral::Spectrum throughput{3, 1.0F};
    spectral::SpectrumSum radiance{3};
    static_cast<void>(volumes.fly(through_cube(), 1e3, numbers(i), throughput, radiance));
    const auto segment = volumes.segment(through_cube(), 1e3, numbers(i));
    for (int lane = 0; lane < 3; ++lane) {
      // The mean never grows, so that a lane of three has at most 3; float.
      CHECK((throughput[lane] >= 0.0F && throughput[lane] <= 3.0001F));
      CHECK((radiance[lane] >= 0.0 && std::isfinite(radiance[lane])));
      CHECK((segment.transmittance[lane] >= 0.0F && segment.transmittance[lane] <= 1.0F));
      if (segment.event) {
        CHECK((segment.event->weight[lane] >= 0.0F && segment.event->weight[lane] <= 3.0001F));
      }
    }
  }
}

TEST_CASE("volumes in a row and volumes that overlap multiply", "[radiometry][volumes]") {
  std::vector<Volume> many;
  for (int i = 0; i < 45; ++i) {  // more than one window of crossings; four overlap
    Volume one = cube(0.1 * coloured(), spectral::Curve::constant(0.0), nullptr);
    one.region = geometry::Region{geometry::Box{{0, 0, -1.0 * i}, {1, 1, 3.5 - i}}, Affine{}};
    many.push_back(one);
  }
  std::reverse(many.begin() + 10, many.end());
  const BoundVolumes volumes{many, lanes()};
  const geometry::Ray ray{{0.5, 0.5, 50.0}, {0.0, 0.0, -1.0}};
  const double exact = std::exp(-0.1 * 45 * 3.5);
  // Float: 200 factors.
  CHECK(volumes.transmittance(ray, 1e3, numbers(1))[0] == Approx(exact).epsilon(2e-5));
  CHECK(volumes.segment(ray, 1e3, numbers(1)).transmittance[0] == Approx(exact).epsilon(2e-5));
}

// The stated bound of the table.
TEST_CASE("tabulated Planck radiance is within 1e-4 of the function", "[radiometry][volumes]") {
  for (const auto& all : {spectral::Lanes{{0.3_um, 1.0_um, 4.0_um, 14.0_um}},
                          spectral::Lanes{{8.0_um, 14.0_um}}, lanes()}) {
    const PlanckTable table{all, {3.0_K, 6000.0_K}};
    double worst = 0.0;
    for (double t = 3.0; t <= 6000.0; t *= 1.0013) {
      const auto found = table.at(t);
      for (int lane = 0; lane < all.count(); ++lane) {
        const double exact = spectral::planck(all[lane], Kelvin{t}).value;
        if (exact < 1e-35) {
          CHECK((found[lane] >= 0.0F && found[lane] < 2e-35F));
        } else {
          worst = std::max(worst, std::abs(static_cast<double>(found[lane]) / exact - 1.0));
        }
      }
    }
    CAPTURE(worst);
    CHECK(worst < 1e-4);
  }
  CHECK(PlanckTable{lanes(), {0.0_K, 0.0_K}}.at(0.0)[2] == 0.0F);
  const PlanckTable narrow{lanes(), {300.0_K, 300.0_K}};
  CHECK(narrow.at(300.0)[2] == Approx(spectral::planck(10.0_um, 300.0_K).value).epsilon(1e-6));
}

std::string refusal(const Volume& volume) {
  try {
    const BoundVolumes bound{{volume}, lanes()};
    return "(accepted)";
  } catch (const InputError& error) {
    CHECK(error.issues().front().where.line == 7);
    return error.issues().front().message;
  }
}

TEST_CASE("volumes that make no sense are refused where they stand", "[radiometry][volumes]") {
  const auto zero = spectral::Curve::constant(0.0), one = spectral::Curve::constant(1.0);
  Volume good = cube(one, zero, grid({2, 2, 2}, [](double) { return 1.0; }));
  good.where = {"scene.xml", 7, 3};
  Volume bad = good;
  bad.medium.absorption = spectral::Curve::constant(-1.0);
  CHECK(refusal(bad) ==
        "volume \"cube\": absorption is -1 per m at 0.6 um; it must be from 0 to 1e12");
  bad = good;
  bad.medium.scattering = spectral::Curve{{1.0, 20.0}, {1.0, 1.0}, spectral::Outside::reject};
  CHECK(refusal(bad) == "volume \"cube\": scattering is not tabulated at 0.6 um");
  bad = good;
  bad.region = geometry::Region{geometry::Sphere{{0, 0, 0}, 1.0}, Affine{}};
  CHECK(refusal(bad) ==
        "volume \"cube\": the density grid needs a box, this volume has another shape");
  bad = good;
  bad.density = std::make_shared<ScalarGrid>(ScalarGrid{2, 2, 3, std::vector<float>(8, 1.0F)});
  CHECK(refusal(bad) == "volume \"cube\": the density grid is 2 x 2 x 3 cells, but has 8 values");
  bad.density = std::make_shared<ScalarGrid>(ScalarGrid{1, 1, 2, {1.0F, -2.0F}});
  CHECK(refusal(bad) ==
        "volume \"cube\": the density grid has the value -2 in column 1, row 1, layer 2; it must "
        "be finite and not negative");
  bad = good;
  bad.temperature = std::make_shared<const ScalarGrid>(ScalarGrid{1, 1, 1, {nan}});
  CHECK(refusal(bad).find("the temperature grid has the value nan") != std::string::npos);
  bad = good;
  bad.medium.phase = materials::HenyeyGreenstein{spectral::Curve::constant(-1.5)};
  CHECK(refusal(bad) ==
        "volume \"cube\": g of the Henyey-Greenstein phase function is -1.5; it must be above -1 "
        "and below 1");
  CHECK_THROWS_AS((BoundVolumes{std::vector<Volume>(17, good), lanes()}), InputError);
  CHECK_NOTHROW(BoundVolumes{std::vector<Volume>(16, good), lanes()});
  CHECK((BoundVolumes{{cube(zero, zero, nullptr)}, lanes()}).empty());
}

}  // namespace
}  // namespace nadir::radiometry
