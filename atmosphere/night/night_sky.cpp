#include "atmosphere/night/night_sky.hpp"

#include <algorithm>
#include <cmath>

namespace nadir::atmosphere {

double van_rhijn(double cos_zenith) noexcept {
  const double sine_squared = 1.0 - std::min(cos_zenith * cos_zenith, 1.0);
  return 1.0 / std::sqrt(1.0 - 0.96 * sine_squared);
}

double urban_glow_shape(double cos_zenith) noexcept {
  constexpr double depth = 0.4;  // see the header
  // below about 0.1 degree the exponential is 0 to rounding: the horizon's own value
  const double cosine = std::clamp(cos_zenith, 1e-3, 1.0);
  return std::expm1(-depth / cosine) / std::expm1(-depth);
}

}  // namespace nadir::atmosphere
