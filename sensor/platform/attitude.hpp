#pragma once

#include <optional>
#include <variant>
#include <vector>

#include "core/quantity.hpp"
#include "core/quaternion.hpp"
#include "geometry/earth.hpp"
#include "sensor/platform/track.hpp"

// How a platform is turned. Axes of a platform, and of a camera on it without a mount: x towards
// increasing samples (image right), y towards increasing lines (image down), z along the line of
// sight. Right-handed. All laws give their columns in scene axes.

namespace nadir::sensor {

/// Axes that orientations are given in.
enum class Reference {
  scene,  ///< east, north, up at the scenario's site
  earth,  ///< ECEF
  local,  ///< east, north, up at the platform
  orbit   ///< as TrackAttitude{Aim::nadir} without turns
};

/// Angles as in from_euler, about the platform's local axes: yaw clockwise from north, pitch above
/// the horizon, roll right side down.
struct EulerAttitude {
  Angle yaw{0.0}, pitch{0.0}, roll{0.0};
};

/// Looks at one place all the time; image top as high as it goes (look_at).
struct LookAtAttitude {
  Vec3 target;  ///< scene axes
  Angle roll{0.0};
};

/// Follows the way: z down or as near to it as the way allows, y along the way, so that lines come
/// in the order of time. x = y cross z points to the LEFT of the way seen from above (way north, z
/// down: x west), as it must in an image that is not mirrored: samples increase to the left, and
/// on a descending orbit, southwards, to the east.
struct TrackAttitude {
  enum class Aim {
    nadir,    ///< z exactly along the ellipsoid's normal, downwards; y the way's horizontal part
    velocity  ///< y exactly along the way; z as far down as that allows
  };
  Aim aim = Aim::nadir;
  bool inertial = false;  ///< the way among the stars, not over the turning earth (no yaw steering)
  /// Further turns, each about the axes that the former ones leave: yaw about z (the image's lower
  /// edge turns right, clockwise seen from above), pitch about x (raises the line of sight towards
  /// the way ahead), roll about y (turns the line of sight to the right of the way, seen by
  /// somebody who looks ahead with the head up: the left wing goes down).
  Angle yaw{0.0}, pitch{0.0}, roll{0.0};
};

/// Orientations at moments, and between them the even rotation (slerp; signs made continuous).
struct TabulatedAttitude {
  Reference reference = Reference::scene;
  std::vector<double> times_s;           ///< strictly ascending; one alone: constant
  std::vector<Quaternion> orientations;  ///< from the platform's axes to the reference's
};

using Attitude = std::variant<EulerAttitude, LookAtAttitude, TrackAttitude, TabulatedAttitude>;

/// Columns: the platform's axes, in scene axes. Exact, not fast: Platform tabulates it.
/// @param frame  of the scene
/// @param attitude  as `checked` returns it
/// @throws InputError where the law means nothing there: target at the platform, no way to follow,
///         a time outside the table
[[nodiscard]] Mat3 axes(const Attitude& attitude, const geometry::LocalFrame& frame,
                        const TrackState& state, double time_s);

/// Whether an attitude is the same at all times for a platform that stands still.
[[nodiscard]] bool is_constant(const Attitude& attitude) noexcept;

/// Columns: the earth's axes (ECEF) in scene axes.
[[nodiscard]] Mat3 earth_axes(const geometry::LocalFrame& frame);

/// Checks what can be checked without a track; makes the signs of a table continuous.
/// @throws InputError for tables that are not: times, sizes, quaternions that are not of length 1
///         within 1e-3, neighbours more than 90 degrees apart (a gap), angles that are not finite
[[nodiscard]] Attitude checked(Attitude attitude);

}  // namespace nadir::sensor
