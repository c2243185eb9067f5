#pragma once

#include "core/diagnostics.hpp"
#include "materials/material.hpp"
#include "spectral/curve.hpp"

namespace nadir::thermal {

/// What of a material's spectra the heat balance needs.
struct BroadbandOptics {
  double solar_reflectance = 0.0;
  double solar_transmittance = 0.0;
  double solar_absorptance = 0.0;  ///< 1 - reflectance - transmittance
  double emissivity = 0.0;         ///< long-wave
  double solar_covered = 0.0;      ///< share of sunlight at which spectra are known
  double long_wave_covered = 0.0;  ///< share of a black body's radiance at 300 K, likewise
};

/// Directional-hemispherical reflectance and transmittance for light from 45 degrees, weighted with
/// sunlight; emissivity towards 45 degrees (near the hemispherical mean), weighted with Planck at
/// 300 K. Where spectra are not known the mean of the rest stands; so where the material's model
/// refuses its figures. Known nowhere in a range: all 0 there, `covered` too.
/// @param sunlight  spectral irradiance at the ground, any scale; one number: even over 0.28 to 4
/// um
[[nodiscard]] BroadbandOptics broadband_optics(const materials::Material& material,
                                               const spectral::Curve& sunlight);

}  // namespace nadir::thermal
