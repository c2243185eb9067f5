#include "radiometry/lamps/spherical_rectangle.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace nadir::radiometry {
namespace {

double angle(Vec3 n, Vec3 m) { return std::acos(std::clamp(-dot(n, m), -1.0, 1.0)); }

}  // namespace

SphericalRectangle::SphericalRectangle(const SeenRectangle& seen) noexcept : seen_{seen} {
  const double z = -seen.z;  // the source looks along -z
  const Vec3 v00{seen.x0, seen.y0, z}, v01{seen.x0, seen.y1, z}, v10{seen.x1, seen.y0, z},
      v11{seen.x1, seen.y1, z};
  const Vec3 n0 = normalised(cross(v00, v10)), n1 = normalised(cross(v10, v11)),
             n2 = normalised(cross(v11, v01)), n3 = normalised(cross(v01, v00));
  b0_ = n0.z;
  b1_ = n2.z;
  k_ = 2.0 * std::numbers::pi - angle(n2, n3) - angle(n3, n0);
  solid_angle_ = angle(n0, n1) + angle(n1, n2) - k_;
}

Vec2 SphericalRectangle::point(Vec2 u) const noexcept {
  const double au = u.x * solid_angle_ + k_;
  const double fu = (std::cos(au) * b0_ - b1_) / std::sin(au);
  const double cu = std::clamp(std::copysign(1.0 / std::sqrt(fu * fu + b0_ * b0_), fu), -1.0, 1.0);
  const double z2 = seen_.z * seen_.z;
  const double x =
      std::clamp(cu * seen_.z / std::sqrt(std::max(1.0 - cu * cu, 1e-300)), seen_.x0, seen_.x1);
  const double d2 = x * x + z2;
  const double h0 = seen_.y0 / std::sqrt(d2 + seen_.y0 * seen_.y0);
  const double h1 = seen_.y1 / std::sqrt(d2 + seen_.y1 * seen_.y1);
  const double h = h0 + u.y * (h1 - h0);
  const double y = h * std::sqrt(d2 / std::max(1.0 - h * h, 1e-300));
  return {x, std::clamp(y, seen_.y0, seen_.y1)};
}

}  // namespace nadir::radiometry
