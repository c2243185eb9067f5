#include "sensor/detector/line_noise.hpp"

#include <cmath>
#include <numbers>
#include <vector>

#include "core/random.hpp"
#include "support/catch.hpp"

namespace nadir::sensor {
namespace {

std::vector<double> drawn(const LineNoise::Rms& rms, int lines, std::uint64_t seed) {
  LineNoise noise{rms};
  std::vector<double> values;
  for (int line = 0; line < lines; ++line) {
    values.push_back(noise.next(mix(seed, static_cast<std::uint64_t>(line))));
  }
  return values;
}

/// Mean of the products of lines that lie so far apart.
double covariance(const std::vector<double>& values, std::size_t apart) {
  double sum = 0.0;
  for (std::size_t i = apart; i < values.size(); ++i) sum += values[i] * values[i - apart];
  return sum / static_cast<double>(values.size() - apart);
}

TEST_CASE("nothing is drawn where nothing is asked for", "[sensor][detector]") {
  for (const double value : drawn({}, 10, 1)) CHECK(value == 0.0);
}

TEST_CASE("flicker has its variance from the first line on", "[sensor][detector]") {
  // First lines of 4000 images: a variance known to 2.2 %; four of these.
  double squares = 0.0;
  for (std::uint64_t seed = 0; seed < 4000; ++seed) {
    const double first = drawn({0.0, 0.0, 3.0}, 1, seed).front();
    squares += first * first / 4000.0;
  }
  CHECK(squares == Approx(9.0).epsilon(0.09));
}

TEST_CASE("flicker's covariance is that of its relaxations", "[sensor][detector]") {
  // 400,000 lines; the longest memory of 2048 lines leaves some 100 independent pieces for a
  // thirteenth of the variance, the rest is known better: 0.06 is some four sigma.
  const auto values = drawn({0.0, 0.0, 1.0}, 400000, 7);
  for (const std::size_t apart : {0U, 1U, 8U, 64U, 512U}) {
    double expected = 0.0;
    for (int k = -1; k < 12; ++k) {
      expected += std::exp(-static_cast<double>(apart) / std::exp2(k)) / 13.0;
    }
    CAPTURE(apart);
    CHECK(covariance(values, apart) == Approx(expected).margin(0.06));
  }
}

TEST_CASE("the sum of relaxations is 1/f over three decades", "[sensor][detector]") {
  const auto power = [](double f) {  // of the autoregressions, one cycle a line being 1
    double sum = 0.0;
    for (int k = -1; k < 12; ++k) {
      const double rho = std::exp(-std::exp2(-k));
      const double turn = std::cos(2.0 * std::numbers::pi * f);
      sum += (1.0 - rho * rho) / (1.0 - 2.0 * rho * turn + rho * rho) / 13.0;
    }
    return sum;
  };
  const double middle = 0.01 * power(0.01);
  for (double f = 1.0 / 2700.0; f < 1.0 / 2.5; f *= 1.3) {
    CAPTURE(f);
    CHECK(f * power(f) == Approx(middle).epsilon(0.1));
  }
}

}  // namespace
}  // namespace nadir::sensor
