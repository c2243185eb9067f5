#pragma once

#include "core/diagnostics.hpp"
#include "materials/material.hpp"
#include "materials/scattering/bound_scattering.hpp"
#include "spectral/lanes.hpp"

namespace nadir::materials {

/// A material at the wavelengths of one block of lanes: what rays look up.
class BoundMaterial {
 public:
  BoundScattering scattering;
  ScatteringTraits traits;
  /// Emissivity where the material states it itself or where it does not depend on direction; at
  /// lanes where it follows direction its value for a view along the normal. See `emissivity`.
  spectral::Spectrum own_emissivity;
  spectral::Spectrum follows_direction;  ///< 1 where emissivity is 1 - albedo(wo), else 0
  bool constant_emissivity = true;       ///< own_emissivity holds for all lanes and directions

  /// Directional emissivity per lane, in [0, 1]. Kirchhoff: 1 - rho(wo) - tau(wo) unless stated.
  [[nodiscard]] spectral::Spectrum emissivity(Vec3 wo) const noexcept;
};

/// Takes the material's curves and its scattering model to the lanes.
///
/// Reflectance and emissivity: what is missing, or is not tabulated at a lane where the other one
/// is, follows from Kirchhoff's law eps = 1 - rho - tau. Where neither is tabulated the first of
/// reflectance and emissivity that is there is extrapolated as its `Outside` says. At lanes where
/// only one of the two is given (or the model brings its own spectra) the emissivity follows
/// direction: 1 - albedo(wo); where both are given the stated one holds at all angles. For models
/// whose albedo is the same from everywhere (Lambertian, leaf, mirror and sheet without refractive
/// index) that is one number per lane, found here. For Ward and Priest-Germer the reflectance is
/// the diffuse base: 1 - albedo(wo) counts their gloss as well.
///
/// `diagnostics` gets one message for each curve that had to be extrapolated, and one if
/// reflectance + transmittance + emissivity exceeds 1, which no passive surface can do.
///
/// @throws InputError located at the material, with every mistake found: a scaled model without
///         reflectance and emissivity, an unscaled one with them (models.hpp, `curves_taken`), a
///         value outside [0, 1], reflectance + transmittance above 1, transmittance for a model
///         that has none, a curve that must cover the lanes (`Outside::reject`) and does not,
///         whatever the model refuses
[[nodiscard]] BoundMaterial bind(const Material& material, const spectral::Lanes& lanes,
                                 Diagnostics& diagnostics);

}  // namespace nadir::materials
