#include "support/statistics.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <numbers>
#include <numeric>
#include <stdexcept>

namespace nadir::support {
namespace {

constexpr double precision = 1e-15;

/// P(a, x) by its power series, for x < a + 1 (Abramowitz & Stegun 6.5.29).
double gamma_p_series(double a, double x) {
  double term = 1.0 / a, sum = term;
  for (double n = a + 1.0; term > precision * sum; n += 1.0) {
    term *= x / n;
    sum += term;
  }
  return sum * std::exp(a * std::log(x) - x - std::lgamma(a));
}

/// Q(a, x) by its continued fraction, for x >= a + 1 (Abramowitz & Stegun 6.5.31), evaluated
/// forwards with Lentz's method.
double gamma_q_fraction(double a, double x) {
  double b = x + 1.0 - a, c = 1.0 / std::numeric_limits<double>::min(), d = 1.0 / b, h = d;
  for (int n = 1; n < 10'000; ++n) {
    const double numerator = n * (a - n);
    b += 2.0;
    d = 1.0 / (b + numerator * d);
    c = b + numerator / c;
    h *= c * d;
    if (std::abs(c * d - 1.0) < precision) break;
  }
  return h * std::exp(a * std::log(x) - x - std::lgamma(a));
}

}  // namespace

std::uint64_t test_seed() {
  const char* text = std::getenv("NADIR_TEST_SEED");
  return text == nullptr ? 20260621 : std::strtoull(text, nullptr, 10);
}

double sidak(double alpha, int n) { return -std::expm1(std::log1p(-alpha) / n); }

double chi_square_tail(double statistic, int degrees) {
  const double a = 0.5 * degrees, x = 0.5 * statistic;
  if (x <= 0.0) return 1.0;
  return x < a + 1.0 ? 1.0 - gamma_p_series(a, x) : gamma_q_fraction(a, x);
}

double chi_square_p_value(const std::vector<double>& observed,
                          const std::vector<double>& expected) {
  if (observed.size() != expected.size()) throw std::logic_error{"as many counts as expectations"};
  double statistic = 0.0, pooled_observed = 0.0, pooled_expected = 0.0;
  int cells = 0;
  const auto count_cell = [&](double o, double e) {
    statistic += (o - e) * (o - e) / e;
    ++cells;
  };
  for (std::size_t i = 0; i < observed.size(); ++i) {
    if (expected[i] >= 5.0) {
      count_cell(observed[i], expected[i]);
    } else {
      pooled_observed += observed[i];
      pooled_expected += expected[i];
    }
  }
  if (pooled_expected > 0.0) count_cell(pooled_observed, pooled_expected);
  if (pooled_expected <= 0.0 && pooled_observed > 0.0) return 0.0;  // a draw where none may fall
  return cells < 2 ? 1.0 : chi_square_tail(statistic, cells - 1);
}

double chi_square_p_value(const std::vector<double>& observed) {
  const double total = std::accumulate(observed.begin(), observed.end(), 0.0);
  return chi_square_p_value(
      observed, std::vector<double>(observed.size(), total / static_cast<double>(observed.size())));
}

double normal_p_value(double z) { return std::erfc(std::abs(z) / std::numbers::sqrt2); }

}  // namespace nadir::support
