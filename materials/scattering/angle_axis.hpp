#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace nadir::materials {

/// Which nodes of a table take part in an interpolated value, and with what weight.
struct AxisTaps {
  std::array<std::size_t, 4> node{};
  std::array<float, 4> weight{};  ///< sum 1; 0 for nodes that do not take part
};

/// Nodes along one angle, and smooth interpolation between them: a cubic Hermite spline whose slope
/// at a node is that of the chord between its neighbours (Catmull-Rom, uneven steps). Continuous
/// with its first derivative, exact for straight lines; beyond the ends the last value is held.
class AngleAxis {
 public:
  /// Slope at the ends: flat where the function is even about both (azimuth), else that of the
  /// chord.
  enum class Ends { chord, flat };
  AngleAxis() = default;
  /// @param nodes  strictly ascending, at least two
  AngleAxis(std::vector<double> nodes, Ends ends);

  [[nodiscard]] AxisTaps at(double angle) const noexcept;
  [[nodiscard]] std::size_t size() const noexcept { return nodes_.size(); }
  [[nodiscard]] double operator[](std::size_t i) const { return nodes_[i]; }
  [[nodiscard]] double back() const { return nodes_.back(); }

 private:
  std::vector<double> nodes_;
  Ends ends_ = Ends::chord;
  std::vector<std::size_t> start_;  // per bin of equal width: interval that holds the bin's start
  double bins_per_angle_ = 0.0;
};

}  // namespace nadir::materials
