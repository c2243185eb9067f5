#include "materials/scattering/ross_li.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace nadir::materials {
namespace {

using spectral::Spectrum;
using std::numbers::pi;

Spectrum over_pi(const spectral::Curve& weight, const spectral::Lanes& lanes) {
  return weight.at(lanes) * static_cast<float>(1.0 / pi);
}

}  // namespace

double ross_thick(const HeldAngles& angles) noexcept {
  const double cosine = angles.cos_phase(), phase = std::acos(cosine);
  const double sine = std::sqrt((1.0 - cosine) * (1.0 + cosine));
  return ((0.5 * pi - phase) * cosine + sine) / (angles.mu_i + angles.mu_o) - 0.25 * pi;
}

double li_sparse_reciprocal(const HeldAngles& angles) noexcept {
  constexpr double height_over_radius = 2.0;  // h/b; with b/r = 1 the crowns are spheres
  const double sec_i = 1.0 / angles.mu_i, sec_o = 1.0 / angles.mu_o, both = sec_i + sec_o;
  const double tangents = angles.sin_i * sec_i * angles.sin_o * sec_o;
  const double sine_phi2 = (1.0 - angles.cos_phi) * (1.0 + angles.cos_phi);
  const double distance = angles.shadow_distance();
  const double reach = std::sqrt(distance * distance + tangents * tangents * sine_phi2);
  const double cos_t = std::min(1.0, height_over_radius * reach / both);
  const double sin_t = std::sqrt((1.0 - cos_t) * (1.0 + cos_t));
  const double overlap = (std::acos(cos_t) - sin_t * cos_t) * both / pi;
  return overlap - both + 0.5 * (1.0 + angles.cos_phase()) * sec_i * sec_o;
}

// The held function varies by a factor of a few: cosine-weighted directions serve it, with some
// uniform ones for surfaces that brighten towards the horizon.
BoundRossLi::BoundRossLi(const RossLi& model, const BindContext& context)
    : isotropic_{over_pi(model.isotropic, context.lanes)},
      volumetric_{over_pi(model.volumetric, context.lanes)},
      geometric_{over_pi(model.geometric, context.lanes)},
      mixture_{LobeShares{.uniform = 0.2}},
      albedo_{context.lanes.count(), [this](Vec3 wi, Vec3 wo) { return eval(wi, wo); }} {
  albedo_.refuse_above(1.0 + 1e-3, context.lanes, "ross_li");  // 1e-3: the quadrature
}

Spectrum BoundRossLi::eval(Vec3 wi, Vec3 wo) const noexcept {
  if (!(wi.z * wo.z > 0.0)) return Spectrum{isotropic_.count()};
  const HeldAngles angles{wi, wo};
  Spectrum f = isotropic_;
  f.add_scaled(volumetric_, static_cast<float>(ross_thick(angles)));
  f.add_scaled(geometric_, static_cast<float>(li_sparse_reciprocal(angles)));
  for (int lane = 0; lane < f.count(); ++lane) f[lane] = std::max(f[lane], 0.0F);
  return f;
}

double BoundRossLi::pdf(Vec3 wi, Vec3 wo) const noexcept { return pdf_by(mixture_, wi, wo); }

std::optional<ScatteringSample> BoundRossLi::sample(Vec3 wo,
                                                    const ScatteringDraw& u) const noexcept {
  return draw_by(mixture_, *this, wo, u);
}

Albedo BoundRossLi::albedo(Vec3 wo) const noexcept { return albedo_.at(wo.z); }

}  // namespace nadir::materials
