#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/quantity.hpp"
#include "sensor/camera/detector_array.hpp"
#include "sensor/detector/signal_chain.hpp"
#include "sensor/optics/system_mtf.hpp"

namespace nadir::sensor {

/// The figures that a data sheet gives of a band.
struct BandFigures {
  std::string array, band;
  double centre_um = 0.0, fwhm_um = 0.0;
  double gsd_x_m = 0.0, gsd_y_m = 0.0;  ///< at the nominal distance, in the middle of the image
  double swath_m = 0.0;
  std::optional<double> reference_radiance, snr, nedl;  ///< SNR and NEdL at the reference radiance
  std::optional<double> nedt_k;                         ///< at 300 K, for bands centred beyond 3 um
  std::optional<double> saturation;                     ///< radiance
  double mtf_nyquist_x = 0.0, mtf_nyquist_y = 0.0;
};

/// Noise-equivalent temperature difference: NEdL / (dL_band / dT) at a scene temperature.
/// @param band  its quadrature   @param nedl  at the radiance of that temperature
[[nodiscard]] Kelvin nedt(const spectral::Response& band, double nedl, Kelvin scene);

}  // namespace nadir::sensor
