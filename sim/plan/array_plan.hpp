#pragma once

#include <cstddef>
#include <vector>

#include "sensor/camera/detector_array.hpp"
#include "sim/scenario/band_nodes.hpp"
#include "spectral/band_quadrature.hpp"

namespace nadir::sim {

/// The wavelengths at which an array's bands are simulated, and the way back to its bands.
struct ArrayPlan {
  std::vector<spectral::BandQuadrature> quadratures;  ///< one a band
  spectral::SpectralPlan lanes;                       ///< their wavelengths, merged into blocks
};

/// @param nodes   of each band's quadrature
/// @param number  of the array, by which `nodes` knows it
[[nodiscard]] ArrayPlan plan_array(const sensor::DetectorArray& array, const BandNodes& nodes,
                                   std::size_t number);

}  // namespace nadir::sim
