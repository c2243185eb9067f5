#include "materials/scattering/rahman_pinty_verstraete.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "materials/scattering/held_angles.hpp"

namespace nadir::materials {
namespace {

using spectral::Lanes;
using spectral::Spectrum;

bool same_at_all(const Spectrum& a) {
  for (int lane = 1; lane < a.count(); ++lane) {
    if (a[lane] != a[0]) return false;
  }
  return true;
}

/// F varies as ((1 + |Theta|) / (1 - |Theta|))^3; a share |Theta| of its own lobe keeps the weights
/// level. Uniform directions serve the bowl's rim.
LobeShares shares(double asymmetry) {
  LobeShares s;
  s.b = std::abs(asymmetry);
  (asymmetry < 0.0 ? s.backward : s.forward) = s.b > 0.02 ? std::min(0.7, s.b) : 0.0;
  s.uniform = 0.3 * (1.0 - s.backward - s.forward);
  return s;
}

}  // namespace

BoundRahmanPintyVerstraete::Terms BoundRahmanPintyVerstraete::terms_at(
    const RahmanPintyVerstraete& model, const Lanes& lanes) {
  const Spectrum rho0 = model.rho0.at(lanes), k = model.k.at(lanes);
  const Spectrum theta = model.asymmetry.at(lanes);
  const Spectrum rho_c = model.rho_c ? model.rho_c->at(lanes) : rho0;
  const Spectrum zero{lanes.count()};
  Terms t{zero,
          zero,
          zero,
          zero,
          zero,
          zero,
          same_at_all(k),
          same_at_all(theta),
          static_cast<double>(theta.mean())};
  for (int lane = 0; lane < lanes.count(); ++lane) {
    const float b = std::abs(theta[lane]);
    t.amplitude[lane] =
        rho0[lane] * (1.0F - b) * (1.0F + b) * static_cast<float>(std::numbers::inv_pi);
    t.exponent[lane] = k[lane] - 1.0F;
    t.lobe_base[lane] = (1.0F - b) * (1.0F - b);
    t.forward[lane] = std::max(0.0F, 2.0F * theta[lane]);
    t.backward[lane] = std::max(0.0F, -2.0F * theta[lane]);
    // rho0 may exceed 1 where k > 1; the hot spot must not become a dark one with it
    t.hot_spot[lane] = std::max(0.0F, 1.0F - rho_c[lane]);
  }
  return t;
}

BoundRahmanPintyVerstraete::BoundRahmanPintyVerstraete(const RahmanPintyVerstraete& model,
                                                       const BindContext& context)
    : terms_{terms_at(model, context.lanes)},
      mixture_{shares(terms_.mean_asymmetry)},
      albedo_{context.lanes.count(), [this](Vec3 wi, Vec3 wo) { return eval(wi, wo); }} {
  albedo_.refuse_above(1.0 + 1e-3, context.lanes,
                       "rahman_pinty_verstraete");  // 1e-3: the quadrature
}

void BoundRahmanPintyVerstraete::multiply_bowl(Spectrum& f, float log_cosines) const noexcept {
  if (terms_.same_exponent) {
    f *= std::exp(terms_.exponent[0] * log_cosines);
    return;
  }
  for (int lane = 0; lane < f.count(); ++lane) {
    f[lane] *= std::exp(terms_.exponent[lane] * log_cosines);
  }
}

// 1 + Theta^2 + 2 Theta cos(g) as a sum of squares: no cancellation for |Theta| near 1.
void BoundRahmanPintyVerstraete::multiply_lobe(Spectrum& f, double cos_phase) const noexcept {
  const auto plus = static_cast<float>(1.0 + cos_phase);
  const auto minus = static_cast<float>(1.0 - cos_phase);
  const auto d = [&](int lane) {
    return terms_.lobe_base[lane] + terms_.forward[lane] * plus + terms_.backward[lane] * minus;
  };
  if (terms_.same_asymmetry) {
    f *= 1.0F / (d(0) * std::sqrt(d(0)));
    return;
  }
  for (int lane = 0; lane < f.count(); ++lane) f[lane] /= d(lane) * std::sqrt(d(lane));
}

Spectrum BoundRahmanPintyVerstraete::eval(Vec3 wi, Vec3 wo) const noexcept {
  if (!(wi.z * wo.z > 0.0)) return Spectrum{terms_.amplitude.count()};
  const HeldAngles angles{wi, wo};
  const double log_cosines = std::log(angles.mu_i * angles.mu_o * (angles.mu_i + angles.mu_o));
  const auto nearness = static_cast<float>(1.0 / (1.0 + angles.shadow_distance()));
  Spectrum f = terms_.amplitude;
  multiply_bowl(f, static_cast<float>(log_cosines));
  multiply_lobe(f, angles.cos_phase());
  for (int lane = 0; lane < f.count(); ++lane) {
    f[lane] *= 1.0F + terms_.hot_spot[lane] * nearness;
  }
  return f;
}

double BoundRahmanPintyVerstraete::pdf(Vec3 wi, Vec3 wo) const noexcept {
  return pdf_by(mixture_, wi, wo);
}

std::optional<ScatteringSample> BoundRahmanPintyVerstraete::sample(
    Vec3 wo, const ScatteringDraw& u) const noexcept {
  return draw_by(mixture_, *this, wo, u);
}

Albedo BoundRahmanPintyVerstraete::albedo(Vec3 wo) const noexcept { return albedo_.at(wo.z); }

}  // namespace nadir::materials
