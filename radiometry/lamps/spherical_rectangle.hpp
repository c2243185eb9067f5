#pragma once

#include <optional>

#include "core/vec.hpp"

namespace nadir::radiometry {

/// A rectangle in its own axes, seen from a point: corner (x0, y0) to (x1, y1) in the plane z.
struct SeenRectangle {
  double x0 = 0.0, x1 = 0.0, y0 = 0.0, y1 = 0.0;
  double z = 0.0;  ///< distance of its plane, > 0
};

/// The solid angle that a rectangle fills, and points that are uniform in it.
/// Source: Urena, Fajardo & King, "An Area-Preserving Parametrization for Spherical Rectangles",
/// Comput. Graph. Forum 32(4), 59 (2013), doi:10.1111/cgf.12151, sections 3 and 4.
class SphericalRectangle {
 public:
  explicit SphericalRectangle(const SeenRectangle& seen) noexcept;

  /// sr; the sum of four angles less 2 pi, good to some 1e-12.
  [[nodiscard]] double solid_angle() const noexcept { return solid_angle_; }
  /// The point of the rectangle for a point of the unit square.
  [[nodiscard]] Vec2 point(Vec2 u) const noexcept;

 private:
  SeenRectangle seen_;
  double b0_ = 0.0, b1_ = 0.0, k_ = 0.0, solid_angle_ = 0.0;
};

}  // namespace nadir::radiometry
