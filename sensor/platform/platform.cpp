#include "sensor/platform/platform.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <variant>

#include "core/error.hpp"
#include "core/text.hpp"

namespace nadir::sensor {
namespace {

struct PlatformSpan {
  double first_s, last_s;
};

void check_cover(const std::string& what, PlatformSpan has, PlatformSpan needed) {
  // A nanosecond: times of lines are sums, and rounded.
  if (needed.first_s >= has.first_s - 1e-9 && needed.last_s <= has.last_s + 1e-9) return;
  throw InputError{what + " runs from " + number_text(has.first_s) + " to " +
                   number_text(has.last_s) + " s, but the images need " +
                   number_text(needed.first_s) + " to " + number_text(needed.last_s) + " s"};
}

void check_spans(const PlatformDescription& description, PlatformSpan needed) {
  if (!(std::isfinite(needed.first_s) && std::isfinite(needed.last_s) &&
        needed.first_s <= needed.last_s)) {
    throw InputError{"the span of a platform must be finite and not end before it begins"};
  }
  const Track& track = description.track;
  check_cover("the platform's track", {track.first_s(), track.last_s()}, needed);
  const auto* const table = std::get_if<TabulatedAttitude>(&description.attitude);
  if (table != nullptr && table->times_s.size() > 1) {
    check_cover("the table of attitudes", {table->times_s.front(), table->times_s.back()}, needed);
  }
}

/// Moments of a table that lie inside a span.
void add_inside(const std::vector<double>& times_s, PlatformSpan span, std::vector<double>& to) {
  const auto begin = std::upper_bound(times_s.begin(), times_s.end(), span.first_s);
  const auto end = std::lower_bound(times_s.begin(), times_s.end(), span.last_s);
  if (begin < end) to.insert(to.end(), begin, end);
}

/// Where the pieces of a description meet in a span, and the span's ends.
std::vector<double> borders(const PlatformDescription& description, PlatformSpan span) {
  std::vector<double> result{span.first_s, span.last_s};
  if (!description.track.is_fixed()) add_inside(description.track.times_s(), span, result);
  if (const auto* const table = std::get_if<TabulatedAttitude>(&description.attitude)) {
    add_inside(table->times_s, span, result);
  }
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

/// Axes to the last digit: a description may give them to six.
Mat3 orthonormal_axes(const Mat3& axes) { return to_matrix(to_quaternion(axes)); }

Pose turned_by(const Pose& pose, Vec3 angles_rad) {
  return {pose.position, pose.axes * to_matrix(small_rotation(angles_rad))};
}

}  // namespace

Platform::Platform(const Pose& fixed)
    : pose_{fixed},
      // Not infinity, so that the span has a middle.
      first_s_{std::numeric_limits<double>::lowest()},
      last_s_{std::numeric_limits<double>::max()} {}

Platform::Platform(const PlatformDescription& description, const geometry::LocalFrame& frame,
                   double first_s, double last_s)
    : first_s_{first_s}, last_s_{last_s}, track_{description.track} {
  PlatformDescription legal = description;
  legal.attitude = checked(description.attitude);
  check_spans(legal, {first_s, last_s});
  for (Mount& mount : legal.mounts) {
    check(mount);
    mount.axes = orthonormal_axes(mount.axes);
  }
  jitter_ = Jitter{description.jitter, first_s, last_s};
  still_ = track_.is_fixed() && is_constant(legal.attitude);
  if (still_) {
    const TrackState state = track_.at(first_s);
    pose_ = {state.position, orthonormal_axes(axes(legal.attitude, frame, state, first_s))};
  }
  take_static_mounts(legal.mounts);
  if (!still_) tabulate(legal, frame);
  fixed_ = still_ && swinging_.empty() && !jitter_.has_memory() && !jitter_.is_white();
}

/// Mounts up to the first that swings become part of the pose where it stands still, or of its
/// lever and table where it does not.
void Platform::take_static_mounts(const std::vector<Mount>& mounts) {
  for (const Mount& mount : mounts) {
    const bool scans = std::holds_alternative<ScanMount>(mount.law);
    const bool rests = std::holds_alternative<FixedMount>(mount.law) || (still_ && !scans);
    if (!swinging_.empty() || !rests) {
      swinging_.push_back(mount);
    } else {
      pose_ = carried(pose_, mount, first_s_);
    }
  }
}

void Platform::tabulate(const PlatformDescription& description, const geometry::LocalFrame& frame) {
  // What the mounts made of a platform at the origin with the axes of the platform.
  const Mat3 mounted = pose_.axes;
  lever_m_ = mounted.transposed() * pose_.position;
  const auto law = [&](double time_s, AttitudeTable::Side side) {
    const TrackState state =
        side == AttitudeTable::Side::after ? track_.at(time_s) : track_.before(time_s);
    return to_quaternion(axes(description.attitude, frame, state, time_s) * mounted);
  };
  turning_ = AttitudeTable{law, borders(description, {first_s_, last_s_})};
}

Pose Platform::steady(double time_s) const noexcept {
  Pose pose = pose_;
  if (!still_) {
    pose.axes = to_matrix(turning_.at(time_s));
    pose.position = track_.position(time_s) + pose.axes * lever_m_;
  }
  for (const Mount& mount : swinging_) pose = carried(pose, mount, time_s);
  return pose;
}

Pose Platform::at(double time_s) const noexcept {
  if (!jitter_.has_memory()) return steady(time_s);
  return turned_by(steady(time_s), jitter_.angles_rad(time_s));
}

Pose Platform::shaken(double time_s, Vec3 normal) const noexcept {
  const Vec3 rms = jitter_.white_rms_rad();
  const Vec3 white{rms.x * normal.x, rms.y * normal.y, rms.z * normal.z};
  return turned_by(steady(time_s), jitter_.angles_rad(time_s) + white);
}

}  // namespace nadir::sensor
