#include "sim/study/rate_fit.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <set>

namespace nadir::sim {
namespace {

constexpr double least_rate = 0.1, greatest_rate = 1.6;

/// Weighted sums of the law error^2 = B + C x, x = paths^-2p.
struct LinearLaw {
  double b2 = 0.0, c2 = 0.0, chi2 = 0.0;
};

struct Weighted {
  double x, y, weight;
};

std::vector<Weighted> weighted(const std::vector<RatePoint>& points, double rate) {
  std::vector<Weighted> all;
  for (const RatePoint& point : points) {
    // d(error^2) = 2 error d(error); an error of 0 keeps the weight of its uncertainty alone.
    const double sigma =
        2.0 * std::max(point.error, point.uncertainty) * std::max(point.uncertainty, 1e-300);
    all.push_back(
        {std::pow(point.paths, -2.0 * rate), point.error * point.error, 1.0 / (sigma * sigma)});
  }
  return all;
}

double chi2_of(const std::vector<Weighted>& points, double b2, double c2) {
  double sum = 0.0;
  for (const Weighted& p : points) {
    const double off = p.y - b2 - c2 * p.x;
    sum += p.weight * off * off;
  }
  return sum;
}

/// The best B >= 0 and C >= 0 for one rate.
LinearLaw solve_law(const std::vector<RatePoint>& points, double rate, RateBias bias) {
  const auto all = weighted(points, rate);
  double s = 0.0, sx = 0.0, sy = 0.0, sxx = 0.0, sxy = 0.0;
  for (const Weighted& p : all) {
    s += p.weight;
    sx += p.weight * p.x;
    sy += p.weight * p.y;
    sxx += p.weight * p.x * p.x;
    sxy += p.weight * p.x * p.y;
  }
  LinearLaw law{0.0, sxx > 0.0 ? std::max(0.0, sxy / sxx) : 0.0, 0.0};
  law.chi2 = chi2_of(all, law.b2, law.c2);
  if (bias == RateBias::none) return law;
  const double determinant = s * sxx - sx * sx;
  if (determinant > 1e-12 * s * sxx) {
    const double b2 = (sxx * sy - sx * sxy) / determinant;
    const double c2 = (s * sxy - sx * sy) / determinant;
    if (b2 > 0.0 && c2 >= 0.0) return {b2, c2, chi2_of(all, b2, c2)};
  }
  const double flat = s > 0.0 ? std::max(0.0, sy / s) : 0.0;
  const double flat_chi2 = chi2_of(all, flat, 0.0);
  return flat_chi2 < law.chi2 ? LinearLaw{flat, 0.0, flat_chi2} : law;
}

/// The rate between two bounds at which chi^2 is least.
double best_rate(const std::vector<RatePoint>& points, RateBias bias) {
  const auto chi2 = [&](double rate) { return solve_law(points, rate, bias).chi2; };
  // A coarse search first: chi^2 may have a second, shallow minimum at the bounds.
  constexpr int steps = 30;
  constexpr double step = (greatest_rate - least_rate) / steps;
  double best = least_rate;
  for (int i = 1; i <= steps; ++i) {
    const double rate = least_rate + i * step;
    if (chi2(rate) < chi2(best)) best = rate;
  }
  double lo = std::max(least_rate, best - step), hi = std::min(greatest_rate, best + step);
  constexpr double golden = 0.6180339887498949;  // (sqrt(5) - 1) / 2
  for (int i = 0; i < 60; ++i) {
    const double width = golden * (hi - lo);
    if (chi2(hi - width) < chi2(lo + width)) {
      hi = lo + width;
    } else {
      lo = hi - width;
    }
  }
  return 0.5 * (lo + hi);
}

std::size_t numbers_of_paths(const std::vector<RatePoint>& points) {
  std::set<double> different;
  for (const RatePoint& point : points) different.insert(point.paths);
  return different.size();
}

}  // namespace

double RateFit::error(double paths) const noexcept {
  return std::hypot(bias, scale * std::pow(paths, -rate));
}

RateFit fit_rate(const std::vector<RatePoint>& points, RateBias bias) {
  const std::size_t parameters = bias == RateBias::fitted ? 3 : 2;
  RateFit fit;
  fit.rate_uncertainty = std::numeric_limits<double>::infinity();
  if (numbers_of_paths(points) < parameters) {
    const LinearLaw law = solve_law(points, fit.rate, RateBias::none);
    fit.scale = std::sqrt(law.c2);
    return fit;
  }
  fit.rate = best_rate(points, bias);
  const LinearLaw law = solve_law(points, fit.rate, bias);
  fit.bias = std::sqrt(law.b2);
  fit.scale = std::sqrt(law.c2);
  if (points.size() > parameters) {
    fit.reduced_chi2 = law.chi2 / static_cast<double>(points.size() - parameters);
  }
  // chi^2 = chi^2_min + (dp / sigma)^2, the other parameters free.
  constexpr double d = 0.01;
  const double curvature = (solve_law(points, fit.rate + d, bias).chi2 +
                            solve_law(points, fit.rate - d, bias).chi2 - 2.0 * law.chi2) /
                           (d * d);
  if (curvature > 0.0 && law.c2 > 0.0) {
    fit.rate_uncertainty = std::sqrt(2.0 / curvature) * std::sqrt(std::max(1.0, fit.reduced_chi2));
  }
  return fit;
}

}  // namespace nadir::sim
