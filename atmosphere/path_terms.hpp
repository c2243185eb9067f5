#pragma once

#include "spectral/lanes.hpp"

namespace nadir::atmosphere {

/// What a path through the air does to the radiance L at its far end: transmittance * L + path.
struct PathTerms {
  spectral::Spectrum transmittance;
  spectral::Spectrum radiance;
};

}  // namespace nadir::atmosphere
