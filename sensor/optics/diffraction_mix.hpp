#pragma once

#include <cstddef>
#include <vector>

#include "core/vec.hpp"
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
  /// Ratio of a band's function to the mean one at a distance.
  [[nodiscard]] double ratio(std::size_t band, double distance_m) const noexcept;
  [[nodiscard]] double mtf(std::size_t band, double frequency_per_m) const noexcept;

 private:
  [[nodiscard]] double tabulated(std::size_t band, double place) const noexcept;
  AnnularAperture aperture_;
  double f_number_;
  std::vector<WavelengthQuantiles> bands_;
  double step_m_ = 0.0;                        // of the densities
  std::vector<std::vector<float>> densities_;  // by band, at even steps; only for several bands
};

}  // namespace nadir::sensor
