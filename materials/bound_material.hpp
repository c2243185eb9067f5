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

/// Takes the material's curves to the lanes. Kirchhoff's law for an opaque surface, emissivity =
/// 1 - reflectance, gives what is missing: a curve that is not there, or that is not tabulated at
/// a lane where the other one is. Where neither is tabulated the first of reflectance and
/// emissivity that is there is extrapolated as its `Outside` says.
///
/// `diagnostics` gets one message if a curve had to be extrapolated, and one if
/// reflectance + emissivity exceeds 1, which no passive surface can do.
///
/// @throws InputError with every mistake found: neither curve is given, a value is outside [0, 1],
///         or a curve that must cover the lanes (`Outside::reject`) does not.
[[nodiscard]] BoundMaterial bind(const Material& material, const spectral::Lanes& lanes,
                                 Diagnostics& diagnostics);

}  // namespace nadir::materials
