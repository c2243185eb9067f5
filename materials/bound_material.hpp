#pragma once

#include "core/diagnostics.hpp"
#include "materials/material.hpp"
#include "spectral/lanes.hpp"

namespace nadir::materials {

/// A material at the wavelengths of one block of lanes: what rays look up.
struct BoundMaterial {
  spectral::Spectrum reflectance;  ///< directional-hemispherical, per lane, in [0, 1]
  spectral::Spectrum emissivity;   ///< per lane, in [0, 1]
  float max_reflectance = 0.0F;    ///< over the lanes
  Scattering scattering;
};

/// Takes the material's curves to the lanes, Kirchhoff's law filling what is missing. Wavelengths
/// outside a curve that holds its end values are reported to `diagnostics`.
/// @throws InputError where neither curve is given, or one that must cover the lanes does not.
[[nodiscard]] BoundMaterial bind(const Material& material, const spectral::Lanes& lanes,
                                 Diagnostics& diagnostics);

}  // namespace nadir::materials
