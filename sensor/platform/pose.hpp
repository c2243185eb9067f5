#pragma once

#include "core/quantity.hpp"
#include "core/transform.hpp"
#include "core/vec.hpp"

namespace nadir::sensor {

/// Where a camera stands and how it is turned, in scene axes (local east-north-up, m).
/// Columns of `axes`: x towards increasing samples (image right), y towards increasing lines (image
/// down), z along the line of sight. Right-handed.
struct Pose {
  Vec3 position;
  Mat3 axes;
};

/// A camera that looks at a target. With roll 0 the image's top is as high as it can be; where the
/// line of sight is vertical, the top is north. Positive roll turns the camera clockwise about its
/// line of sight, seen from behind.
/// @param local  columns: east, north and up at the camera, in scene axes
/// @throws InputError where target and position coincide
[[nodiscard]] Pose look_at(Vec3 position, Vec3 target, const Mat3& local, Angle roll);

/// A camera turned by angles: yaw clockwise from north, then pitch above the horizontal plane
/// (-90 degrees: straight down, image top towards the yaw azimuth), then roll as above.
[[nodiscard]] Pose from_euler(Vec3 position, const Mat3& local, Angle yaw, Angle pitch, Angle roll);

}  // namespace nadir::sensor
