#include "sensor/platform/pose.hpp"

#include <cmath>
#include <numbers>

#include "core/error.hpp"
#include "core/frame.hpp"

namespace nadir::sensor {
namespace {

/// Axes for a line of sight and the direction that the image's top leans to.
Mat3 camera_axes(Vec3 sight, Vec3 top, Angle roll) {
  const Vec3 right = normalised(cross(sight, top));
  const Mat3 level{right, cross(sight, right), sight};
  return rotation(sight, roll.value) * level;
}

}  // namespace

Pose look_at(Vec3 position, Vec3 target, const Mat3& local, Angle roll) {
  const Vec3 offset = target - position;
  if (!(length(offset) > 0.0)) throw InputError{"the camera looks at its own position"};
  const Vec3 sight = normalised(offset);
  // Within 1e-6 rad of the vertical (1 m off in 1000 km) "up" no longer defines an image top that
  // anyone meant; north does.
  const bool vertical = length(cross(sight, local.z)) < 1e-6;
  return {position, camera_axes(sight, vertical ? local.y : local.z, roll)};
}

Pose from_euler(Vec3 position, const Mat3& local, Angle yaw, Angle pitch, Angle roll) {
  const Vec3 sight = local * direction_enu(yaw.value, pitch.value);
  // The direction a quarter turn above the line of sight: a top that never degenerates.
  const Vec3 top = local * direction_enu(yaw.value, pitch.value + 0.5 * std::numbers::pi);
  return {position, camera_axes(sight, top, roll)};
}

}  // namespace nadir::sensor
