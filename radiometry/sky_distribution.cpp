#include "radiometry/sky_distribution.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace nadir::radiometry {
namespace {

// Fine enough for the brightening towards horizon or sun; 2048 cells stay in the first cache.
constexpr int rows = 32, columns = 64;
constexpr double cells = rows * columns;
// A share of the draws goes everywhere, so that what lies between the cells' centres is reached.
constexpr double even_share = 0.05;

Vec3 direction_at(double row, double column) {
  const double mu = 1.0 - 2.0 * row / rows;
  const double phi = 2.0 * std::numbers::pi * column / columns;
  const double sine = std::sqrt(std::max(0.0, 1.0 - mu * mu));
  return {sine * std::cos(phi), sine * std::sin(phi), mu};
}

}  // namespace

SkyDistribution::SkyDistribution(const atmosphere::BoundAtmosphere& air) {
  if (air.even_sky()) return;
  std::vector<double> radiance;
  double total = 0.0;
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      radiance.push_back(
          static_cast<double>(air.sky(direction_at(row + 0.5, column + 0.5)).mean()));
      total += radiance.back();
    }
  }
  if (!(total > 0.0)) return;
  const double contrast = *std::max_element(radiance.begin(), radiance.end()) * cells / total;
  share_ = std::min(0.5, (contrast - 1.0) / (contrast + 3.0));
  double sum = 0.0;
  for (const double value : radiance) {
    sum += even_share / cells + (1.0 - even_share) * value / total;
    cumulative_.push_back(sum);
  }
  cumulative_.back() = 1.0;
}

Vec3 SkyDistribution::sample(Vec2 u) const noexcept {
  const auto found = std::upper_bound(cumulative_.begin(), cumulative_.end() - 1, u.x);
  const auto cell = static_cast<int>(found - cumulative_.begin());
  const double before = cell > 0 ? cumulative_[static_cast<std::size_t>(cell) - 1] : 0.0;
  const double inside = (u.x - before) / (*found - before);  // u.x is used twice: cell, row in it
  const int row = cell / columns;
  return direction_at(row + inside, cell % columns + u.y);
}

double SkyDistribution::pdf(Vec3 direction) const noexcept {
  const double turn = std::atan2(direction.y, direction.x) / (2.0 * std::numbers::pi);
  const int row = std::clamp(static_cast<int>((1.0 - direction.z) * 0.5 * rows), 0, rows - 1);
  const int column =
      std::clamp(static_cast<int>((turn < 0.0 ? turn + 1.0 : turn) * columns), 0, columns - 1);
  const auto cell = static_cast<std::size_t>(row) * columns + static_cast<std::size_t>(column);
  const double share = cumulative_[cell] - (cell > 0 ? cumulative_[cell - 1] : 0.0);
  return share * cells / (4.0 * std::numbers::pi);
}

}  // namespace nadir::radiometry
