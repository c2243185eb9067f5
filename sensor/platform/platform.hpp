#pragma once

#include <optional>
#include <vector>

#include "core/quaternion.hpp"
#include "geometry/earth.hpp"
#include "sensor/platform/attitude.hpp"
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
/// 1e-9 rad of the law, and places within a micrometre (Lagrange, 8 points). Swinging mounts are
/// evaluated as they are.
class Platform {
 public:
  /// One that stands still.
  explicit Platform(const Pose& fixed = {});
  /// @param first_s, last_s  the span in which it will be asked, s after the scenario's time
  /// @throws InputError where the track or a table of attitudes does not cover the span
  Platform(const PlatformDescription& description, const geometry::LocalFrame& frame,
           double first_s, double last_s);

  /// The camera's pose, with the shaking that has memory. @param time_s  within the span
  [[nodiscard]] Pose at(double time_s) const noexcept;
  /// The same shaken by the jitter without memory. @param normal  three standard normal numbers
  [[nodiscard]] Pose shaken(double time_s, Vec3 normal) const noexcept;
  /// As described, without any shaking: what a ground segment would know.
  [[nodiscard]] Pose steady(double time_s) const noexcept;

  [[nodiscard]] bool is_fixed() const noexcept { return fixed_; }
  [[nodiscard]] bool has_white_jitter() const noexcept { return white_; }
  [[nodiscard]] double first_s() const noexcept { return first_s_; }
  [[nodiscard]] double last_s() const noexcept { return last_s_; }
  [[nodiscard]] const Jitter& jitter() const noexcept { return jitter_; }

 private:
  bool fixed_ = true, white_ = false;
  Pose pose_;  // where it stands still
  double first_s_ = 0.0, last_s_ = 0.0;
  std::optional<Track> track_;
  std::vector<double> times_s_;
  std::vector<Quaternion> orientations_;
  std::vector<Mount> swinging_;
  Jitter jitter_;
};

}  // namespace nadir::sensor
