#include <cmath>
#include <limits>
#include <string>

#include "core/error.hpp"
#include "sensor/detector/detector.hpp"
#include "support/catch.hpp"

namespace nadir::sensor {
namespace {

double sigma_at(const PublishedNoise& law, double radiance) {
  return std::sqrt(law.alpha * law.alpha + law.beta * radiance);
}

}  // namespace

TEST_CASE("noise through one figure has half of its variance from each term",
          "[sensor][detector]") {
  const PublishedNoise law = fit_noise({{22.0, 22.0 / 90.0}});
  CHECK(sigma_at(law, 22.0) == Approx(22.0 / 90.0).epsilon(1e-14));
  CHECK(law.alpha * law.alpha == Approx(law.beta * 22.0).epsilon(1e-14));
}

TEST_CASE("noise without light is all constant", "[sensor][detector]") {
  const PublishedNoise law = fit_noise({{0.0, 0.3}});
  CHECK(law.alpha == Approx(0.3).epsilon(1e-14));
  CHECK(law.beta == 0.0);
}

TEST_CASE("figures of one law return that law", "[sensor][detector]") {
  const PublishedNoise law{0.2, 0.015};
  const PublishedNoise found = fit_noise(
      {{1.0, sigma_at(law, 1.0)}, {30.0, sigma_at(law, 30.0)}, {90.0, sigma_at(law, 90.0)}});
  CHECK(found.alpha == Approx(law.alpha).epsilon(1e-10));  // the normal equations lose some digits
  CHECK(found.beta == Approx(law.beta).epsilon(1e-10));
}

TEST_CASE("noise that falls with the light is fitted by a constant", "[sensor][detector]") {
  const PublishedNoise law = fit_noise({{1.0, 0.4}, {10.0, 0.3}});
  CHECK(law.beta == 0.0);
  CHECK(law.alpha > 0.3);
  CHECK(law.alpha < 0.4);
}

TEST_CASE("noise that grows faster than the light is fitted by shot noise alone",
          "[sensor][detector]") {
  const PublishedNoise law = fit_noise({{1.0, 0.1}, {10.0, 2.0}});
  CHECK(law.alpha == 0.0);
  CHECK(law.beta > 0.0);
}

// Free residuals vanish for two figures; with more, the fit is the least of relative squares: any
// step away from it costs more.
TEST_CASE("the fit is the least of its neighbours", "[sensor][detector]") {
  const std::vector<NoiseFigure> figures{{1.0, 0.30}, {5.0, 0.42}, {20.0, 0.61}, {60.0, 1.1}};
  const PublishedNoise best = fit_noise(figures);
  const auto cost = [&](double constant, double slope) {
    double sum = 0.0;
    for (const NoiseFigure& f : figures) {
      const double r = (constant + slope * f.radiance) / (f.sigma * f.sigma) - 1.0;
      sum += r * r;
    }
    return sum;
  };
  const double constant = best.alpha * best.alpha;
  const double least = cost(constant, best.beta);
  for (const double step : {-1e-3, 1e-3}) {
    CHECK(cost(constant * (1.0 + step), best.beta) > least);
    CHECK(cost(constant, best.beta * (1.0 + step)) > least);
  }
}

TEST_CASE("figures that are none are refused", "[sensor][detector]") {
  CHECK_THROWS_AS(fit_noise({}), InputError);
  CHECK_THROWS_AS(fit_noise({{-1.0, 0.1}}), InputError);
  CHECK_THROWS_AS(fit_noise({{1.0, 0.0}}), InputError);
  CHECK_THROWS_AS(fit_noise({{1.0, std::numeric_limits<double>::quiet_NaN()}}), InputError);
}

}  // namespace nadir::sensor
