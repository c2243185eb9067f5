#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace nadir::atmosphere {

/// Where and how much to read of values that are given at the directions of a DirectionGrid.
struct MuWeights {
  std::size_t first = 0;
  std::array<double, 4> weight{};
};

/// Directions at which the source of scattered light is asked for: cosines of evenly spaced zenith
/// angles, horizon and both verticals included. A source of n streams is a trigonometric polynomial
/// of degree n - 1 in the zenith angle, so that cubic interpolation between them converges fast.
class DirectionGrid {
 public:
  explicit DirectionGrid(int streams);

  [[nodiscard]] const std::vector<double>& mu() const noexcept { return mu_; }  ///< ascending
  /// Cubic (four-point Lagrange) interpolation in the angle.
  [[nodiscard]] MuWeights at(double mu) const noexcept;

 private:
  std::vector<double> mu_;
};

}  // namespace nadir::atmosphere
