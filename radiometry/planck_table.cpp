#include "radiometry/planck_table.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "core/constants.hpp"
#include "spectral/planck.hpp"

namespace nadir::radiometry {
namespace {

// With x = c2 / (lambda T) the radiance is as 1 / (exp(x) - 1): float has nothing left at x = 115,
// and nothing that counts at 105.
constexpr double dark = 115.0, knee = 105.0;

// A cubic between nodes h apart in x errs by 0.0234 h^4 of the fourth derivative: 4e-5 of exp(-x)
// for h = 0.2, 6e-5 of 1 / x for h = x / 10. So nodes stand at the integers of n with dn / dx = 5 +
// 10 / x, and as in the knee beyond it, where only longer wavelengths are left.
constexpr double per_x = 5.0, per_log_x = 10.0;
constexpr double beyond = per_x * knee + per_log_x;

double number_of(double x) {
  if (x < knee) return per_x * x + per_log_x * std::log(x);
  return per_x * knee + per_log_x * std::log(knee) + beyond * std::log(x / knee);
}

double x_of(double number) {
  const double at_knee = per_x * knee + per_log_x * std::log(knee);
  if (number >= at_knee) return knee * std::exp((number - at_knee) / beyond);
  // Newton in y = ln x, where the function rises ever more steeply: it converges from above.
  double y = std::log(knee);
  for (int i = 0; i < 200; ++i) {
    const double x = std::exp(y);
    const double step = (per_x * x + per_log_x * y - number) / (per_x * x + per_log_x);
    y -= step;
    if (std::abs(step) < 1e-15 * std::max(1.0, std::abs(y))) break;
  }
  return std::exp(y);
}

}  // namespace

PlanckTable::PlanckTable(const spectral::Lanes& lanes, const Reach& reach)
    : lanes_{lanes.count()}, shortest_k_{si::radiation_c2 / lanes[0].value} {
  const double black_k = si::radiation_c2 / (dark * lanes[lanes_ - 1].value);
  least_k_ = std::max(reach.coldest.value, black_k);
  first_ = number_of(shortest_k_ / std::max(reach.hottest.value, least_k_));
  const double span = number_of(shortest_k_ / least_k_) - first_;
  nodes_ = std::max(1, static_cast<int>(std::ceil(span))) + 3;  // one more at either end
  for (int node = 0; node < nodes_; ++node) {
    const Kelvin temperature{shortest_k_ / x_of(first_ + (node - 1))};
    const auto radiance = spectral::planck(lanes, temperature);
    for (int lane = 0; lane < lanes_; ++lane) value_.push_back(radiance[lane]);
  }
}

spectral::Spectrum PlanckTable::at(double temperature_k) const noexcept {
  spectral::Spectrum b{lanes_};
  if (!(temperature_k >= least_k_)) return b;
  const double from_first = std::max(0.0, number_of(shortest_k_ / temperature_k) - first_);
  const int node = std::min(static_cast<int>(from_first), nodes_ - 4);
  const auto u = static_cast<float>(from_first - node);
  // Lagrange's weights for nodes at -1, 0, 1, 2.
  const float before = -u * (u - 1.0F) * (u - 2.0F) / 6.0F;
  const float first = (u + 1.0F) * (u - 1.0F) * (u - 2.0F) / 2.0F;
  const float second = -(u + 1.0F) * u * (u - 2.0F) / 2.0F;
  const float after = (u + 1.0F) * u * (u - 1.0F) / 6.0F;
  const float* const row = value_.data() + static_cast<std::ptrdiff_t>(node) * lanes_;
  for (int lane = 0; lane < lanes_; ++lane) {
    const float value = before * row[lane] + first * row[lane + lanes_] +
                        second * row[lane + 2 * lanes_] + after * row[lane + 3 * lanes_];
    b[lane] = std::max(value, 0.0F);
  }
  return b;
}

}  // namespace nadir::radiometry
