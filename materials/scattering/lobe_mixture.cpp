#include "materials/scattering/lobe_mixture.hpp"

#include <algorithm>
#include <numbers>

#include "core/frame.hpp"

namespace nadir::materials {
namespace {

using std::numbers::inv_pi;
using std::numbers::pi;

Vec3 about_z(double z, double radius, double turn) {
  const double azimuth = 2.0 * pi * turn;
  return {radius * std::cos(azimuth), radius * std::sin(azimuth), z};
}

double sine_of(double cosine) { return std::sqrt(std::max(0.0, (1.0 - cosine) * (1.0 + cosine))); }

}  // namespace

LobeMixture::LobeMixture(const LobeShares& shares) noexcept : shares_{shares} {}

double LobeMixture::lobe(double cosine) const noexcept {
  const double b = shares_.b;
  const double d = (1.0 - b) * (1.0 - b) + 2.0 * b * (1.0 - cosine);  // 1 + b^2 - 2 b cosine
  return (1.0 - b) * (1.0 + b) / (4.0 * pi * d * std::sqrt(d));
}

double LobeMixture::pdf(Vec3 wi, Vec3 wo) const noexcept {
  const double cosine = 1.0 - shares_.uniform - shares_.backward - shares_.forward;
  double density = cosine * wi.z * inv_pi + shares_.uniform * 0.5 * inv_pi;
  if (shares_.backward <= 0.0 && shares_.forward <= 0.0) return density;
  // Cosines between wo and wi, and between wo and wi's mirror image below the horizon.
  const double across = wi.x * wo.x + wi.y * wo.y, along = wi.z * wo.z;
  const double above = across + along, below = across - along;
  if (shares_.backward > 0.0) density += shares_.backward * (lobe(above) + lobe(below));
  if (shares_.forward > 0.0) density += shares_.forward * (lobe(-above) + lobe(-below));
  return density;
}

// Inverse of the lobe's cumulative distribution in the cosine.
// Source: Witt, ApJS 35, 1 (1977), eq. 19.
Vec3 LobeMixture::draw_lobe(Vec3 axis, Vec2 point) const noexcept {
  const double b = shares_.b;
  double cosine = 1.0 - 2.0 * point.x;
  if (b > 1e-4) {  // below, the lobe is uniform to 3e-4, and the formula would lose digits
    const double s = (1.0 - b * b) / (1.0 - b + 2.0 * b * point.x);
    cosine = std::clamp((1.0 + b * b - s * s) / (2.0 * b), -1.0, 1.0);
  }
  return frame_about(axis).to_world(about_z(cosine, sine_of(cosine), point.y));
}

Vec3 LobeMixture::draw(Vec3 wo, const ScatteringDraw& u) const noexcept {
  double left = u.choice - shares_.backward;
  if (left < 0.0 || (left -= shares_.forward) < 0.0) {
    const bool backward = u.choice < shares_.backward;
    Vec3 wi = draw_lobe(backward ? wo : -wo, u.point);
    wi.z = std::abs(wi.z);
    return normalised(wi);
  }
  if (left < shares_.uniform) {
    const double z = 1.0 - u.point.x;
    return about_z(z, sine_of(z), u.point.y);
  }
  // Malley: a uniform point on the disc, lifted to the hemisphere, has density cos / pi.
  return about_z(std::sqrt(1.0 - u.point.x), std::sqrt(u.point.x), u.point.y);
}

}  // namespace nadir::materials
