#pragma once

#include <vector>

#include "sim/plan/camera_plan.hpp"
#include "sim/plan/effect_plan.hpp"

namespace nadir::sim {

/// The fewest wavelengths that integrate every band, by array and band, and the error they leave.
struct WavelengthChoice {
  BandNodes nodes;
  ByBand error;  ///< largest of all the scene's spectra against the dense grid, relative
};

}  // namespace nadir::sim
