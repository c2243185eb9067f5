#include "spectral/gauss_rule.hpp"

#include <cassert>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>

namespace nadir::spectral {
namespace {

/// How many eigenvalues of the tridiagonal matrix lie below x: the negative pivots of its
/// elimination (Sylvester's law of inertia).
std::size_t eigenvalues_below(const Recurrence& r, double x) noexcept {
  constexpr double tiny = std::numeric_limits<double>::min();
  std::size_t below = 0;
  double pivot = 1.0;
  for (std::size_t k = 0; k < r.a.size(); ++k) {
    const double coupling = k == 0 ? 0.0 : r.b[k - 1] * r.b[k - 1];
    pivot = r.a[k] - x - coupling / pivot;
    if (std::abs(pivot) < tiny) pivot = -tiny;
    if (pivot < 0.0) ++below;
  }
  return below;
}

/// The eigenvalue with `index` others below it.
double eigenvalue(const Recurrence& r, std::size_t index, double lo, double hi) noexcept {
  constexpr int halvings = 58;  // 2^-58 of the interval is below the spacing of doubles at its ends
  for (int i = 0; i < halvings; ++i) {
    const double middle = std::midpoint(lo, hi);
    (eigenvalues_below(r, middle) > index ? hi : lo) = middle;
  }
  return std::midpoint(lo, hi);
}

/// Christoffel's number at x, 1 / sum p_k(x)^2: positive whatever the rounding.
double christoffel(const Recurrence& r, double x) noexcept {
  double previous = 0.0, p = 1.0, sum = 1.0;
  for (std::size_t k = 0; k + 1 < r.a.size(); ++k) {
    const double coupling = k == 0 ? 0.0 : r.b[k - 1];
    const double next = ((x - r.a[k]) * p - coupling * previous) / r.b[k];
    previous = p;
    p = next;
    sum += p * p;
  }
  return 1.0 / sum;
}

}  // namespace

Rule gauss_rule(const Recurrence& recurrence, double lo, double hi) {
  Rule rule;
  for (std::size_t i = 0; i < recurrence.a.size(); ++i) {
    rule.nodes.push_back(eigenvalue(recurrence, i, lo, hi));
    rule.weights.push_back(christoffel(recurrence, rule.nodes.back()));
  }
  return rule;
}

Rule gauss_legendre(int n) {
  assert(n >= 1);
  Recurrence legendre;
  for (int k = 0; k < n; ++k) legendre.a.push_back(0.0);
  for (int k = 1; k < n; ++k) legendre.b.push_back(k / std::sqrt(4.0 * k * k - 1.0));
  return gauss_rule(legendre, -1.0, 1.0);
}

Recurrence stieltjes(const Rule& measure, int n) {
  const std::size_t points = measure.nodes.size();
  assert(n >= 1 && static_cast<std::size_t>(n) <= points);
  const double mass = std::accumulate(measure.weights.begin(), measure.weights.end(), 0.0);
  std::vector<double> previous(points, 0.0), p(points, 1.0);
  Recurrence r;
  for (double b = 0.0;;) {
    double a = 0.0;
    for (std::size_t i = 0; i < points; ++i) {
      a += measure.weights[i] / mass * measure.nodes[i] * p[i] * p[i];
    }
    r.a.push_back(a);
    if (r.a.size() == static_cast<std::size_t>(n)) return r;

    double norm2 = 0.0;
    for (std::size_t i = 0; i < points; ++i) {
      const double next = (measure.nodes[i] - a) * p[i] - b * previous[i];
      previous[i] = p[i];
      p[i] = next;
      norm2 += measure.weights[i] / mass * next * next;
    }
    b = std::sqrt(norm2);
    r.b.push_back(b);
    for (double& value : p) value /= b;
  }
}

}  // namespace nadir::spectral
