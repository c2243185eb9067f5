#include "sensor/optics/stray_light.hpp"

#include <math.h>  // j0 of POSIX

#include <cmath>
#include <numbers>

#include "support/catch.hpp"
#include "support/quadrature.hpp"

namespace nadir::sensor {
namespace {

// (1 + (r/c)^2)^(1-s) by hand: with s = 2 and c = 1 the share within r is
// (1 - 1 / (1 + r^2)) / (1 - 1 / (1 + R^2)).
TEST_CASE("stray light falls off as it is told", "[sensor][spread]") {
  const StraySpread stray{0.1, 1.0, 2.0, 10.0};
  for (const double r : {0.1, 1.0, 3.0, 9.9}) {
    const double share = (1.0 - 1.0 / (1.0 + r * r)) / (1.0 - 1.0 / 101.0);
    CHECK(stray_distance(stray, share) == Approx(r).epsilon(1e-9));
  }
  for (const double slope : {0.0, 0.5, 1.0, 1.5, 3.0}) {
    const StraySpread other{0.1, 2e-6, slope, 1e-3};
    CHECK(stray_distance(other, 0.0) == 0.0);
    CHECK(stray_distance(other, 1.0) == Approx(1e-3).epsilon(1e-6));
    // Density by distances: (1 + (r/c)^2)^-s per unit area.
    const double step = 1e-5, a = stray_distance(other, 0.3), b = stray_distance(other, 0.3 + step);
    const double c = stray_distance(other, 0.6), d = stray_distance(other, 0.6 + step);
    const auto falloff = [&](double r) { return std::pow(1.0 + r * r / 4e-12, -slope); };
    CHECK((b * b - a * a) / (d * d - c * c) == Approx(falloff(c) / falloff(a)).epsilon(1e-3));
  }
}

TEST_CASE("the transform of stray light is that of its density", "[sensor][spread]") {
  for (const double slope : {0.5, 1.0, 1.5, 2.5}) {
    const StraySpread stray{0.1, 3.0, slope, 300.0};
    const auto density = [&](long double r) {
      return std::pow(1.0L + r * r / 9.0L, static_cast<long double>(-slope)) * r;
    };
    const long double all = support::integrate(density, 0.0L, 300.0L, 30);
    for (const double f : {1e-3, 1e-2, 0.05}) {
      const auto turned = [&](long double r) {
        return density(r) *
               static_cast<long double>(::j0(2.0 * std::numbers::pi * f * static_cast<double>(r)));
      };
      const long double expected = support::integrate(turned, 0.0L, 300.0L, 40) / all;
      CAPTURE(slope, f);
      CHECK(stray_mtf(stray, f) ==
            Approx(static_cast<double>(expected)).margin(3e-4));  // rings far out are wide
    }
  }
}

}  // namespace
}  // namespace nadir::sensor
