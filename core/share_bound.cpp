#include "core/share_bound.hpp"

#include <cmath>
#include <limits>

namespace nadir {
namespace {

/// ln of the probability of at most `hits` hits, each with the probability p in (hits/trials, 1):
/// there the terms fall from the last one down, so that the sum may end where they no longer count.
double log_probability_of_at_most(double hits, double trials, double p) {
  const double log_last = std::lgamma(trials + 1.0) - std::lgamma(hits + 1.0) -
                          std::lgamma(trials - hits + 1.0) + hits * std::log(p) +
                          (trials - hits) * std::log1p(-p);
  const double odds = (1.0 - p) / p;
  double term = 1.0, sum = 1.0;  // in units of the last term
  for (double i = hits; i > 0.0 && term > 1e-17 * sum; i -= 1.0) {
    term *= odds * i / (trials - i + 1.0);
    sum += term;
  }
  return log_last + std::log(sum);
}

}  // namespace

double share_upper_bound(std::uint64_t hits, std::uint64_t trials, double level) {
  if (!(level > 0.0 && level < 1.0)) return std::numeric_limits<double>::quiet_NaN();
  if (hits >= trials) return 1.0;
  const double n = static_cast<double>(trials), k = static_cast<double>(hits);
  const double log_rest = std::log1p(-level);
  if (hits == 0) return -std::expm1(log_rest / n);
  // The probability falls with p. At p = hits / trials it is 1/2 or so or more, below which levels
  // under one half lie: the bracket begins lower than that for them.
  double lo = level < 0.5 ? 0.0 : k / n, hi = 1.0;
  while (hi - lo > 1e-13 * hi) {
    const double middle = 0.5 * (lo + hi);
    if (middle <= lo || middle >= hi) break;  // neighbouring numbers
    (log_probability_of_at_most(k, n, middle) > log_rest ? lo : hi) = middle;
  }
  return 0.5 * (lo + hi);
}

}  // namespace nadir
