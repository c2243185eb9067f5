#include "materials/scattering/leaf.hpp"

#include <numbers>

#include "materials/scattering/cosine_lobe.hpp"

namespace nadir::materials {

using spectral::Spectrum;

BoundLeaf::BoundLeaf(const Leaf& /*model*/, const BindContext& context)
    : reflectance_{context.reflectance}, transmittance_{context.transmittance} {
  const auto rho = static_cast<double>(reflectance_.mean());
  const auto tau = static_cast<double>(transmittance_.mean());
  transmits_ = tau > 0.0;
  dark_ = rho + tau <= 0.0;
  if (!dark_) reflect_chance_ = rho / (rho + tau);
}

Spectrum BoundLeaf::eval(Vec3 wi, Vec3 wo) const noexcept {
  const double sides = wi.z * wo.z;
  if (sides == 0.0) return Spectrum{reflectance_.count()};
  return (sides > 0.0 ? reflectance_ : transmittance_) * std::numbers::inv_pi_v<float>;
}

double BoundLeaf::pdf(Vec3 wi, Vec3 wo) const noexcept {
  const double sides = wi.z * wo.z;
  if (sides == 0.0 || dark_) return 0.0;
  return (sides > 0.0 ? reflect_chance_ : 1.0 - reflect_chance_) * cosine_pdf(wi);
}

std::optional<ScatteringSample> BoundLeaf::sample(Vec3 wo, const ScatteringDraw& u) const noexcept {
  if (wo.z == 0.0 || dark_) return std::nullopt;
  const bool reflects = u.choice < reflect_chance_;
  const double chance = reflects ? reflect_chance_ : 1.0 - reflect_chance_;
  const Vec3 wi = draw_cosine(u.point, reflects ? wo.z : -wo.z);
  return ScatteringSample{
      wi, chance * cosine_pdf(wi), false,
      (reflects ? reflectance_ : transmittance_) * static_cast<float>(1.0 / chance)};
}

Albedo BoundLeaf::albedo(Vec3 /*wo*/) const noexcept { return {reflectance_, transmittance_}; }

}  // namespace nadir::materials
