#pragma once

#include "core/transform.hpp"
#include "core/vec.hpp"

namespace nadir {

/// A rotation as a unit quaternion, scalar first; q and -q are the same rotation.
/// v' = q v q*, the same as to_matrix(q) * v.
struct Quaternion {
  double w = 1.0, x = 0.0, y = 0.0, z = 0.0;
};

[[nodiscard]] Quaternion normalised(const Quaternion& q) noexcept;
/// The rotation `b`, then `a`.
[[nodiscard]] Quaternion operator*(const Quaternion& a, const Quaternion& b) noexcept;
[[nodiscard]] Quaternion conjugate(const Quaternion& q) noexcept;
[[nodiscard]] double dot(const Quaternion& a, const Quaternion& b) noexcept;

[[nodiscard]] Mat3 to_matrix(const Quaternion& q) noexcept;
/// @param m  a rotation: orthonormal, determinant 1
[[nodiscard]] Quaternion to_quaternion(const Mat3& m) noexcept;

/// Spherical linear interpolation from a (share 0) to b (share 1) at constant angular rate. The
/// signs are taken as they are: make them continuous first.
[[nodiscard]] Quaternion slerp(const Quaternion& a, const Quaternion& b, double share) noexcept;

}  // namespace nadir
