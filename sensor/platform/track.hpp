#pragma once

#include <cstddef>
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
/// (Lagrange; at the ends the outermost eight; fewer where there are fewer). Times are seconds
/// after the scenario's. Where a new polynomial takes over, at a moment of the table, the velocity
/// may jump.
class Track {
 public:
  /// One that stands still, for all times.
  explicit Track(Vec3 position);
  /// @param times_s    strictly ascending, at least two
  /// @param positions  scene axes, m, one a time
  /// @param points     of the polynomial: 8, or 2 for straight pieces between way points; 2 to 8
  /// @throws InputError for sizes that differ, times that do not ascend, values that are not finite
  Track(std::vector<double> times_s, std::vector<Vec3> positions, int points = 8);

  /// @param time_s  within [first_s, last_s]; beyond it by rounding only
  [[nodiscard]] TrackState at(double time_s) const noexcept;
  /// The same, by the polynomial that ends at a moment of the table and not by the one that begins.
  [[nodiscard]] TrackState before(double time_s) const noexcept;
  /// The position alone, faster.
  [[nodiscard]] Vec3 position(double time_s) const noexcept;

  [[nodiscard]] bool is_fixed() const noexcept { return times_s_.size() == 1; }
  [[nodiscard]] double first_s() const noexcept;  ///< -infinity where it stands still
  [[nodiscard]] double last_s() const noexcept;   ///< infinity where it stands still
  /// The moments of the table; one where it stands still.
  [[nodiscard]] const std::vector<double>& times_s() const noexcept { return times_s_; }

 private:
  struct Window;
  [[nodiscard]] std::size_t interval(double time_s) const noexcept;
  [[nodiscard]] std::size_t exact_interval(double time_s) const noexcept;
  [[nodiscard]] Window window(double time_s, std::size_t interval) const noexcept;
  [[nodiscard]] TrackState state(double time_s, std::size_t interval) const noexcept;
  void find_step();
  void prepare_weights();

  std::vector<double> times_s_;
  std::vector<Vec3> positions_;
  int points_ = 8;
  double step_s_ = 0.0;  // where the times are evenly spaced; else 0
  // 1 / product of (t_j - t_i), i != j, for each window's points; one window where all are alike.
  std::vector<double> weights_;
};

}  // namespace nadir::sensor
