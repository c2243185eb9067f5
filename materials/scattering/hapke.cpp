#include "materials/scattering/hapke.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace nadir::materials {
namespace {

using spectral::Spectrum;
using std::numbers::inv_pi;
using std::numbers::pi;

double diffusive_reflectance(double w) {
  const double gamma = std::sqrt(1.0 - w);
  return (1.0 - gamma) / (1.0 + gamma);
}

Spectrum times_r0(Spectrum w) {
  for (int lane = 0; lane < w.count(); ++lane) {
    w[lane] *= static_cast<float>(diffusive_reflectance(static_cast<double>(w[lane])));
  }
  return w;
}

/// 1 / H = 1 - w r0 `linear` - w `constant`: what of H does not depend on the lane.
struct HTerms {
  float linear, constant;
};

HTerms h_terms(double x) noexcept {
  // x ln((1 + x) / x) vanishes at the horizon
  const double xl = x > 0.0 ? x * std::log1p(1.0 / x) : 0.0;
  return {static_cast<float>(x * (1.0 - xl)), static_cast<float>(0.5 * xl)};
}

/// Lobes of the single-scattered light, by its share at middling angles; at least 0.4 is diffuse.
LobeShares shares(const Hapke& model, double mean_w) {
  const double h = hapke_h(mean_w, 0.5);
  const double lobes = 0.6 / (h * h);
  LobeShares s;
  s.backward = 0.5 * (1.0 + model.asymmetry_c) * lobes;
  s.forward = 0.5 * (1.0 - model.asymmetry_c) * lobes;
  s.b = model.asymmetry_b;
  s.uniform = 0.5 * (1.0 - lobes);
  return s;
}

/// E1 and E2 of Hapke (1984), eqs. 45 and 46, and the effective cosine eta without the other
/// direction's shadow, eq. 47 without chi.
struct SlopeTerms {
  double e1, e2, eta;
};

SlopeTerms slope_terms(double mu, double sine, double tan_slope) noexcept {
  if (sine <= 0.0) return {0.0, 0.0, mu};
  const double steepness = mu / (sine * tan_slope);  // cot(theta-bar) cot(zenith angle)
  SlopeTerms s{};
  s.e1 = std::exp(-2.0 * inv_pi * steepness);
  s.e2 = std::exp(-inv_pi * steepness * steepness);
  s.eta = mu + sine * tan_slope * s.e2 / (2.0 - s.e1);
  return s;
}

}  // namespace

double hapke_h(double w, double x) noexcept {
  const double xl = x > 0.0 ? x * std::log1p(1.0 / x) : 0.0;
  return 1.0 / (1.0 - w * (diffusive_reflectance(w) * x * (1.0 - xl) + 0.5 * xl));
}

BoundHapke::BoundHapke(const Hapke& model, const BindContext& context)
    : model_{model},
      w_{model.single_scattering_albedo.at(context.lanes)},
      w_r0_{times_r0(w_)},
      tan_slope_{std::tan(model.mean_slope_rad)},
      chi_{1.0 / std::sqrt(1.0 + pi * tan_slope_ * tan_slope_)},
      mixture_{shares(model, static_cast<double>(w_.mean()))},
      albedo_{context.lanes.count(), [this](Vec3 wi, Vec3 wo) { return eval(wi, wo); }} {
  albedo_.refuse_above(1.0 + 1e-3, context.lanes, "hapke");  // 1e-3: the quadrature
}

// Hapke (1984), eqs. 48 to 58. The lower of the two directions is `far`, the higher one `near`; the
// equations for i <= e and i >= e are each other's mirror image.
BoundHapke::Relief BoundHapke::relief(Vec3 wi, Vec3 wo) const noexcept {
  const double mu_i = std::abs(wi.z), mu_o = std::abs(wo.z);
  if (tan_slope_ <= 0.0) return {mu_i, mu_o, 1.0};
  const double sin_i = std::sqrt(wi.x * wi.x + wi.y * wi.y),
               sin_o = std::sqrt(wo.x * wo.x + wo.y * wo.y);
  const bool view_is_near = mu_o > mu_i;
  const double mu_near = view_is_near ? mu_o : mu_i, mu_far = view_is_near ? mu_i : mu_o;
  const double sin_near = view_is_near ? sin_o : sin_i, sin_far = view_is_near ? sin_i : sin_o;
  const SlopeTerms near = slope_terms(mu_near, sin_near, tan_slope_);
  const SlopeTerms far = slope_terms(mu_far, sin_far, tan_slope_);

  const double across = sin_i * sin_o;
  const double cos_psi =
      across > 0.0 ? std::clamp((wi.x * wo.x + wi.y * wo.y) / across, -1.0, 1.0) : 1.0;
  const double sine2_half_psi = 0.5 * (1.0 - cos_psi);
  // 1e-12: both directions in the horizon, opposite each other, give 0 / 0, whose limit is finite
  const double shadow = std::max(1e-12, 2.0 - far.e1 - std::acos(cos_psi) * inv_pi * near.e1);
  const double near_e =
      std::max(0.0, chi_ * (mu_near + sin_near * tan_slope_ *
                                          (cos_psi * far.e2 + sine2_half_psi * near.e2) / shadow));
  const double far_e =
      chi_ * (mu_far + sin_far * tan_slope_ * (far.e2 - sine2_half_psi * near.e2) / shadow);

  // exp(-2 tan(psi / 2)): how alike the shadows of both directions lie
  const double alike =
      cos_psi > -1.0 ? std::exp(-2.0 * std::sqrt((1.0 - cos_psi) / (1.0 + cos_psi))) : 0.0;
  const double ratio = mu_near / near.eta;  // chi mu / mu_e(0)
  // f = r / mu_i, so S mu_ie / mu_i stands here; chi^2 of both mu_e(0) and S's chi are in it
  const double factor =
      near_e * far_e / (chi_ * near.eta * far.eta * (1.0 - alike + alike * ratio));
  return view_is_near ? Relief{far_e, near_e, factor} : Relief{near_e, far_e, factor};
}

double BoundHapke::single_scattering(Vec3 wi, Vec3 wo) const noexcept {
  const double b = model_.asymmetry_b, c = model_.asymmetry_c;
  const Vec3 difference = wi - wo, sum = wi + wo;  // lengths 2 sin(g/2), 2 cos(g/2)
  const double sine2 = 0.25 * dot(difference, difference), cosine2 = 0.25 * dot(sum, sum);
  const double back = (1.0 - b) * (1.0 - b) + 4.0 * b * sine2;       // 1 + b^2 - 2 b cos(g)
  const double forward = (1.0 - b) * (1.0 - b) + 4.0 * b * cosine2;  // 1 + b^2 + 2 b cos(g)
  const double p =
      0.5 * (1.0 - b) * (1.0 + b) *
      ((1.0 + c) / (back * std::sqrt(back)) + (1.0 - c) / (forward * std::sqrt(forward)));
  if (model_.opposition_b0 <= 0.0) return p;
  const double h_cosine = model_.opposition_h * std::sqrt(cosine2);
  const double opposition = model_.opposition_b0 * h_cosine / (h_cosine + std::sqrt(sine2));
  return p * (1.0 + opposition);
}

Spectrum BoundHapke::eval(Vec3 wi, Vec3 wo) const noexcept {
  Spectrum f{w_.count()};
  if (!(wi.z * wo.z > 0.0)) return f;
  const Relief r = relief(wi, wo);
  const auto scale = static_cast<float>(r.factor * 0.25 * inv_pi / (r.mu_i + r.mu_o));
  const auto single = static_cast<float>(single_scattering(wi, wo) - 1.0);
  const HTerms hi = h_terms(r.mu_i), ho = h_terms(r.mu_o);
  for (int lane = 0; lane < f.count(); ++lane) {
    const float w = w_[lane], w_r0 = w_r0_[lane];
    const float inverse_hi = 1.0F - w_r0 * hi.linear - w * hi.constant;
    const float inverse_ho = 1.0F - w_r0 * ho.linear - w * ho.constant;
    f[lane] = scale * w * (single + 1.0F / (inverse_hi * inverse_ho));
  }
  return f;
}

double BoundHapke::pdf(Vec3 wi, Vec3 wo) const noexcept { return pdf_by(mixture_, wi, wo); }

std::optional<ScatteringSample> BoundHapke::sample(Vec3 wo,
                                                   const ScatteringDraw& u) const noexcept {
  return draw_by(mixture_, *this, wo, u);
}

Albedo BoundHapke::albedo(Vec3 wo) const noexcept { return albedo_.at(wo.z); }

}  // namespace nadir::materials
