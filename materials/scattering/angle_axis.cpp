#include "materials/scattering/angle_axis.hpp"

#include <algorithm>
#include <utility>

namespace nadir::materials {
namespace {

constexpr std::size_t bin_count = 128;

}  // namespace

AngleAxis::AngleAxis(std::vector<double> nodes, Ends ends)
    : nodes_{std::move(nodes)},
      ends_{ends},
      bins_per_angle_{bin_count / (nodes_.back() - nodes_.front())} {
  std::size_t interval = 0;
  for (std::size_t bin = 0; bin < bin_count; ++bin) {
    const double begin = nodes_.front() + static_cast<double>(bin) / bins_per_angle_;
    while (interval + 2 < nodes_.size() && nodes_[interval + 1] <= begin) ++interval;
    start_.push_back(interval);
  }
}

AxisTaps AngleAxis::at(double angle) const noexcept {
  const std::size_t last = nodes_.size() - 1;
  if (!(angle > nodes_.front())) return {{0, 0, 0, 0}, {0.0F, 1.0F, 0.0F, 0.0F}};
  if (angle >= nodes_.back()) return {{last, last, last, last}, {0.0F, 1.0F, 0.0F, 0.0F}};
  const auto bin = static_cast<std::size_t>((angle - nodes_.front()) * bins_per_angle_);
  std::size_t i = start_[std::min(bin, bin_count - 1)];
  while (i > 0 && nodes_[i] > angle) --i;  // a rounding below the bin's start
  while (nodes_[i + 1] <= angle) ++i;

  const double h = nodes_[i + 1] - nodes_[i], t = (angle - nodes_[i]) / h, s = 1.0 - t;
  double lower = (1.0 + 2.0 * t) * s * s, upper = t * t * (1.0 + 2.0 * s);
  const double slope_lower = t * s * s * h, slope_upper = -t * t * s * h;
  double before = 0.0, after = 0.0;
  // slope at the lower node: (y[i+1] - y[i-1]) / (x[i+1] - x[i-1])
  if (i > 0) {
    const double part = slope_lower / (nodes_[i + 1] - nodes_[i - 1]);
    upper += part;
    before -= part;
  } else if (ends_ == Ends::chord) {
    upper += slope_lower / h;
    lower -= slope_lower / h;
  }
  if (i + 1 < last) {
    const double part = slope_upper / (nodes_[i + 2] - nodes_[i]);
    after += part;
    lower -= part;
  } else if (ends_ == Ends::chord) {
    upper += slope_upper / h;
    lower -= slope_upper / h;
  }
  return {{i > 0 ? i - 1 : 0, i, i + 1, std::min(i + 2, last)},
          {static_cast<float>(before), static_cast<float>(lower), static_cast<float>(upper),
           static_cast<float>(after)}};
}

}  // namespace nadir::materials
