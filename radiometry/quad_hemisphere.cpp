#include "radiometry/quad_hemisphere.hpp"

#include <algorithm>
#include <cmath>

namespace nadir::radiometry {

Vec3 QuadHemisphere::direction(int quad, Vec2 u) const noexcept {
  const int ring = quad / phi_samples_, sector = quad % phi_samples_;
  // 1 - u turns [0, 1) into (0, 1], so that no direction lies in the surface itself.
  const double mu = (ring + (1.0 - u.x)) / mu_samples_;
  const double phi = 2.0 * std::numbers::pi * (sector + u.y) / phi_samples_;
  const double sine = std::sqrt(std::max(0.0, 1.0 - mu * mu));
  return {sine * std::cos(phi), sine * std::sin(phi), mu};
}

}  // namespace nadir::radiometry
