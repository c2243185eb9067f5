#include "atmosphere/transfer/ordinates.hpp"

#include <algorithm>
#include <cmath>

#include "spectral/gauss_rule.hpp"

namespace nadir::atmosphere {

Ordinates double_gauss(int streams) {
  const spectral::Rule rule = spectral::gauss_legendre(streams / 2);
  Ordinates ordinates{rule.nodes, rule.weights};
  for (double& mu : ordinates.mu) mu = 0.5 * (1.0 + mu);
  return ordinates;
}

LegendreTable::LegendreTable(int order, int degrees, const std::vector<double>& mu)
    : order_{order},
      count_{mu.size()},
      values_(static_cast<std::size_t>(std::max(0, degrees - order)) * mu.size()) {
  const double m = order;
  double start = 1.0;  // Lambda_m^m = sqrt((2m - 1)!! / (2m)!!) sin^m
  for (int i = 1; i <= order; ++i) start *= std::sqrt((2.0 * i - 1.0) / (2.0 * i));
  for (std::size_t i = 0; i < count_; ++i) {
    const double x = mu[i];
    const double sine = std::sqrt(std::max(0.0, (1.0 - x) * (1.0 + x)));
    double before = 0.0, now = start * std::pow(sine, order);
    for (int degree = order; degree < degrees; ++degree) {
      values_[static_cast<std::size_t>(degree - order) * count_ + i] = now;
      // sqrt((l+1)^2 - m^2) Lambda_(l+1) = (2l + 1) x Lambda_l - sqrt(l^2 - m^2) Lambda_(l-1)
      const double l = degree;
      const double next = ((2.0 * l + 1.0) * x * now - std::sqrt((l - m) * (l + m)) * before) /
                          std::sqrt((l + 1.0 - m) * (l + 1.0 + m));
      before = now;
      now = next;
    }
  }
}

}  // namespace nadir::atmosphere
