#pragma once
// Private to this folder.

#include <algorithm>
#include <cmath>

#include "core/vec.hpp"

namespace nadir::materials {

/// Unit vector in the axes of a surface: mu is the cosine from the normal, z; azimuth from x, rad.
[[nodiscard]] inline Vec3 local_direction(double mu, double azimuth_rad) {
  const double sine = std::sqrt(std::max(0.0, (1.0 - mu) * (1.0 + mu)));
  return {sine * std::cos(azimuth_rad), sine * std::sin(azimuth_rad), mu};
}

}  // namespace nadir::materials
