#include "sim/products/percentile.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>

namespace nadir::sim {

double percentile(std::vector<float>& values, double fraction) {
  if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
  const double place = std::clamp(fraction, 0.0, 1.0) * static_cast<double>(values.size() - 1);
  const auto below = static_cast<std::ptrdiff_t>(place);
  const auto at = values.begin() + below;
  std::nth_element(values.begin(), at, values.end());
  const double share = place - static_cast<double>(below);
  if (share == 0.0) return *at;
  return (1.0 - share) * *at + share * *std::min_element(at + 1, values.end());
}

}  // namespace nadir::sim
