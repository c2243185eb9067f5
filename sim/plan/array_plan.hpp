#pragma once

#include <vector>

#include "sensor/camera/detector_array.hpp"
#include "spectral/band_quadrature.hpp"

namespace nadir::sim {

/// The wavelengths at which an array's bands are simulated, and the way back to its bands.
struct ArrayPlan {
  std::vector<spectral::BandQuadrature> quadratures;  ///< one a band
  spectral::SpectralPlan lanes;                       ///< their wavelengths, merged into blocks
};

/// @param wavelengths_per_band  nodes of each band's quadrature
[[nodiscard]] ArrayPlan plan_array(const sensor::DetectorArray& array, int wavelengths_per_band);

}  // namespace nadir::sim
