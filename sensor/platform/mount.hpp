#pragma once

#include <variant>

#include "core/transform.hpp"
#include "core/vec.hpp"

namespace nadir::sensor {

/// A mount that does not move.
struct FixedMount {};

/// A mirror or gimbal that swings about an axis of its own: from the first angle to the last at
/// constant rate, then at once back, again and again (`sweep`); or to and fro (`swing`).
/// Whiskbrooms use it for the scan; a period may hold a dead time after the sweep.
struct ScanMount {
  enum class Motion { sweep, swing };
  Motion motion = Motion::sweep;
  Vec3 axis{0.0, 1.0, 0.0};  ///< unit, in the mount's own axes
  double first_rad = 0.0, last_rad = 0.0;
  double start_s = 0.0;   ///< when a sweep begins at first_rad
  double sweep_s = 1.0;   ///< from first to last, > 0
  double period_s = 1.0;  ///< from sweep to sweep, >= sweep_s
};

/// Keeps one place of the scene in the middle, whatever the platform does.
struct StareMount {
  Vec3 target;  ///< scene axes
};

/// What turns what it carries against what carries it. A camera may stand on several, one upon the
/// other, the platform first.
struct Mount {
  Vec3 offset_m;  ///< in the carrier's axes
  Mat3 axes{};    ///< columns: own axes at rest, in the carrier's
  std::variant<FixedMount, ScanMount, StareMount> law = FixedMount{};
};

/// Angle of a scanning mount at a moment.
[[nodiscard]] double scan_angle(const ScanMount& scan, double time_s) noexcept;

}  // namespace nadir::sensor
