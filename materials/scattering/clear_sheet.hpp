#pragma once

#include <optional>

#include "materials/scattering/bind_context.hpp"
#include "materials/scattering/models.hpp"
#include "materials/scattering/sample.hpp"

namespace nadir::materials {

/// A thin clear pane: light is mirrored or goes straight on. The shares are the material's
/// reflectance and transmittance at all angles or, where a refractive index n is given, those of a
/// plate with both its faces, light going to and fro inside added incoherently. Per polarisation,
/// with Fresnel's r at one face and a = exp(-d / cos(theta_t)) for one crossing at normal optical
/// depth d:
///
///     T = (1 - r)^2 a / (1 - r^2 a^2),   R = r (1 + a T)
///
/// R and T are the means over both polarisations (the light inside keeps its own). Without
/// absorption R = 2 r / (1 + r) = 1 - T for each. Domain: n in [0.01, 100] (below 1 total
/// reflection happens), d >= 0 and only with n. The small sideways shift of the light is left out.
/// eval and pdf are 0. Source: Born & Wolf, Principles of Optics, 7th ed. (1999), 1.5 for r;
/// incoherent sum: R. Siegel, J. Howell, Thermal Radiation Heat Transfer, 4th ed. (2002), eq. 18-5
/// and 18-6.
class BoundClearSheet {
 public:
  BoundClearSheet(const ClearSheet& model, const BindContext& context);

  [[nodiscard]] spectral::Spectrum eval(Vec3 wi, Vec3 wo) const noexcept;
  [[nodiscard]] double pdf(Vec3 wi, Vec3 wo) const noexcept;
  [[nodiscard]] std::optional<ScatteringSample> sample(Vec3 wo,
                                                       const ScatteringDraw& u) const noexcept;
  [[nodiscard]] Albedo albedo(Vec3 wo) const noexcept;
  [[nodiscard]] ScatteringTraits traits() const noexcept {
    return {.transmits = true, .has_delta = true, .only_delta = true, .straight = true};
  }

 private:
  spectral::Spectrum reflectance_, transmittance_;  // of the material, where there is no index
  spectral::Spectrum n_, depth_;
  bool plate_ = false;
};

}  // namespace nadir::materials
