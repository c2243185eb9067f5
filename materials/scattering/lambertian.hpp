#pragma once

#include <optional>

#include "materials/scattering/bind_context.hpp"
#include "materials/scattering/models.hpp"
#include "materials/scattering/sample.hpp"

namespace nadir::materials {

/// Perfectly diffuse: f = rho / pi with the material's reflectance rho in [0, 1]. Reciprocal,
/// conserves energy exactly; albedo rho, sample weight rho whatever the direction. Source: J. H.
/// Lambert, Photometria (1760).
class BoundLambertian {
 public:
  BoundLambertian(const Lambertian& model, const BindContext& context);

  [[nodiscard]] spectral::Spectrum eval(Vec3 wi, Vec3 wo) const noexcept;
  [[nodiscard]] double pdf(Vec3 wi, Vec3 wo) const noexcept;
  [[nodiscard]] std::optional<ScatteringSample> sample(Vec3 wo,
                                                       const ScatteringDraw& u) const noexcept;
  [[nodiscard]] Albedo albedo(Vec3 wo) const noexcept;
  [[nodiscard]] ScatteringTraits traits() const noexcept { return {}; }

 private:
  spectral::Spectrum reflectance_, over_pi_;
};

}  // namespace nadir::materials
