#include "core/student_t.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/random.hpp"
#include "support/catch.hpp"
#include "support/quadrature.hpp"
#include "support/statistics.hpp"

using namespace nadir;

// 1e-11: the header promises 1e-10; measured 2e-12 at worst (199 degrees, before the series for the
// gamma functions takes over).
constexpr double accuracy = 1e-11;

// Closed forms: W. T. Shaw, J. Comput. Finance 9(4), 37 (2006), section 2.
TEST_CASE("Student's quantile has its closed forms for 1, 2 and 4 degrees of freedom",
          "[core][student_t]") {
  const double p = GENERATE(1e-9, 1e-4, 0.025, 0.3, 0.49999, 0.6, 0.975, 0.9995);
  CAPTURE(p);
  const double alpha = 4.0 * p * (1.0 - p);
  // Near 0.9995 p itself is known to 1e-16 / (1 - p) only: that is 2e-13 here.
  CHECK(student_t_quantile(p, 1) == Approx(p < 0.5 ? -1.0 / std::tan(std::numbers::pi * p)
                                                   : 1.0 / std::tan(std::numbers::pi * (1.0 - p)))
                                        .epsilon(accuracy));
  CHECK(student_t_quantile(p, 2) ==
        Approx((2.0 * p - 1.0) * std::sqrt(2.0 / alpha)).epsilon(accuracy));
  const double root = std::sqrt(alpha);
  const double four = 2.0 * std::sqrt(std::cos(std::acos(root) / 3.0) / root - 1.0);
  // 1e-6 in the middle: there the closed form itself loses its digits in the difference from 1.
  CHECK(student_t_quantile(p, 4) ==
        Approx(p < 0.5 ? -four : four).epsilon(std::fabs(p - 0.5) < 1e-3 ? 1e-6 : accuracy));
}

// Two-sided 95 % and 99 % columns, NIST/SEMATECH e-Handbook of Statistical Methods, 1.3.6.7.2,
// three decimals.
TEST_CASE("Student's quantile agrees with published tables", "[core][student_t]") {
  struct Row {
    int degrees;
    double at_975, at_995;
  };
  for (const Row& row : std::array<Row, 6>{{{1, 12.706, 63.657},
                                            {3, 3.182, 5.841},
                                            {7, 2.365, 3.499},
                                            {15, 2.131, 2.947},
                                            {31, 2.040, 2.744},
                                            {100, 1.984, 2.626}}}) {
    CAPTURE(row.degrees);
    CHECK(student_t_quantile(0.975, row.degrees) == Approx(row.at_975).epsilon(0).margin(5e-4));
    CHECK(student_t_quantile(0.995, row.degrees) == Approx(row.at_995).epsilon(0).margin(5e-4));
  }
}

// Roots of the regularised incomplete beta function in 40 digits (mpmath 1.x, betainc, findroot).
TEST_CASE("Student's quantile agrees with forty-digit values", "[core][student_t]") {
  struct Value {
    double tail;
    int degrees;
    double t;
  };
  for (const Value& v : std::array<Value, 8>{{{0.025, 9, 2.2621571627982055},
                                              {1e-9, 9, 23.729919819378502},
                                              {1e-9, 3, 1033.1096745038077},
                                              {1e-9, 1000, 6.0536902720798336},
                                              {0.1, 199, 1.285820209259409},
                                              {0.1, 200, 1.285798793994801},
                                              {0.1, 10000, 1.2816362297304775},
                                              {0.4999, 7, 0.00025974603090254504}}}) {
    CAPTURE(v.tail, v.degrees);
    CHECK(student_t_quantile(v.tail, v.degrees) == Approx(-v.t).epsilon(accuracy));
  }
}

TEST_CASE("Student's density integrates to the probability that belongs to the quantile",
          "[core][student_t]") {
  const int nu = GENERATE(3, 6, 31, 250);
  const double p = GENERATE(0.6, 0.975, 0.999);
  CAPTURE(nu, p);
  const long double scale = std::exp(std::lgamma(0.5L * (nu + 1)) - std::lgamma(0.5L * nu)) /
                            std::sqrt(nu * std::numbers::pi_v<long double>);
  const auto density = [&](long double t) {
    return scale * std::pow(1.0L + t * t / nu, -0.5L * (nu + 1));
  };
  const long double inside = support::integrate(density, 0.0L, student_t_quantile(p, nu));
  CHECK(static_cast<double>(0.5L + inside) == Approx(p).epsilon(1e-13));
}

TEST_CASE("Student's quantile tends to the normal one, and is 0 in the middle",
          "[core][student_t]") {
  // 97.5 % of the standard normal law; Cornish-Fisher's first term is (z^3 + z) / (4 nu).
  constexpr double z = 1.959963984540054;
  constexpr int many = 1'000'000;  // the second term is below 1e-11; rounding: the header's 1e-10
  CHECK(student_t_quantile(0.975, many) ==
        Approx(z + (z * z * z + z) / (4.0 * many)).epsilon(1e-10));
  CHECK(student_t_quantile(0.5, 5) == 0.0);
}

TEST_CASE("Student's quantile is not a number outside of its domain", "[core][student_t]") {
  CHECK(std::isnan(student_t_quantile(0.0, 5)));
  CHECK(std::isnan(student_t_quantile(1.0, 5)));
  CHECK(std::isnan(student_t_quantile(-0.1, 5)));
  CHECK(std::isnan(student_t_quantile(std::numeric_limits<double>::quiet_NaN(), 5)));
  CHECK(std::isnan(student_t_quantile(0.9, 0)));
}

TEST_CASE("a confidence interval lies around the mean, and one replicate has none",
          "[core][student_t]") {
  const Interval interval = confidence_interval({.mean = 3.0, .standard_error = 0.5}, 10, 0.95);
  CHECK(interval.lower == Approx(3.0 - 0.5 * 2.2621571627982055).epsilon(accuracy));
  CHECK(interval.upper == Approx(3.0 + 0.5 * 2.2621571627982055).epsilon(accuracy));
  CHECK(interval.contains(3.0));
  CHECK_FALSE(interval.contains(4.2));
  CHECK(std::isnan(confidence_interval({.mean = 3.0}, 1, 0.95).lower));
  CHECK(std::isnan(confidence_interval({.mean = 3.0, .standard_error = 0.5}, 10, 1.0).upper));
}

// z-test of the number of intervals that cover, at p = 1e-4: 20 000 sets of 4 normal replicates
// have a standard deviation of 0.0015 in the share that covers, so that the normal quantile in
// place of Student's (share 0.855) fails at 62 sigma.
TEST_CASE("95 of 100 confidence intervals of four replicates cover the true mean",
          "[core][student_t]") {
  constexpr int sets = 20'000, replicates = 4;
  constexpr double level = 0.95, truth = 7.0;
  const double t = student_t_quantile(0.975, replicates - 1);
  Rng rng{support::test_seed(), 0};
  int covering = 0;
  for (int set = 0; set < sets; ++set) {
    Welford statistics;
    for (int i = 0; i < replicates; ++i) {  // Box and Muller's normal numbers
      const double radius = std::sqrt(-2.0 * std::log(1.0 - rng.next()));
      statistics.add(truth + radius * std::cos(2.0 * std::numbers::pi * rng.next()));
    }
    const Estimate estimate = statistics.estimate();
    covering += std::fabs(estimate.mean - truth) <= t * estimate.standard_error ? 1 : 0;
  }
  const double z = (covering - level * sets) / std::sqrt(level * (1.0 - level) * sets);
  CAPTURE(covering, z);
  CHECK(support::normal_p_value(z) > 1e-4);
}
