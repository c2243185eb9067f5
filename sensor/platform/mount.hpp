#pragma once

#include <variant>

#include "core/transform.hpp"
#include "core/vec.hpp"
#include "sensor/platform/pose.hpp"

namespace nadir::sensor {

/// A mount that does not move.
struct FixedMount {};

/// A mirror or gimbal that swings about an axis of its own at constant rate: from the first angle
/// to the last, then at once back to wait at the first for the next period (`sweep`); or to and
/// fro, one way in each period, waiting where it has come to (`swing`). So for ever, before
/// `start_s` too. Whiskbrooms use it for the scan.
struct ScanMount {
  enum class Motion { sweep, swing };
  Motion motion = Motion::sweep;
  Vec3 axis{0.0, 1.0, 0.0};  ///< unit, in the mount's own axes; turns are right-handed about it
  double first_rad = 0.0, last_rad = 0.0;
  double start_s = 0.0;   ///< when a sweep begins at first_rad
  double sweep_s = 1.0;   ///< from first to last, > 0
  double period_s = 1.0;  ///< from sweep to sweep, >= sweep_s: the rest is dead time
};

/// Keeps one place of the scene in the middle, whatever the platform does: z points at it, x stays
/// as near to x at rest as that allows.
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

/// Pose of what a mount carries: at the carrier's place moved by the offset, turned by the carrier,
/// by the mount's axes and by its law. A stare whose target is at the mount itself stays at rest.
[[nodiscard]] Pose carried(const Pose& carrier, const Mount& mount, double time_s) noexcept;

/// @throws InputError for axes that are no rotation (within 1e-6), values that are not finite,
///         times of a scan that are not positive or too short for its sweep
void check(const Mount& mount);

}  // namespace nadir::sensor
