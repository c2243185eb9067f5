#pragma once

#include "core/transform.hpp"
#include "core/vec.hpp"

namespace nadir {

/// A rotation as a unit quaternion, scalar first; q and -q are the same rotation.
/// v' = q v q*, the same as to_matrix(q) * v.
struct Quaternion {
  double w = 1.0, x = 0.0, y = 0.0, z = 0.0;
};

/// @param q  not all zero
[[nodiscard]] Quaternion unit(const Quaternion& q) noexcept;
/// The rotation `b`, then `a`.
[[nodiscard]] Quaternion operator*(const Quaternion& a, const Quaternion& b) noexcept;
[[nodiscard]] Quaternion conjugate(const Quaternion& q) noexcept;
/// The same rotation with all signs changed.
[[nodiscard]] Quaternion operator-(const Quaternion& q) noexcept;
[[nodiscard]] double dot(const Quaternion& a, const Quaternion& b) noexcept;

/// The angle of the rotation that leads from one to the other, in [0, pi], rad; exact for the
/// smallest angles too. Signs do not matter.
[[nodiscard]] double angle_between(const Quaternion& a, const Quaternion& b) noexcept;

[[nodiscard]] Mat3 to_matrix(const Quaternion& q) noexcept;
/// Source: S. W. Shepperd, "Quaternion from rotation matrix", J. Guidance and Control 1, 223
/// (1978).
/// @param m  a rotation: orthonormal, determinant 1
[[nodiscard]] Quaternion to_quaternion(const Mat3& m) noexcept;

/// The rotation by the length of a vector, rad, about its direction, where it is small: off by
/// |angles|^3 / 12, and a rotation whatever the angles.
[[nodiscard]] Quaternion small_rotation(Vec3 angles_rad) noexcept;

/// Spherical linear interpolation from a (share 0) to b (share 1) at constant angular rate. The
/// signs are taken as they are: make them continuous first. Of length 1 to rounding for all angles;
/// where b = -a, which has no shortest way, it stays at a.
/// Source: K. Shoemake, "Animating rotation with quaternion curves", SIGGRAPH 1985.
[[nodiscard]] Quaternion slerp(const Quaternion& a, const Quaternion& b, double share) noexcept;

}  // namespace nadir
