#pragma once

#include "core/vec.hpp"

namespace nadir::materials {

/// A direction drawn by a scattering model.
struct ScatteringSample {
  Vec3 wi;              ///< unit vector away from the surface, local frame
  double pdf = 0.0;     ///< solid-angle density, sr^-1
  double weight = 0.0;  ///< eval cos / pdf, dimensionless
};

}  // namespace nadir::materials
