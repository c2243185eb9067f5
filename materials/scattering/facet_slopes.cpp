#include "materials/scattering/facet_slopes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace nadir::materials {
namespace {

using std::numbers::pi;

constexpr double inv_sqrt_pi = std::numbers::inv_sqrtpi;

double square(double x) { return x * x; }

// Visible normals of the surface of roughness 1: the upper half of a sphere. Reflecting wo at a
// visible normal gives a cap of uniform density, so the normal is half-way from wo to a point
// of the cap. Differences are written out as products, so that none cancels.
// Source: Dupuy & Benyoub, Computer Graphics Forum 42(8) (2023), doi:10.1111/cgf.14867; the same
// density as Heitz, JCGT 7(4) (2018).
Vec3 draw_ggx(Vec3 wo, Vec2 u) {
  const double azimuth = 2.0 * pi * u.x;
  const double above = (1.0 - u.y) * (1.0 + wo.z);  // of the point over -wo.z
  const double to_bottom = (square(wo.x) + square(wo.y)) / (1.0 + wo.z) + above;
  const double radius = std::sqrt(u.y * (1.0 + wo.z) * to_bottom);
  return {radius * std::cos(azimuth) + wo.x, radius * std::sin(azimuth) + wo.y, above};
}

// Beyond a slope of 6 roughnesses lies 2e-16 of the Gaussian: less than the last digit of a number.
constexpr double far = 6.0;

// Inverse of the error function to 4e-3: Winitzki's closed form (2008, "A handy approximation for
// the error function and its inverse"), a start for Halley's steps. |x| < 1
double rough_inverse_erf(double x) {
  constexpr double a = 0.147;
  const double log_gap = std::log((1.0 - x) * (1.0 + x));
  const double b = 2.0 / (pi * a) + 0.5 * log_gap;
  const double root = std::sqrt(std::max(0.0, std::sqrt(b * b - log_gap / a) - b));
  return std::copysign(std::min(root, far), x);
}

// Gaussian slopes of roughness 1 seen under a direction of cosine c and sine s: the share of the
// visible area whose slope towards the viewer is less than p is
//     C(p) = (c (erf p + erf(c/s)) / 2 + s (exp(-(c/s)^2) - exp(-p^2)) / (2 sqrt pi)) / C(inf),
// p > -c/s. The slope across is a plain Gaussian. C is inverted by Halley's steps, and by halving
// the bracket where they would leave it.
// Source of C: Heitz & d'Eon, Computer Graphics Forum 33(4) (2014), doi:10.1111/cgf.12417.
class BeckmannSlope {
 public:
  BeckmannSlope(double c, double s) : c_{c}, s_{s} {
    const double cot = s * far > c ? c / s : far;
    lowest_ = -cot;
    at_lowest_ = 0.5 * (c * std::erf(cot) + s * inv_sqrt_pi * std::exp(-cot * cot));
  }

  [[nodiscard]] double inverse(double u) const {
    const double wanted = u * (at_lowest_ + 0.5 * c_);  // C(inf) times u
    double low = lowest_, high = far, p = std::clamp(guess(u), low, high);
    for (int step = 0; step < most_steps; ++step) {
      const double gauss = inv_sqrt_pi * std::exp(-p * p);
      const double excess = 0.5 * (c_ * std::erf(p) - s_ * gauss) + at_lowest_ - wanted;
      (excess > 0.0 ? high : low) = p;
      const double halley = halley_step(p, excess, gauss);
      const bool inside = halley > low && halley < high;
      const double next = inside ? halley : 0.5 * (low + high);
      // steps converge with the third power: one of 1e-5 leaves less than rounding
      if (std::abs(next - p) < 1e-5 && (inside || high - low < 1e-12)) return next;
      p = next;
    }
    return p;
  }

 private:
  /// Where the curve through p would end; outside the bracket where facets are seen edge on.
  [[nodiscard]] double halley_step(double p, double excess, double gauss) const {
    const double area = c_ + s_ * p;
    if (area < 1e-100) return lowest_;
    const double newton = excess / (area * gauss);
    const double bend = 0.5 * newton * (s_ / area - 2.0 * p);  // Halley: the density's slope
    return p - newton / std::max(0.5, 1.0 - bend);
  }
  /// Between the slopes seen from above (Gaussian) and from the horizon (Rayleigh's).
  [[nodiscard]] double guess(double u) const {
    const double slanted = s_ / (s_ + c_);
    return (1.0 - slanted) * rough_inverse_erf(std::clamp(2.0 * u - 1.0, -almost, almost)) +
           slanted * std::sqrt(-std::log1p(-std::min(u, almost)));
  }

  static constexpr double almost = 1.0 - 1e-15;
  static constexpr int most_steps = 60;  // 53 halvings exhaust the digits; 3 steps are usual
  double c_, s_;
  double lowest_ = 0.0;
  double at_lowest_ = 0.0;
};

Vec3 draw_beckmann(Vec3 wo, Vec2 u) {
  const double s = std::sqrt(wo.x * wo.x + wo.y * wo.y);
  const double along = BeckmannSlope{wo.z, s}.inverse(u.x);
  const double across = BeckmannSlope{1.0, 0.0}.inverse(u.y);
  const double x = s > 0.0 ? wo.x / s : 1.0, y = s > 0.0 ? wo.y / s : 0.0;
  return {along * x - across * y, along * y + across * x, 1.0};
}

}  // namespace

FacetSlopes::FacetSlopes(SlopeDistribution kind, Roughness alpha, double azimuth_rad)
    : kind_{kind}, alpha_{alpha}, cos_{std::cos(azimuth_rad)}, sin_{std::sin(azimuth_rad)} {}

double FacetSlopes::density(Vec3 h) const noexcept {
  if (h.z <= 0.0) return 0.0;
  const Vec3 v = to_axes(h);
  const double t = square(v.x / (alpha_.x * v.z)) + square(v.y / (alpha_.y * v.z));
  const double scale = 1.0 / (pi * alpha_.x * alpha_.y);
  if (kind_ == SlopeDistribution::beckmann) return scale * std::exp(-t) / square(v.z * v.z);
  // z^2 (1 + t) stays finite where z does not: facets on end
  const double spread = v.z * v.z + square(v.x / alpha_.x) + square(v.y / alpha_.y);
  return scale / square(spread);
}

double FacetSlopes::lambda(Vec3 w) const noexcept {
  const Vec3 v = to_axes(w);
  const double slope_sq = (square(alpha_.x * v.x) + square(alpha_.y * v.y)) / (v.z * v.z);  // 1/a^2
  if (kind_ == SlopeDistribution::ggx) {
    return 0.5 * slope_sq / (1.0 + std::sqrt(1.0 + slope_sq));  // without the difference
  }
  constexpr double unseen = 1.0 / 36.0;  // a > 6: Lambda below 1e-17
  if (slope_sq < unseen) return 0.0;
  const double slope = std::sqrt(slope_sq), a = 1.0 / slope;
  return std::max(0.0, 0.5 * (slope * inv_sqrt_pi * std::exp(-a * a) - std::erfc(a)));
}

double FacetSlopes::visible_density(Vec3 h, Vec3 wo) const noexcept {
  return density(h) * visible(wo) * std::max(0.0, dot(wo, h)) / wo.z;
}

Vec3 FacetSlopes::draw(Vec3 wo, Vec2 u) const noexcept {
  const Vec3 v = to_axes(wo);
  const Vec3 stretched = normalised({alpha_.x * v.x, alpha_.y * v.y, v.z});
  const Vec3 n =
      kind_ == SlopeDistribution::ggx ? draw_ggx(stretched, u) : draw_beckmann(stretched, u);
  // u.y rounds to 1 nowhere, but a grazing view may leave nothing of z: a facet on end
  const Vec3 h{alpha_.x * n.x, alpha_.y * n.y, std::max(n.z, 1e-30)};
  return from_axes(normalised(h));
}

}  // namespace nadir::materials
