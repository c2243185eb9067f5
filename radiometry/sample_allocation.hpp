#pragma once

#include <cmath>

namespace nadir::radiometry {

/// Full samples that a hit of generation g starts: ceil(initial / decay^g).
[[nodiscard]] inline int full_sample_count(int initial, double decay_rate,
                                           int generation) noexcept {
  return static_cast<int>(std::ceil(initial / std::pow(decay_rate, generation)));
}

/// Deals out a number of samples over bins in proportion to their importance, rounding at random so
/// that the expected count of each bin is exact (systematic sampling: Madow, Ann. Math. Stat. 20,
/// 333, 1949). Bins are asked for in order.
class SystematicAllocation {
 public:
  /// @param total_importance  sum over all bins; 0 deals out nothing
  /// @param u                 uniform in [0, 1)
  SystematicAllocation(int samples, double total_importance, double u) noexcept
      : per_importance_{total_importance > 0.0 ? samples / total_importance : 0.0},
        position_{u},
        dealt_{std::floor(u)} {}

  struct Share {
    int count;        ///< samples that this bin gets this time
    double expected;  ///< their mean over u
  };
  [[nodiscard]] Share next(double importance) noexcept {
    const double expected = importance * per_importance_;
    position_ += expected;
    const double reached = std::floor(position_);
    const int count = static_cast<int>(reached - dealt_);
    dealt_ = reached;
    return {count, expected};
  }

 private:
  double per_importance_;
  double position_;
  double dealt_;
};

}  // namespace nadir::radiometry
