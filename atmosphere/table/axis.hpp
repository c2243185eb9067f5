#pragma once
// Private to this folder: where between the nodes of an axis a value lies.

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace nadir::atmosphere {

/// Two neighbouring nodes and the share of the upper one.
struct Between {
  std::size_t lower = 0, upper = 0;
  float weight = 0.0F;
};

/// Nodes within [0, 1], ascending; outside them the nearest. Bins lead to the nodes at once, unless
/// many crowd into one bin.
class Axis {
 public:
  Axis() = default;
  /// @param first  index of the first node in the table
  Axis(std::vector<double> nodes, std::size_t first) : nodes_{std::move(nodes)}, first_{first} {
    for (std::size_t bin = 0; bin < bins; ++bin) {
      const double edge = static_cast<double>(bin) / static_cast<double>(bins);
      std::size_t i = 0;
      while (i + 2 < nodes_.size() && nodes_[i + 1] <= edge) ++i;
      start_[bin] = i;
    }
  }
  [[nodiscard]] bool empty() const noexcept { return nodes_.empty(); }
  [[nodiscard]] Between find(double x) const noexcept {
    if (nodes_.size() == 1 || !(x > nodes_.front())) return {first_, first_, 0.0F};
    if (x >= nodes_.back()) {
      const std::size_t last = first_ + nodes_.size() - 1;
      return {last, last, 0.0F};
    }
    std::size_t i = start_[static_cast<std::size_t>(x * static_cast<double>(bins))];
    while (nodes_[i + 1] < x) ++i;
    const double weight = (x - nodes_[i]) / (nodes_[i + 1] - nodes_[i]);
    return {first_ + i, first_ + i + 1, static_cast<float>(weight)};
  }

 private:
  static constexpr std::size_t bins = 256;
  std::vector<double> nodes_;
  std::size_t first_ = 0;
  std::array<std::size_t, bins> start_{};
};

}  // namespace nadir::atmosphere
