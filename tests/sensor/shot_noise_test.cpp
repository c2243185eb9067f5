#include "sensor/detector/shot_noise.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "core/random.hpp"
#include "support/catch.hpp"
#include "support/statistics.hpp"

namespace nadir::sensor {

TEST_CASE("places on the circle are cosine and sine", "[sensor][detector]") {
  double worst = 0.0;
  for (int i = 0; i < 4000; ++i) {
    const double turns = i / 4000.0, angle = 2.0 * std::numbers::pi * turns;
    const Vec2 p = on_circle(turns);
    worst = std::max({worst, std::abs(p.x - std::cos(angle)), std::abs(p.y - std::sin(angle))});
  }
  CHECK(worst < 3e-14);  // the sine's next term: (pi / 4)^15 / 15! = 2e-14
}

// Pearson's test of 20,000 counts; 0.001 is the false alarm, the seed is fixed. A mean wrong by 2 %
// fails it.
TEST_CASE("small counts follow Poisson's distribution", "[sensor][detector]") {
  const double mean = GENERATE(0.2, 3.0, 29.0);
  const int draws = 20000;
  std::vector<double> counts(120, 0.0), expected;
  Rng rng{7};
  for (int i = 0; i < draws; ++i) {
    counts[static_cast<std::size_t>(poisson_by_sum(mean, rng.next()))] += 1.0;
  }
  for (int n = 0; n < 120; ++n) {
    expected.push_back(draws * std::exp(n * std::log(mean) - mean - std::lgamma(n + 1.0)));
  }
  CHECK(support::chi_square_p_value(counts, expected) > 0.001);
}

// Quantile by quantile against the sum of the distribution's terms: the share of draws where the
// two differ, and never by more than one count.
TEST_CASE("large counts agree with Poisson's distribution quantile by quantile",
          "[sensor][detector]") {
  const double mean = GENERATE(32.0, 33.7, 60.0);
  double different = 0.0, greatest = 0.0, bias = 0.0;
  const int quantiles = 4000;
  for (int i = 0; i < quantiles; ++i) {
    const double z = -4.0 + 8.0 * (i + 0.5) / quantiles;
    const double u = 0.5 * std::erfc(-z / std::numbers::sqrt2);
    double term = std::exp(-mean), sum = term, exact = 0.0;
    while (u >= sum && exact < 400.0) {
      exact += 1.0;
      term *= mean / exact;
      sum += term;
    }
    const double difference = poisson_by_normal(mean, z) - exact;
    greatest = std::max(greatest, std::abs(difference));
    const double draws =
        8.0 / quantiles * std::exp(-0.5 * z * z) / std::sqrt(2.0 * std::numbers::pi);
    bias += draws * difference;
    different += draws * std::abs(difference);
  }
  CHECK(greatest <= 1.0);
  CHECK(different < 3e-3);
  CHECK(std::abs(bias) < 5e-3);  // steps of quantiles are 0.01 of a count
}

}  // namespace nadir::sensor
