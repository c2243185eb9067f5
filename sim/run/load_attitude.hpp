#pragma once

#include "sensor/platform/attitude.hpp"
#include "sensor/platform/pose.hpp"
#include "sim/run/load_track.hpp"

namespace nadir::sim {

/// How the platform is turned. One that stands still and is turned by <look_at> or <euler> has one
/// constant orientation.
/// @param track  of the platform
/// @throws InputError at the element or in the file
[[nodiscard]] sensor::Attitude load_attitude(const PlatformTask& task, const sensor::Track& track);

/// Whether <look_at> or <euler> turns it.
[[nodiscard]] bool is_aimed(const PlatformInput& platform);

/// The pose of a platform that stands still and is turned by <look_at> or <euler>.
[[nodiscard]] sensor::Pose still_pose(const PlatformTask& task, Vec3 position);

}  // namespace nadir::sim
