#include "materials/scattering/oren_nayar.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "materials/scattering/cosine_lobe.hpp"

namespace nadir::materials {
namespace {

using spectral::Spectrum;

/// max(0, cos(phi_i - phi_o)) sin(alpha) tan(beta), in vectors: the sines of both angles and the
/// cosine between them are the horizontal product, and cos(beta) is the larger cosine.
double shape(Vec3 wi, Vec3 wo) {
  const double horizontal = wi.x * wo.x + wi.y * wo.y;
  return std::max(0.0, horizontal) / std::max(std::abs(wi.z), std::abs(wo.z));
}

/// The lobe's integral over theta_i, without the factor 2/pi: the part with theta_i below theta_o
/// and the part above.
struct LobeIntegral {
  double sine, mu;
  double nearer, farther;

  explicit LobeIntegral(Vec3 wo)
      : sine{std::sqrt(wo.x * wo.x + wo.y * wo.y)}, mu{std::min(std::abs(wo.z), 1.0)} {
    const double theta = std::atan2(sine, mu);
    nearer = 0.5 * sine * (theta - sine * mu);
    // tan (1 - sin^3) / 3 with 1 - sin = mu^2 / (1 + sin): no cancellation at grazing
    farther = sine * mu * (1.0 + sine + sine * sine) / (3.0 * (1.0 + sine));
  }
  [[nodiscard]] double g() const { return 2.0 * std::numbers::inv_pi * (nearer + farther); }
};

/// Solves x - sin(x) = m for m in [0, pi] (Kepler's equation of eccentricity 1) by Halley's method
/// from the small-angle solution: three steps reach 1e-14.
double solve_kepler(double m) {
  double x = std::cbrt(6.0 * m);
  if (m < 1e-9) return x;  // the start is right to x^2 / 60 = 6e-8 of its value
  for (int i = 0; i < 3; ++i) {
    const double f = x - std::sin(x) - m, slope = 1.0 - std::cos(x), bend = std::sin(x);
    x -= 2.0 * f * slope / (2.0 * slope * slope - f * bend);
  }
  return x;
}

/// Sine of theta_i, from the lobe's exact distribution over theta_i.
double draw_sine(const LobeIntegral& lobe, double u) {
  const double area = u * (lobe.nearer + lobe.farther);
  if (area < lobe.nearer) return std::sin(0.5 * solve_kepler(4.0 * area / lobe.sine));
  const double cube =
      lobe.sine * lobe.sine * lobe.sine + 3.0 * (area - lobe.nearer) * lobe.mu / lobe.sine;
  return std::min(std::cbrt(cube), 1.0);
}

/// A direction from the lobe; the density of the azimuth difference is cos / 2.
Vec3 draw_lobe(const LobeIntegral& lobe, Vec3 wo, Vec2 u) {
  const double sine = draw_sine(lobe, u.x);
  const double sin_phi = 2.0 * u.y - 1.0, cos_phi = 2.0 * std::sqrt(u.y * (1.0 - u.y));
  const double x = wo.x / lobe.sine, y = wo.y / lobe.sine;
  return {sine * (x * cos_phi - y * sin_phi), sine * (y * cos_phi + x * sin_phi),
          std::copysign(std::sqrt((1.0 - sine) * (1.0 + sine)), wo.z)};
}

}  // namespace

BoundOrenNayar::BoundOrenNayar(const OrenNayar& model, const BindContext& context)
    : over_pi_{context.reflectance * std::numbers::inv_pi_v<float>},
      lobe_over_pi_{context.lanes.count()},
      reflectance_{context.reflectance},
      lobe_{context.lanes.count()} {
  const double s = model.slope_sigma_rad * model.slope_sigma_rad;
  const double b = 0.45 * s / (s + 0.09) / (1.0 - 0.5 * s / (s + 0.33));
  for (int lane = 0; lane < lobe_.count(); ++lane) {
    const auto rho = static_cast<double>(reflectance_[lane]);
    lobe_[lane] = static_cast<float>(std::max(0.0, std::min(rho * b, 2.0 * (1.0 - rho))));
  }
  lobe_over_pi_ = lobe_ * std::numbers::inv_pi_v<float>;
  const auto mean = static_cast<double>(reflectance_.mean());
  if (mean > 0.0) mean_b_ = static_cast<double>(lobe_.mean()) / mean;
}

Spectrum BoundOrenNayar::eval(Vec3 wi, Vec3 wo) const noexcept {
  if (!on_one_side(wi, wo)) return Spectrum{over_pi_.count()};
  Spectrum f = over_pi_;
  return f.add_scaled(lobe_over_pi_, static_cast<float>(shape(wi, wo)));
}

double BoundOrenNayar::pdf(Vec3 wi, Vec3 wo) const noexcept {
  if (!on_one_side(wi, wo)) return 0.0;
  const double norm = 1.0 + mean_b_ * LobeIntegral{wo}.g();
  return cosine_pdf(wi) * (1.0 + mean_b_ * shape(wi, wo)) / norm;
}

std::optional<ScatteringSample> BoundOrenNayar::sample(Vec3 wo,
                                                       const ScatteringDraw& u) const noexcept {
  if (wo.z == 0.0) return std::nullopt;
  const LobeIntegral lobe{wo};
  const double norm = 1.0 + mean_b_ * lobe.g();
  const bool diffuse = u.choice * norm < 1.0 || lobe.sine <= 0.0;
  const Vec3 wi = diffuse ? draw_cosine(u.point, wo.z) : draw_lobe(lobe, wo, u.point);
  if (wi.z == 0.0) return std::nullopt;
  const double m = shape(wi, wo), density = (1.0 + mean_b_ * m) / norm;
  Spectrum weight = reflectance_ * static_cast<float>(1.0 / density);
  weight.add_scaled(lobe_, static_cast<float>(m / density));
  return ScatteringSample{wi, cosine_pdf(wi) * density, false, weight};
}

Albedo BoundOrenNayar::albedo(Vec3 wo) const noexcept {
  Spectrum r = reflectance_;
  r.add_scaled(lobe_, static_cast<float>(LobeIntegral{wo}.g()));
  return {r, Spectrum{r.count()}};
}

}  // namespace nadir::materials
