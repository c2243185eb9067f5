#pragma once

#include <optional>

#include "materials/scattering/bind_context.hpp"
#include "materials/scattering/models.hpp"
#include "materials/scattering/sample.hpp"

namespace nadir::materials {

/// Limb darkening or brightening by a power of the cosines:
///
///     f = rho / (2 pi I) h(mu_i) h(mu_o),   h(mu) = max(mu, mu_c)^(k - 1),   I = int_0^1 h(mu) mu
///     dmu
///
/// Domain: k in [0, 3]; 1 is Lambertian, below 1 bright toward the limb. For k >= 1 mu_c = 0: then
/// I = 1 / (k + 1) and this is Minnaert's f = rho (k + 1) / (2 pi) (mu_i mu_o)^(k - 1).
/// For k < 1 his power diverges at grazing and would reflect more than arrives; so h stays constant
/// below mu_c = 0.1 (84.3 degrees from the zenith, beyond what is measured).
///
/// rho is the material's reflectance: directional-hemispherical at normal incidence. Closed form of
/// the albedo: rho h(mu). It exceeds 1 nowhere for k >= 1; for k < 1 binding refuses rho 0.1^(k -
/// 1) > 1. Reciprocal. Sampled exactly: every weight is the albedo. Source: M. Minnaert, "The
/// reciprocity principle in lunar photometry", ApJ 93, 403 (1941), doi:10.1086/144279.
class BoundMinnaert {
 public:
  BoundMinnaert(const Minnaert& model, const BindContext& context);

  [[nodiscard]] spectral::Spectrum eval(Vec3 wi, Vec3 wo) const noexcept;
  [[nodiscard]] double pdf(Vec3 wi, Vec3 wo) const noexcept;
  [[nodiscard]] std::optional<ScatteringSample> sample(Vec3 wo,
                                                       const ScatteringDraw& u) const noexcept;
  [[nodiscard]] Albedo albedo(Vec3 wo) const noexcept;
  [[nodiscard]] ScatteringTraits traits() const noexcept { return {}; }

 private:
  [[nodiscard]] double limb(double mu) const noexcept;  ///< h

  spectral::Spectrum reflectance_;
  double k_ = 1.0;
  double cut_ = 0.0;       // mu_c
  double below_ = 0.0;     // the part of I below the cut
  double integral_ = 0.5;  // I
};

}  // namespace nadir::materials
