#include "atmosphere/paths/path_measure.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "atmosphere/paths/spherical_path.hpp"

namespace nadir::atmosphere {
namespace {

/// exp(x^2) erfc(x), x >= 0. From 10 on the asymptotic series, whose first term left out is 1e-15
/// there (Abramowitz & Stegun 7.1.23).
double scaled_erfc(double x) noexcept {
  if (x < 10.0) return std::exp(x * x) * std::erfc(x);
  const double step = 0.5 / (x * x);
  double sum = 1.0;
  for (int odd = 21; odd > 0; odd -= 2) sum = 1.0 - odd * step * sum;
  return sum / (x * std::sqrt(std::numbers::pi));
}

constexpr int powers = 4, terms = 9;

/// i_k(x) / x^k = sum over j of (x^2 / 2)^j / (j! (2 k + 2 j + 1)!!), Abramowitz & Stegun 10.2.5.
constexpr std::array<std::array<double, terms>, powers> bessel_series() {
  std::array<std::array<double, terms>, powers> series{};
  double first = 1.0;
  for (int k = 0; k < powers; ++k) {
    first /= 2 * k + 1;
    double term = first;
    for (int j = 0; j < terms; ++j) {
      if (j > 0) term /= j * (2 * (k + j) + 1);
      series[static_cast<std::size_t>(k)][static_cast<std::size_t>(j)] = term;
    }
  }
  return series;
}

/// In scale heights: of the lower end, and from there to the upper.
struct Fall {
  double base, drop;
};

/// int_0^1 exp(-base - drop t + sag t (1 - t)) dt for a small sag, by powers of it: each is a
/// modified spherical Bessel function, int_-1^1 exp(x v) (1 - v^2)^k dv = 2^(k+1) k! i_k(x) / x^k
/// (Abramowitz & Stegun 10.2.13), here with x = drop / 2.
double mean_by_powers(Fall fall, double sag) noexcept {
  static constexpr auto series = bessel_series();
  const auto [base, drop] = fall;
  const double x = 0.5 * drop, half = 0.5 * sag;
  if (x < 1.0) {
    const double y = 0.5 * x * x;
    double sum = 0.0;
    for (std::size_t k = powers; k-- > 0;) {
      double i = 0.0;
      for (std::size_t j = terms; j-- > 0;) i = series[k][j] + y * i;
      sum = i + half * sum;
    }
    return sum * std::exp(-base - x);
  }
  // i_k(x) / x^k with exp(-x) taken in, so that nothing overflows
  const double down = std::exp(-drop), square = x * x;
  const double i0 = 0.5 * (1.0 - down) / x;
  const double i1 = (0.5 * (1.0 + down) - i0) / square;
  const double i2 = (i0 - 3.0 * i1) / square;
  const double i3 = (i1 - 5.0 * i2) / square;
  return std::exp(-base) * (i0 + half * (i1 + half * (i2 + half * i3)));
}

/// Of s^2 in w / H, m^-2.
constexpr double c = 0.5 / (earth_radius_m * measure_scale_m);

/// int_0^length exp(-(b s + c s^2)) ds with b >= 0; drop = b length + c length^2.
double rising(double b, double drop) noexcept {
  const double root = std::sqrt(c), x1 = 0.5 * b / root;
  const double x2 = std::sqrt(x1 * x1 + drop);  // rises with the way: nothing cancels
  const double far = drop < 700.0 ? std::exp(-drop) * scaled_erfc(x2) : 0.0;
  return 0.5 * std::sqrt(std::numbers::pi) / root * (scaled_erfc(x1) - far);
}

}  // namespace

double air_measure_m(double height_from_m, double height_to_m, double length_m) noexcept {
  if (!(length_m > 0.0)) return 0.0;
  // From the lower end up.
  const double lower_m = std::min(height_from_m, height_to_m);
  const double upper_m = std::max(height_from_m, height_to_m);
  const auto scaled = [](double z) {
    return z * (1.0 + z / (2.0 * earth_radius_m)) / measure_scale_m;
  };
  const double at_lower = scaled(lower_m);
  const double drop =
      (upper_m - lower_m) * (1.0 + (upper_m + lower_m) / (2.0 * earth_radius_m)) / measure_scale_m;
  const double sag = c * length_m * length_m;
  // Below, the sum of powers is good to sag^4 / 4^4 / 4! = 2e-12.
  if (sag < 0.01) return length_m * mean_by_powers({at_lower, drop}, sag);
  const double b = (drop - sag) / length_m;
  if (b >= 0.0) return std::exp(-at_lower) * rising(b, drop);
  // The lowest point lies between: both ends rise from it.
  const double way = -0.5 * b / c, rest = length_m - way;
  const double root = std::sqrt(c);
  return std::exp(c * way * way - at_lower) * 0.5 * std::sqrt(std::numbers::pi) / root *
         (std::erf(root * way) + std::erf(root * rest));
}

}  // namespace nadir::atmosphere
