#pragma once

#include "core/diagnostics.hpp"
#include "spectral/lanes.hpp"

namespace nadir::materials {

/// What the material hands to a scattering model that is taken to the lanes: the wavelengths and
/// the material's own reflectance and transmittance there (Kirchhoff's law applied where only the
/// emissivity is known). Models that bring spectra of their own ignore the latter two.
struct BindContext {
  const spectral::Lanes& lanes;
  const spectral::Spectrum& reflectance;
  const spectral::Spectrum& transmittance;
  Diagnostics* diagnostics = nullptr;  ///< gets extrapolated curves; null: nobody is told
};

}  // namespace nadir::materials
