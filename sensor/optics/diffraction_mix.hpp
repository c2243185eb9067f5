#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "sensor/optics/annular_aperture.hpp"
#include "sensor/optics/point_spread.hpp"
#include "sensor/optics/wavelength_quantiles.hpp"

namespace nadir::sensor {

/// Diffraction in each band of an array, whose wavelengths the band's response weights.
class DiffractionMix {
 public:
  DiffractionMix(const DiffractionSpread& lens, std::vector<WavelengthQuantiles> bands);

  /// A distance drawn from the mean of the bands' functions, m.
  /// @param which  decides the band and its wavelength   @param share  of the light within it
  [[nodiscard]] double distance(double which, double share) const noexcept;
  /// Ratio of each band's function to the mean one at a distance. @param by_band  one a band
  void weights(double distance_m, std::span<double> by_band) const noexcept;
  [[nodiscard]] double mtf(std::size_t band, double frequency_per_m) const noexcept;

 private:
  /// Share of a band's light per unit area.
  [[nodiscard]] double density(const WavelengthQuantiles& band, double distance_m) const;

  AnnularAperture aperture_;
  double f_number_;
  std::vector<WavelengthQuantiles> bands_;
  double step_m_ = 0.0;           // of the densities
  std::vector<float> densities_;  // by step, then by band; only for several bands
};

}  // namespace nadir::sensor
