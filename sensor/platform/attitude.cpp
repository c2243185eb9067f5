#include "sensor/platform/attitude.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/error.hpp"
#include "core/text.hpp"
#include "sensor/orbit/earth_frames.hpp"
#include "sensor/platform/pose.hpp"

namespace nadir::sensor {
namespace {

/// What the laws are asked at: the place's own axes are computed where a law needs them.
struct AttitudePlace {
  const geometry::LocalFrame& frame;
  const TrackState& state;
  double time_s;

  [[nodiscard]] Mat3 local() const { return frame.axes_at(frame.geodetic(state.position)); }
};

/// Velocity among the stars, in the axes of the turning earth: v + omega cross r.
Vec3 inertial_velocity(const AttitudePlace& place) {
  const Mat3 earth = earth_axes(place.frame);
  const Vec3 r = place.frame.ecef(place.state.position);
  return place.state.velocity + earth * cross({0.0, 0.0, earth_rate_rad_s}, r);
}

/// What is left of a vector at right angles to a unit axis, of length 1.
/// @throws InputError where nothing is left
Vec3 square_to(Vec3 axis, Vec3 v, const char* message) {
  const Vec3 rest = v - axis * dot(axis, v);
  // 1e-9 of the whole is rounding of what cancels; also where the whole is 0.
  if (!(length(rest) > 1e-9 * length(v))) throw InputError{message};
  return normalised(rest);
}

Mat3 track_axes(const TrackAttitude& law, const AttitudePlace& place) {
  const Vec3 way = law.inertial ? inertial_velocity(place) : place.state.velocity;
  // A micrometre a second: less is the rounding of places that stand still.
  if (!(length(way) > 1e-6)) throw InputError{"the platform stands still: no way to follow"};
  const Vec3 down = -place.local().z;
  if (law.aim == TrackAttitude::Aim::nadir) {
    const Vec3 y = square_to(down, way, "the platform moves straight up or down: no way to follow");
    return {cross(y, down), y, down};
  }
  const Vec3 y = normalised(way);
  const Vec3 z = square_to(y, down, "the platform moves straight up or down: no side is down");
  return {cross(y, z), y, z};
}

Mat3 axes_of(const TrackAttitude& law, const AttitudePlace& place) {
  const Mat3 yaw = rotation({0.0, 0.0, 1.0}, law.yaw.value);
  const Mat3 pitch = rotation({1.0, 0.0, 0.0}, -law.pitch.value);
  const Mat3 roll = rotation({0.0, 1.0, 0.0}, -law.roll.value);
  return track_axes(law, place) * yaw * pitch * roll;
}

Mat3 axes_of(const EulerAttitude& law, const AttitudePlace& place) {
  return from_euler(place.state.position, place.local(), law.yaw, law.pitch, law.roll).axes;
}

Mat3 axes_of(const LookAtAttitude& law, const AttitudePlace& place) {
  return look_at(place.state.position, law.target, place.local(), law.roll).axes;
}

Quaternion orientation_at(const TabulatedAttitude& table, double time_s) {
  const auto& times = table.times_s;
  if (times.size() == 1) return table.orientations.front();
  // A nanosecond beyond: times of lines are sums, and rounded.
  if (!(time_s >= times.front() - 1e-9 && time_s <= times.back() + 1e-9)) {
    throw InputError{"the table of attitudes runs from " + number_text(times.front()) + " to " +
                     number_text(times.back()) + " s, not to " + number_text(time_s) + " s"};
  }
  const auto above = std::upper_bound(times.begin() + 1, times.end() - 1, time_s);
  const auto i = static_cast<std::size_t>(above - times.begin());
  const double inside_s = std::clamp(time_s, times.front(), times.back());
  const double share = (inside_s - times[i - 1]) / (times[i] - times[i - 1]);
  return slerp(table.orientations[i - 1], table.orientations[i], share);
}

Mat3 reference_axes(Reference reference, const AttitudePlace& place) {
  switch (reference) {
    case Reference::scene:
      return {};
    case Reference::earth:
      return earth_axes(place.frame);
    case Reference::local:
      return place.local();
    case Reference::orbit:
      return track_axes(TrackAttitude{}, place);
  }
  return {};
}

Mat3 axes_of(const TabulatedAttitude& law, const AttitudePlace& place) {
  return reference_axes(law.reference, place) * to_matrix(orientation_at(law, place.time_s));
}

void check_angles(Vec3 angles) {
  if (!is_finite(angles)) throw InputError{"the angles of an attitude must be finite"};
}

void check(const EulerAttitude& law) {
  check_angles({law.yaw.value, law.pitch.value, law.roll.value});
}

void check(const LookAtAttitude& law) {
  check_angles({0.0, 0.0, law.roll.value});
  if (!is_finite(law.target)) throw InputError{"the target of an attitude must be finite"};
}

void check(const TrackAttitude& law) {
  check_angles({law.yaw.value, law.pitch.value, law.roll.value});
}

/// Brings an entry to length 1 and to the sign of the one before.
void make_continuous(TabulatedAttitude& table, std::size_t i) {
  Quaternion& q = table.orientations[i];
  const double length = std::sqrt(dot(q, q));
  // 1e-3: more than rounding to four digits leaves; something else was meant.
  if (!(std::abs(length - 1.0) <= 1e-3)) {
    throw InputError{"quaternion " + std::to_string(i + 1) +
                     " of the table of attitudes has length " + number_text(length) + ", not 1"};
  }
  q = unit(q);
  if (i == 0) return;
  const Quaternion& before = table.orientations[i - 1];
  if (dot(q, before) < 0.0) q = -q;
  // A turn by 90 degrees is one of 45 among quaternions. Rounding may not make a gap of it.
  if (dot(q, before) < std::sqrt(0.5) - 1e-9) {
    throw InputError{"the table of attitudes has a gap: it turns by " +
                     number_text(std::round(to_degrees(Angle{angle_between(q, before)}))) +
                     " degrees between " + number_text(table.times_s[i - 1]) + " and " +
                     number_text(table.times_s[i]) + " s, more than 90"};
  }
}

void check(TabulatedAttitude& table) {
  const auto& times = table.times_s;
  if (times.size() != table.orientations.size()) {
    throw InputError{"the table of attitudes has " + std::to_string(times.size()) + " times but " +
                     std::to_string(table.orientations.size()) + " quaternions"};
  }
  if (times.empty()) throw InputError{"the table of attitudes is empty"};
  for (std::size_t i = 0; i < times.size(); ++i) {
    if (!std::isfinite(times[i])) {
      throw InputError{"time " + std::to_string(i + 1) +
                       " of the table of attitudes is not finite"};
    }
    if (i > 0 && !(times[i] > times[i - 1])) {
      throw InputError{"the times of the table of attitudes must ascend: " + number_text(times[i]) +
                       " s follows " + number_text(times[i - 1]) + " s"};
    }
    make_continuous(table, i);
  }
}

}  // namespace

Mat3 earth_axes(const geometry::LocalFrame& frame) {
  // At latitude and longitude 0: east is the earth's y, north its z, up its x.
  const Mat3 local = frame.axes_at({0.0, 0.0, 0.0});
  return {local.z, local.x, local.y};
}

Mat3 axes(const Attitude& attitude, const geometry::LocalFrame& frame, const TrackState& state,
          double time_s) {
  const AttitudePlace place{frame, state, time_s};
  return std::visit([&](const auto& law) { return axes_of(law, place); }, attitude);
}

bool is_constant(const Attitude& attitude) noexcept {
  const auto* const table = std::get_if<TabulatedAttitude>(&attitude);
  return table == nullptr || table->times_s.size() == 1;
}

Attitude checked(Attitude attitude) {
  std::visit([](auto& law) { check(law); }, attitude);
  return attitude;
}

}  // namespace nadir::sensor
