#include "materials/scattering/mirror.hpp"

#include "materials/scattering/fresnel.hpp"

namespace nadir::materials {

using spectral::Spectrum;

BoundMirror::BoundMirror(const Mirror& model, const BindContext& context)
    : reflectance_{context.reflectance},
      n_{context.lanes.count(), 1.0F},
      k_{context.lanes.count()},
      fresnel_{model.n.has_value()} {
  if (model.n) n_ = model.n->at(context.lanes);
  if (model.k) k_ = model.k->at(context.lanes);
}

Spectrum BoundMirror::reflectance(double mu) const noexcept {
  return fresnel_ ? fresnel_reflectance(mu, n_, k_) : reflectance_;
}

Spectrum BoundMirror::eval(Vec3 /*wi*/, Vec3 /*wo*/) const noexcept {
  return Spectrum{reflectance_.count()};
}

double BoundMirror::pdf(Vec3 /*wi*/, Vec3 /*wo*/) const noexcept { return 0.0; }

std::optional<ScatteringSample> BoundMirror::sample(Vec3 wo,
                                                    const ScatteringDraw& /*u*/) const noexcept {
  if (wo.z == 0.0) return std::nullopt;
  return ScatteringSample{{-wo.x, -wo.y, wo.z}, 0.0, true, reflectance(wo.z)};
}

Albedo BoundMirror::albedo(Vec3 wo) const noexcept {
  return {reflectance(wo.z), Spectrum{reflectance_.count()}};
}

}  // namespace nadir::materials
