#pragma once

#include <optional>

#include "materials/scattering/bind_context.hpp"
#include "materials/scattering/models.hpp"
#include "materials/scattering/sample.hpp"

namespace nadir::materials {

/// Bi-Lambertian leaf: both faces are diffuse alike. With the material's reflectance rho and
/// transmittance tau, rho + tau <= 1,
///
///     f = rho / pi   light and view on the same side
///     f = tau / pi   on opposite sides
///
/// Reciprocal; albedo rho and tau for every direction.
/// Source: J. Ross, The Radiation Regime and Architecture of Plant Stands (1981), II.3; the form
/// used by RAMI: Pinty et al., J. Geophys. Res. 106, 11937 (2001), doi:10.1029/2000JD900493.
class BoundLeaf {
 public:
  BoundLeaf(const Leaf& model, const BindContext& context);

  [[nodiscard]] spectral::Spectrum eval(Vec3 wi, Vec3 wo) const noexcept;
  [[nodiscard]] double pdf(Vec3 wi, Vec3 wo) const noexcept;
  [[nodiscard]] std::optional<ScatteringSample> sample(Vec3 wo,
                                                       const ScatteringDraw& u) const noexcept;
  [[nodiscard]] Albedo albedo(Vec3 wo) const noexcept;
  [[nodiscard]] ScatteringTraits traits() const noexcept { return {.transmits = transmits_}; }

 private:
  spectral::Spectrum reflectance_, transmittance_;
  double reflect_chance_ = 1.0;  // share of the lane-averaged reflectance in rho + tau
  bool transmits_ = false, dark_ = false;
};

}  // namespace nadir::materials
