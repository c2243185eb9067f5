#pragma once

#include <vector>

#include "core/quaternion.hpp"
#include "geometry/earth.hpp"
#include "sensor/platform/attitude.hpp"
#include "sensor/platform/attitude_table.hpp"
#include "sensor/platform/jitter.hpp"
#include "sensor/platform/mount.hpp"
#include "sensor/platform/pose.hpp"
#include "sensor/platform/track.hpp"

namespace nadir::sensor {

/// How a camera moves, as it is described.
struct PlatformDescription {
  Track track{Vec3{}};
  Attitude attitude;
  std::vector<Mount> mounts;  ///< from the platform outwards to the camera
  JitterDescription jitter;
};

/// Where the camera is and how it is turned at any moment of a span, ready to be asked for every
/// ray: laws are tabulated so finely that turning evenly (slerp) between the steps is within
/// 1e-9 rad of the law (AttitudeTable says how, and at how many steps it gives up); places are the
/// track's own. Swinging mounts are evaluated as they are.
class Platform {
 public:
  /// One that stands still, for all times.
  explicit Platform(const Pose& fixed = {});
  /// @param first_s, last_s  the span in which it will be asked, s after the scenario's time
  /// @throws InputError where the track or a table of attitudes does not cover the span, a law
  /// means
  ///         nothing there, a mount or the jitter is none
  Platform(const PlatformDescription& description, const geometry::LocalFrame& frame,
           double first_s, double last_s);

  /// The camera's pose, with the shaking that has memory. @param time_s  within the span
  [[nodiscard]] Pose at(double time_s) const noexcept;
  /// The same shaken by the jitter without memory. @param normal  three standard normal numbers
  [[nodiscard]] Pose shaken(double time_s, Vec3 normal) const noexcept;
  /// As described, without any shaking: what a ground segment would know.
  [[nodiscard]] Pose steady(double time_s) const noexcept;

  /// Neither moves nor turns nor shakes: one pose for all times.
  [[nodiscard]] bool is_fixed() const noexcept { return fixed_; }
  [[nodiscard]] bool has_white_jitter() const noexcept { return jitter_.is_white(); }
  [[nodiscard]] double first_s() const noexcept { return first_s_; }
  [[nodiscard]] double last_s() const noexcept { return last_s_; }
  [[nodiscard]] const Jitter& jitter() const noexcept { return jitter_; }

 private:
  void take_static_mounts(const std::vector<Mount>& mounts);
  void tabulate(const PlatformDescription& description, const geometry::LocalFrame& frame);

  bool fixed_ = true;  // one pose for all times
  bool still_ = true;  // the same but for swinging mounts and shaking: the table is not needed
  Pose pose_;          // where it stands still
  double first_s_ = 0.0, last_s_ = 0.0;
  Track track_{Vec3{}};
  AttitudeTable turning_;  // the platform's axes, turned on by the mounts that do not move
  Vec3 lever_m_;           // what those add to the place, in these axes
  std::vector<Mount> swinging_;
  Jitter jitter_;
};

}  // namespace nadir::sensor
