#include "materials/scattering/lambertian.hpp"

#include <numbers>

#include "materials/scattering/cosine_lobe.hpp"

namespace nadir::materials {

using spectral::Spectrum;

BoundLambertian::BoundLambertian(const Lambertian& /*model*/, const BindContext& context)
    : reflectance_{context.reflectance},
      over_pi_{context.reflectance * std::numbers::inv_pi_v<float>} {}

Spectrum BoundLambertian::eval(Vec3 wi, Vec3 wo) const noexcept {
  return on_one_side(wi, wo) ? over_pi_ : Spectrum{over_pi_.count()};
}

double BoundLambertian::pdf(Vec3 wi, Vec3 wo) const noexcept {
  return on_one_side(wi, wo) ? cosine_pdf(wi) : 0.0;
}

std::optional<ScatteringSample> BoundLambertian::sample(Vec3 wo,
                                                        const ScatteringDraw& u) const noexcept {
  if (wo.z == 0.0) return std::nullopt;
  const Vec3 wi = draw_cosine(u.point, wo.z);
  return ScatteringSample{wi, cosine_pdf(wi), false, reflectance_};
}

Albedo BoundLambertian::albedo(Vec3 /*wo*/) const noexcept {
  return {reflectance_, Spectrum{reflectance_.count()}};
}

}  // namespace nadir::materials
