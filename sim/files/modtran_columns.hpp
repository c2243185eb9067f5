#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sim/files/air_runs.hpp"
#include "sim/files/text_tokens.hpp"

// The columns that MODTRAN writes, whatever the file about them.

namespace nadir::sim {

/// Of a run's spectrum. Meanings: D. Griffith, "Meaning of MODTRAN tape7 outputs" (wiki of
/// matlab-modtran-5, after Ontar's support pages); MODTRAN 6 names its columns anew and splits them
/// otherwise: THRML_EM and THRML_SCT, MULT_SCAT and SING_SCAT add up there, while PTH_THRML
/// contains THRML_SCT and SOL_SCAT contains SING_SCAT before.
enum class ModtranColumn {
  frequency,      ///< FREQ, cm^-1
  transmittance,  ///< TOT_TRANS, TRANS, COMBIN
  path_thermal,   ///< PTH_THRML: all that the air emits, scattered or not
  emitted,        ///< THRML_EM of MODTRAN 6: without what is scattered
  thermal_scattered,
  surface,         ///< SURF_EMIS
  solar_all,       ///< SOL_SCAT: scattered once and more often
  solar_multiple,  ///< MULT_SCAT of MODTRAN 6: without what is scattered once
  solar_single,
  ground,       ///< GRND_RFLT
  total,        ///< TOTAL_RAD
  sun_to_eye,   ///< REF_SOL: the sun's irradiance times T(sun to end of way) T(way)
  sun_at_eye,   ///< SOL@OBS, SOL_TR
  sun_outside,  ///< TOA_SUN, SOLAR
  other         ///< known, and not needed
};

/// By the name in a file's head; upper and lower case, blanks and underscores count alike.
[[nodiscard]] std::optional<ModtranColumn> modtran_column(std::string_view name);

/// One run: the columns and their rows, in the file's order. NaN where a cell is blank.
struct ModtranSpectrum {
  std::string name;
  std::vector<ModtranColumn> columns;
  std::vector<std::vector<double>> rows;
};

/// The run's spectra per um. Radiance and irradiance are taken as per cm^-1 and cm^2, as in
/// tape7: W cm^-2 sr^-1 / cm^-1 times nu^2 is W m^-2 sr^-1 um^-1 (1e4 cm^2 per m^2, and
/// |d nu / d lambda| = nu^2 / 1e4 cm^-1 per um).
///
/// A run whose columns say nothing of radiance but of the sun gives only the sun's spectra: its
/// zenith angle is the sun's. Elsewhere SOL@OBS tells the sun's transmittance where the eye is on
/// the ground, REF_SOL roughly where the way ends there.
/// @throws InputError  columns missing; parts that do not add up to the total radiance;
///                     wavenumbers that neither ascend nor descend; transmittances beyond 1
[[nodiscard]] AirRunSet run_of_modtran(const ModtranSpectrum& spectrum, const RunGeometry& geometry,
                                       const AirRunSettings& settings);

}  // namespace nadir::sim
