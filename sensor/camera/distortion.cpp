#include "sensor/camera/distortion.hpp"

#include <cmath>
#include <numbers>

#include "core/error.hpp"
#include "core/text.hpp"

namespace nadir::sensor {
namespace {

struct Bent {
  Vec2 place;
  // The Jacobian of `distorted`; it is symmetric.
  double xx = 1.0, xy = 0.0, yy = 1.0;
};

Bent bent(const Distortion& lens, Vec2 p) noexcept {
  const double r2 = p.x * p.x + p.y * p.y;
  const double radial = 1.0 + r2 * (lens.k1 + r2 * (lens.k2 + r2 * lens.k3));
  // Twice the derivative of `radial` by r2.
  const double growth = 2.0 * (lens.k1 + r2 * (2.0 * lens.k2 + 3.0 * lens.k3 * r2));
  const double xy = p.x * p.y, xx = p.x * p.x, yy = p.y * p.y;
  return {{p.x * radial + 2.0 * lens.p1 * xy + lens.p2 * (r2 + 2.0 * xx),
           p.y * radial + lens.p1 * (r2 + 2.0 * yy) + 2.0 * lens.p2 * xy},
          radial + growth * xx + 2.0 * lens.p1 * p.y + 6.0 * lens.p2 * p.x,
          growth * xy + 2.0 * lens.p1 * p.x + 2.0 * lens.p2 * p.y,
          radial + growth * yy + 6.0 * lens.p1 * p.y + 2.0 * lens.p2 * p.x};
}

// Where a ray of ideal places from the axis at an angle folds before its image is `reach` away.
bool folds(const Distortion& lens, double reach, double angle) {
  const Vec2 outwards{std::cos(angle), std::sin(angle)};
  // Fine enough for polynomials of degree seven; ten times the reach: no camera is built so.
  constexpr int steps_per_reach = 128, steps = 10 * steps_per_reach;
  for (int i = 1; i <= steps; ++i) {
    const double r = reach * i / steps_per_reach;
    const Vec2 ideal{r * outwards.x, r * outwards.y};
    const Bent there = bent(lens, ideal);
    if (!(there.xx * there.yy - there.xy * there.xy > 0.0) || !(there.xx + there.yy > 0.0)) {
      return true;
    }
    const Vec2 back = undistorted(lens, there.place);
    // What Newton's method cannot undo is of no more use than what folds.
    if (!(std::hypot(back.x - ideal.x, back.y - ideal.y) <= 1e-10 * (1.0 + r))) return true;
    if (std::hypot(there.place.x, there.place.y) >= reach) return false;
  }
  return true;
}

}  // namespace

Vec2 distorted(const Distortion& lens, Vec2 ideal) noexcept { return bent(lens, ideal).place; }

Vec2 undistorted(const Distortion& lens, Vec2 place) noexcept {
  Vec2 ideal = place;
  // Steps square the error: after one of 1e-7 it is 1e-14 times the curvature, which is of the
  // order of the coefficients. Three or four steps are usual; more than ten mean a fold.
  constexpr int most = 12;
  for (int i = 0; i < most; ++i) {
    const Bent there = bent(lens, ideal);
    const double dx = place.x - there.place.x, dy = place.y - there.place.y;
    const double determinant = there.xx * there.yy - there.xy * there.xy;
    if (!(determinant > 0.0)) return ideal;  // beyond the fold: whatever is finite
    const double scale = 1.0 / determinant;
    const Vec2 step{(there.yy * dx - there.xy * dy) * scale,
                    (there.xx * dy - there.xy * dx) * scale};
    ideal = {ideal.x + step.x, ideal.y + step.y};
    if (step.x * step.x + step.y * step.y < 1e-15) return ideal;
  }
  return ideal;
}

void check(const Distortion& lens, double reach) {
  for (const double k : {lens.k1, lens.k2, lens.p1, lens.p2, lens.k3}) {
    if (!std::isfinite(k)) throw InputError{"a coefficient of the distortion is not finite"};
  }
  if (lens.is_none()) return;
  constexpr int angles = 32;
  for (int i = 0; i < angles; ++i) {
    if (!folds(lens, reach, 2.0 * std::numbers::pi * i / angles)) continue;
    throw InputError{
        "the distortion folds the image over itself within its pixels, which reach to " +
        number_text(reach) + " focal lengths from the axis: order of the coefficients? (k1, k2, " +
        "p1, p2, k3)"};
  }
}

}  // namespace nadir::sensor
