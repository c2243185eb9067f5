#include "core/quaternion.hpp"

#include <algorithm>
#include <cmath>

namespace nadir {
namespace {

Quaternion weighted(const Quaternion& a, double weight_a, const Quaternion& b, double weight_b) {
  return {weight_a * a.w + weight_b * b.w, weight_a * a.x + weight_b * b.x,
          weight_a * a.y + weight_b * b.y, weight_a * a.z + weight_b * b.z};
}

/// sin(x) / x by its series; `square` = x^2 below 1e-4: the next term is below 1e-21.
double small_sinc(double square) {
  return 1.0 - square / 6.0 * (1.0 - square / 20.0 * (1.0 - square / 42.0));
}

/// From the square of a chord, below 1e-4, that of the arc: (2 asin(c / 2))^2 by its series. The
/// next term is 3e-20 of the sum.
double arc_square(double chord_square) {
  const double s = chord_square;
  return s * (1.0 + s * (1.0 / 12.0 + s * (1.0 / 90.0 + s / 560.0)));
}

double chord_square(const Quaternion& a, const Quaternion& b) {
  const Quaternion chord = weighted(b, 1.0, a, -1.0);
  return dot(chord, chord);
}

/// slerp of any angle; by half-angle and not by the cosine, which knows nothing of small ones.
Quaternion wide_slerp(const Quaternion& a, const Quaternion& b, double share) {
  const double apart = std::sqrt(chord_square(a, b)), together = std::sqrt(chord_square(a, -b));
  const double angle = 2.0 * std::atan2(apart, together), sine = std::sin(angle);
  // 1e-15: nearer to opposite than rounding can tell apart.
  if (together < 1e-15) return a;
  return weighted(a, std::sin((1.0 - share) * angle) / sine, b, std::sin(share * angle) / sine);
}

}  // namespace

Quaternion unit(const Quaternion& q) noexcept {
  const double scale = 1.0 / std::sqrt(dot(q, q));
  return {q.w * scale, q.x * scale, q.y * scale, q.z * scale};
}

Quaternion operator*(const Quaternion& a, const Quaternion& b) noexcept {
  return {
      a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z, a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
      a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x, a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w};
}

Quaternion conjugate(const Quaternion& q) noexcept { return {q.w, -q.x, -q.y, -q.z}; }

Quaternion operator-(const Quaternion& q) noexcept { return {-q.w, -q.x, -q.y, -q.z}; }

double dot(const Quaternion& a, const Quaternion& b) noexcept {
  return a.w * b.w + a.x * b.x + a.y * b.y + a.z * b.z;
}

double angle_between(const Quaternion& a, const Quaternion& b) noexcept {
  const double one = chord_square(a, b), other = chord_square(a, -b);
  return 4.0 * std::atan2(std::sqrt(std::min(one, other)), std::sqrt(std::max(one, other)));
}

Mat3 to_matrix(const Quaternion& q) noexcept {
  const double xx = q.x * q.x, yy = q.y * q.y, zz = q.z * q.z;
  const double xy = q.x * q.y, yz = q.y * q.z, zx = q.z * q.x;
  const double wx = q.w * q.x, wy = q.w * q.y, wz = q.w * q.z;
  return {{1.0 - 2.0 * (yy + zz), 2.0 * (xy + wz), 2.0 * (zx - wy)},
          {2.0 * (xy - wz), 1.0 - 2.0 * (zz + xx), 2.0 * (yz + wx)},
          {2.0 * (zx + wy), 2.0 * (yz - wx), 1.0 - 2.0 * (xx + yy)}};
}

Quaternion to_quaternion(const Mat3& m) noexcept {
  // By the largest of the four: no difference of near equals.
  const double trace = m.x.x + m.y.y + m.z.z;
  const double largest = std::max({trace, m.x.x, m.y.y, m.z.z});
  const double yz = m.y.z - m.z.y, zx = m.z.x - m.x.z, xy = m.x.y - m.y.x;
  if (largest == trace) return unit({1.0 + trace, yz, zx, xy});
  if (largest == m.x.x) {
    return unit({yz, 1.0 + 2.0 * m.x.x - trace, m.y.x + m.x.y, m.z.x + m.x.z});
  }
  if (largest == m.y.y) {
    return unit({zx, m.y.x + m.x.y, 1.0 + 2.0 * m.y.y - trace, m.z.y + m.y.z});
  }
  return unit({xy, m.z.x + m.x.z, m.z.y + m.y.z, 1.0 + 2.0 * m.z.z - trace});
}

Quaternion small_rotation(Vec3 angles_rad) noexcept {
  return unit({1.0, 0.5 * angles_rad.x, 0.5 * angles_rad.y, 0.5 * angles_rad.z});
}

Quaternion slerp(const Quaternion& a, const Quaternion& b, double share) noexcept {
  const double chord = chord_square(a, b);
  if (chord > 1e-4) return wide_slerp(a, b, share);
  // Tables are asked for every ray, and their steps are small: no sine, no arc.
  const double square = arc_square(chord), rest = 1.0 - share;
  const double scale = 1.0 / small_sinc(square);
  return weighted(a, rest * small_sinc(rest * rest * square) * scale, b,
                  share * small_sinc(share * share * square) * scale);
}

}  // namespace nadir
