#pragma once

#include <vector>

#include "atmosphere/layered.hpp"
#include "spectral/curve.hpp"

namespace nadir::atmosphere {

/// How finely sunlight and the sky's long-wave radiation are integrated over the spectrum.
struct BroadbandSettings {
  int streams = 8;
  double term_tolerance = 2e-3;     ///< of transmittance, see GasAbsorption::terms
  double ground_reflectance = 0.2;  ///< of sunlight: what the ground sends up comes back in part
  std::vector<double> solar_edges_um = default_solar_edges();
  std::vector<double> long_wave_edges_um = default_long_wave_edges();  ///< empty: none is computed
  std::vector<double> cos_zenith = default_cos_zenith();
  double spectrum_cos_zenith = 2.0 / 3.0;  ///< air mass 1.5

  /// 0.28 to 4 um in 36 intervals: windows and bands of the gases apart.
  [[nodiscard]] static std::vector<double> default_solar_edges();
  /// 4 to 200 um in 30 intervals.
  [[nodiscard]] static std::vector<double> default_long_wave_edges();
  /// 0 to 1, closer together towards the horizon.
  [[nodiscard]] static std::vector<double> default_cos_zenith();
};

/// Light of a clear sky (or one covered by the air's clouds) on level ground.
struct ClearSkyFluxes {
  std::vector<double> cos_zenith;               ///< of the sun
  std::vector<double> direct_normal_w_m2;       ///< unscattered, on a plane normal to it
  std::vector<double> diffuse_horizontal_w_m2;  ///< all else of its light, on level ground
  double sky_long_wave_w_m2 = 0.0;              ///< emitted by the air, on level ground
  double air_k = 0.0;                           ///< temperature of the air at the ground
  /// Direct and diffuse sunlight on level ground at spectrum_cos_zenith, W m^-2 um^-1: means over
  /// the solar intervals at their middles, held to the outer edges.
  spectral::Curve spectrum = spectral::Curve::constant(0.0);
  int columns = 0;  ///< that were solved
};

/// Broadband sunlight and long-wave radiation at the ground. Each interval's gases are its sums of
/// exponentials; scattering is that of its middle; the sun's irradiance and Planck's radiance at
/// the levels are integrated over it exactly. Emission beyond the last long-wave edge counts with
/// the last interval. Threaded over intervals (oneTBB); the result does not depend on the number of
/// threads. docs/clear-sky.md compares it with published fluxes.
///
/// @param solar_irradiance  outside the air at 1 au, over all solar intervals   [W m^-2 um^-1]
/// @throws InputError  edges that do not ascend or leave 0.2 to 200 um, a cosine outside 0 to 1,
///                     a reflectance outside 0 to 1, a sun that does not cover the intervals, and
///                     whatever the air refuses
[[nodiscard]] ClearSkyFluxes broadband_fluxes(const Layered& air, const BroadbandSettings& settings,
                                              const spectral::Curve& solar_irradiance);

}  // namespace nadir::atmosphere
