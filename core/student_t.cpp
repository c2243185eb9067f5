#include "core/student_t.hpp"

#include <cmath>
#include <limits>
#include <numbers>

namespace nadir {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// ln Gamma((nu + 1) / 2) - ln Gamma(nu / 2). The difference of the two logarithms loses 1e-11 at
/// 10^4 degrees, so that large ones take the ratio's asymptotic series, whose next term is below
/// 1e-14 from 200 on. Source: Tricomi & Erdelyi, Pacific J. Math. 1, 133 (1951), with z = nu / 2.
double log_gamma_step(int nu) {
  const double z = 0.5 * nu;
  if (nu < 200) return std::lgamma(z + 0.5) - std::lgamma(z);
  const double y = 1.0 / z;
  return 0.5 * std::log(z) - y * (1.0 / 8.0 - y * y * (1.0 / 192.0 - y * y / 640.0));
}

/// Continued fraction of the incomplete beta function by Lentz's method, modified by Thompson and
/// Barnett. Converges fast for x < (a + 1) / (a + b + 2).
double beta_fraction(double x, double a, double b) {
  constexpr double tiny = 1e-300;
  double c = 1.0, d = 1.0 / (1.0 - (a + b) * x / (a + 1.0)), value = d;
  const auto advance = [&](double term) {
    d = 1.0 + term * d;
    c = 1.0 + term / c;
    d = 1.0 / (std::fabs(d) < tiny ? tiny : d);
    c = std::fabs(c) < tiny ? tiny : c;
    value *= d * c;
    return std::fabs(d * c - 1.0) > 1e-16;
  };
  // It takes about the square root of max(a, b) steps; the limit only ends a circle of roundings.
  for (int m = 1; m < 10'000; ++m) {
    const double m2 = 2.0 * m;
    advance(m * (b - m) * x / ((a + m2 - 1.0) * (a + m2)));
    if (!advance(-(a + m) * (a + b + m) * x / ((a + m2) * (a + m2 + 1.0)))) break;
  }
  return value;
}

/// ln of t times the density at t > 0; t as its logarithm.
double log_density_times_t(double log_t, int nu) {
  const double t = std::exp(log_t);
  return log_t + log_gamma_step(nu) - 0.5 * std::log(nu * std::numbers::pi) -
         0.5 * (nu + 1.0) * std::log1p(t * t / nu);
}

/// ln of the probability to exceed t > 0.
double log_tail(double log_t, int nu) {
  const double a = 0.5 * nu, b = 0.5;
  const double t = std::exp(log_t), sum = nu + t * t;
  const double x = nu / sum, y = t * t / sum;  // y = 1 - x
  // t p(t) = x^a y^b / B(a, b): the factor in front of the fraction, so shared with the density.
  const double front = log_density_times_t(log_t, nu);
  if (x < (a + 1.0) / (a + b + 2.0)) {
    return front + std::log(0.5 * beta_fraction(x, a, b) / a);
  }
  return std::log(0.5 - 0.5 * std::exp(front) * beta_fraction(y, b, a) / b);
}

/// The t > 0 that is exceeded with a probability below 1/2.
double upper_quantile(double tail, int nu) {
  const double density_at_0 = std::exp(log_gamma_step(nu) - 0.5 * std::log(nu * std::numbers::pi));
  // The density falls with t: this t is too small, and not by much near the middle.
  double log_t = std::log((0.5 - tail) / density_at_0);
  for (int i = 0; i < 100; ++i) {
    const double log_q = log_tail(log_t, nu);
    const double slope = -std::exp(log_density_times_t(log_t, nu) - log_q);
    const double step = (std::log(tail) - log_q) / slope;
    log_t += step;
    // Newton's steps square: one below 1e-7 leaves 1e-14.
    if (std::fabs(step) < 1e-7) break;
  }
  return std::exp(log_t);
}

}  // namespace

double student_t_quantile(double probability, int degrees_of_freedom) {
  if (!(probability > 0.0 && probability < 1.0) || degrees_of_freedom < 1) return nan;
  if (probability == 0.5) return 0.0;
  return probability < 0.5 ? -upper_quantile(probability, degrees_of_freedom)
                           : upper_quantile(1.0 - probability, degrees_of_freedom);
}

Interval confidence_interval(const Estimate& estimate, int replicates, double level) {
  if (!(level > 0.0 && level < 1.0)) return {nan, nan};
  // From the lower side: 1 - level keeps its digits for levels near 1.
  const double t = -student_t_quantile(0.5 * (1.0 - level), replicates - 1);
  const double half_width = t * estimate.standard_error;
  return {estimate.mean - half_width, estimate.mean + half_width};
}

}  // namespace nadir
