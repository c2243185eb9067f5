#include <cmath>
#include <vector>

#include "core/random.hpp"
#include "core/statistics.hpp"
#include "sim/study/pareto.hpp"
#include "sim/study/rate_fit.hpp"
#include "sim/study_support.hpp"
#include "support/catch.hpp"

namespace nadir::sim {
namespace {

std::vector<RatePoint> law(double bias, double rate, double relative_sigma) {
  std::vector<RatePoint> points;
  for (double paths = 1.0; paths <= 4096.0; paths *= 4.0) {
    const double error = std::hypot(bias, 0.7 * std::pow(paths, -rate));
    points.push_back({paths, error, relative_sigma * error});
  }
  return points;
}

TEST_CASE("the rate fit gives back the law that points without noise follow", "[sim][study]") {
  const double rate = GENERATE(0.5, 0.75, 1.0);
  const double bias = GENERATE(0.0, 0.02);
  CAPTURE(rate, bias);
  const RateFit fit = fit_rate(law(bias, rate, 0.01), RateBias::fitted);
  // The golden section ends at a width of 1e-13, where chi^2, a square, is flat to 1e-7.
  CHECK(fit.rate == Approx(rate).epsilon(1e-5));
  CHECK(fit.scale == Approx(0.7).epsilon(1e-4));
  CHECK(fit.bias == Approx(bias).epsilon(1e-4).margin(2e-5));
  CHECK(fit.error(16.0) == Approx(std::hypot(bias, 0.7 * std::pow(16.0, -rate))).epsilon(1e-4));
}

TEST_CASE("the rate's uncertainty is what repeated fits scatter by", "[sim][study]") {
  const double rate = 0.65, sigma = 0.05;
  Rng random{11};
  Welford fitted, stated;
  for (int trial = 0; trial < 200; ++trial) {
    auto points = law(0.01, rate, sigma);
    for (RatePoint& p : points) p.error *= 1.0 + sigma * support::SyntheticScene::normal(random);
    const RateFit fit = fit_rate(points, RateBias::fitted);
    fitted.add(fit.rate);
    stated.add(fit.rate_uncertainty);
  }
  // 200 trials: the mean to 5 of its standard errors, the scatter to 15 % (3 sigma); the stated
  // value is raised where chi^2 is above 1, in half of the trials, by some 20 %.
  CHECK(fitted.mean() == Approx(rate).margin(5.0 * fitted.estimate().standard_error));
  const double scatter = std::sqrt(fitted.variance());
  CHECK(stated.mean() > 0.85 * scatter);
  CHECK(stated.mean() < 1.5 * scatter);
}

TEST_CASE("a bias taken for none would lower the rate: the fit tells them apart", "[sim][study]") {
  const auto points = law(0.05, 0.5, 0.01);
  CHECK(fit_rate(points, RateBias::none).rate < 0.45);
  CHECK(fit_rate(points, RateBias::fitted).rate == Approx(0.5).epsilon(1e-4));
}

TEST_CASE("too few points leave the rate of independent paths, and say so", "[sim][study]") {
  const RateFit one = fit_rate({{4.0, 0.2, 0.01}}, RateBias::none);
  CHECK(one.rate == 0.5);
  CHECK(std::isinf(one.rate_uncertainty));
  CHECK(one.error(4.0) == Approx(0.2).epsilon(1e-12));
  CHECK(std::isinf(
      fit_rate({{1.0, 0.2, 0.01}, {4.0, 0.1, 0.01}}, RateBias::fitted).rate_uncertainty));
  CHECK(std::isinf(fit_rate({}, RateBias::none).rate_uncertainty));
}

TEST_CASE("errors of 0 do not break the fit", "[sim][study]") {
  const RateFit fit =
      fit_rate({{1.0, 0.0, 0.0}, {4.0, 0.0, 0.0}, {16.0, 0.0, 0.0}}, RateBias::fitted);
  CHECK(fit.scale == 0.0);
  CHECK(fit.bias == 0.0);
  CHECK(std::isinf(fit.rate_uncertainty));
}

TEST_CASE("the Pareto front is what no other point beats", "[sim][study]") {
  const double nan = std::nan("");
  const std::vector<CostPoint> points{{1.0, 0.5},   // on the front
                                      {2.0, 0.6},   // slower and worse than the first
                                      {2.0, 0.3},   // on the front
                                      {2.0, 0.4},   // as slow, worse
                                      {3.0, 0.3},   // slower, as good
                                      {4.0, 0.1},   // on the front
                                      {nan, 0.01},  // not known
                                      {0.5, nan}};
  CHECK(pareto_front(points) == std::vector<std::size_t>{0, 2, 5});
  CHECK(pareto_front({}).empty());
  CHECK(pareto_front({{1.0, 0.1}, {1.0, 0.1}}) == std::vector<std::size_t>{0});
}

}  // namespace
}  // namespace nadir::sim
