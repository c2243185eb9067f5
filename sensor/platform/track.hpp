#pragma once

#include <vector>

#include "core/vec.hpp"

namespace nadir::sensor {

/// Where a platform is and how fast it moves over the earth, in scene axes (they turn with the
/// earth), m and m/s.
struct TrackState {
  Vec3 position;
  Vec3 velocity;
};

/// A platform's way: places at moments, and between them the polynomial through the eight nearest
/// (Lagrange; fewer where there are fewer). Times are seconds after the scenario's.
class Track {
 public:
  /// One that stands still, for all times.
  explicit Track(Vec3 position);
  /// @param times_s    strictly ascending, at least two
  /// @param positions  scene axes, m, one a time
  /// @param points     of the polynomial: 8, or 2 for straight pieces between way points
  /// @throws InputError for sizes that differ, times that do not ascend, values that are not finite
  Track(std::vector<double> times_s, std::vector<Vec3> positions, int points = 8);

  /// @param time_s  within [first_s, last_s]; beyond it by rounding only
  [[nodiscard]] TrackState at(double time_s) const noexcept;
  [[nodiscard]] bool is_fixed() const noexcept { return times_s_.size() == 1; }
  [[nodiscard]] double first_s() const noexcept;  ///< -infinity where it stands still
  [[nodiscard]] double last_s() const noexcept;   ///< infinity where it stands still

 private:
  std::vector<double> times_s_;
  std::vector<Vec3> positions_;
  int points_ = 8;
  double step_s_ = 0.0;  // where the times are evenly spaced; else 0
};

}  // namespace nadir::sensor
