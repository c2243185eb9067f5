#pragma once

#include <vector>

#include "core/diagnostics.hpp"
#include "radiometry/effect.hpp"
#include "sim/plan/wavelength_choice.hpp"
#include "sim/run/world.hpp"

namespace nadir::sim {

/// The fewest wavelengths with which every band is integrated to `share`, for the spectra and the
/// air that a loaded scene has; before its air is finished. Warns of bands where 32 do not do.
/// For air from a table whose lanes are split by gases: those that the table was made for.
/// @param effects  that each array simulates
/// @param share    relative error allowed
/// @param floor    W m^-2 sr^-1 um^-1 by array and band: errors of darker pixels count against it;
///                 empty: a tenth of the mean of the scene's materials in full light
[[nodiscard]] WavelengthChoice choose_wavelengths(const World& world,
                                                  const std::vector<radiometry::EffectSet>& effects,
                                                  double share, Diagnostics& diagnostics,
                                                  const ByBand& floor = {});

/// The error that given numbers of wavelengths leave, by array and band.
[[nodiscard]] ByBand wavelength_errors(const World& world,
                                       const std::vector<radiometry::EffectSet>& effects,
                                       const BandNodes& nodes, const ByBand& floor = {});

/// What the pixels of a band may see, without floors.
/// @param world  kept by reference
[[nodiscard]] BandLight band_light(const World& world, radiometry::EffectSet effects,
                                   const spectral::Response& response);

}  // namespace nadir::sim
