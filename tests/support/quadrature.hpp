#pragma once

#include <cmath>
#include <numbers>

#include "core/vec.hpp"

namespace nadir::support {

/// Integral over [lo, hi] by the double-exponential rule in long double: relative error about 1e-17
/// for an integrand that is analytic inside, whatever it does at the ends. Independent of every
/// quadrature under test. Split the interval at kinks.
/// Source: Takahasi & Mori, Publ. RIMS 9, 721 (1974).
///
/// @param f      long double -> long double
/// @param panels equal parts that the interval is cut into: for a narrow peak, or an integrand that
///               turns more than about ten times
template <class F>
[[nodiscard]] long double integrate(F&& f, long double lo, long double hi, int panels = 1) {
  constexpr long double half_pi = std::numbers::pi_v<long double> / 2.0L;
  constexpr long double step = 1.0L / 16.0L;  // halving it changes nothing above 1e-17
  constexpr int reach = 60;                   // at t = 3.75 the weights have fallen below 1e-26
  long double total = 0.0L;
  for (int panel = 0; panel < panels; ++panel) {
    const long double half = (hi - lo) / (2.0L * panels);
    const long double middle = lo + (2 * panel + 1) * half;
    for (int k = -reach; k <= reach; ++k) {
      const long double t = k * step;
      const long double u = half_pi * std::sinh(t);
      const long double weight = half_pi * std::cosh(t) / (std::cosh(u) * std::cosh(u));
      const long double x = middle + half * std::tanh(u);
      // Nodes that round to an end carry no weight, and the integrand may be infinite there.
      if (x <= middle - half || x >= middle + half) continue;
      total += weight * step * half * f(x);
    }
  }
  return total;
}

/// The direction with this cosine of the zenith angle and this azimuth (radians, from x to y).
[[nodiscard]] inline Vec3 direction(double mu, double azimuth_rad) {
  const double sine = std::sqrt(std::fmax(0.0, (1.0 - mu) * (1.0 + mu)));
  return {sine * std::cos(azimuth_rad), sine * std::sin(azimuth_rad), mu};
}

/// Integral of f(direction) over the solid angle of the upper hemisphere, by the midpoint rule in
/// the cosine (256 steps) and the azimuth (512). Relative error about 1e-5 for smooth integrands,
/// 1e-3 for one with a jump.
template <class F>
[[nodiscard]] double integrate_hemisphere(F&& f) {
  constexpr int rows = 256, columns = 512;
  double sum = 0.0;
  for (int i = 0; i < rows; ++i) {
    for (int j = 0; j < columns; ++j) {
      sum += f(direction((i + 0.5) / rows, 2.0 * std::numbers::pi * (j + 0.5) / columns));
    }
  }
  return sum * 2.0 * std::numbers::pi / (rows * columns);
}

}  // namespace nadir::support
