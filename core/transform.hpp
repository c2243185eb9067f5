#pragma once

#include <cmath>

#include "core/vec.hpp"

namespace nadir {

/// A 3 x 3 matrix by columns: x, y and z are the images of the unit vectors.
struct Mat3 {
  Vec3 x{1.0, 0.0, 0.0}, y{0.0, 1.0, 0.0}, z{0.0, 0.0, 1.0};

  friend constexpr Vec3 operator*(const Mat3& m, Vec3 v) {
    return v.x * m.x + v.y * m.y + v.z * m.z;
  }
  friend constexpr Mat3 operator*(const Mat3& a, const Mat3& b) {
    return {a * b.x, a * b.y, a * b.z};
  }
  [[nodiscard]] constexpr Mat3 transposed() const {
    return {{x.x, y.x, z.x}, {x.y, y.y, z.y}, {x.z, y.z, z.z}};
  }
  [[nodiscard]] constexpr double determinant() const { return dot(x, cross(y, z)); }
  /// Inverse; the caller has made sure that the determinant is not zero.
  [[nodiscard]] constexpr Mat3 inverse() const {
    const double d = determinant();
    return Mat3{cross(y, z) / d, cross(z, x) / d, cross(x, y) / d}.transposed();
  }
};

[[nodiscard]] constexpr Mat3 scaling(Vec3 s) {
  return {{s.x, 0.0, 0.0}, {0.0, s.y, 0.0}, {0.0, 0.0, s.z}};
}

/// Rotation by `angle_rad` about a unit `axis`, right-handed (Rodrigues).
[[nodiscard]] inline Mat3 rotation(Vec3 axis, double angle_rad) {
  const double c = std::cos(angle_rad), s = std::sin(angle_rad);
  const auto turn = [&](Vec3 v) {
    return v * c + cross(axis, v) * s + axis * (dot(axis, v) * (1.0 - c));
  };
  return {turn({1.0, 0.0, 0.0}), turn({0.0, 1.0, 0.0}), turn({0.0, 0.0, 1.0})};
}

/// p -> linear p + origin.
struct Affine {
  Mat3 linear;
  Vec3 origin;

  [[nodiscard]] constexpr Vec3 point(Vec3 p) const { return linear * p + origin; }
  [[nodiscard]] constexpr Vec3 vector(Vec3 v) const { return linear * v; }
  friend constexpr Affine operator*(const Affine& a, const Affine& b) {
    return {a.linear * b.linear, a.point(b.origin)};
  }
  [[nodiscard]] constexpr Affine inverse() const {
    const Mat3 back = linear.inverse();
    return {back, -(back * origin)};
  }
};

}  // namespace nadir
