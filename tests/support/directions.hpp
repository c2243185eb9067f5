#pragma once

#include <numbers>

#include "core/random.hpp"
#include "core/vec.hpp"
#include "support/quadrature.hpp"

namespace nadir::support {

/// A direction of the upper hemisphere, uniform in solid angle.
[[nodiscard]] inline Vec3 random_direction(Rng& rng) {
  const double mu = rng.next();
  return direction(mu, 2.0 * std::numbers::pi * rng.next());
}

/// A direction of the whole sphere, uniform in solid angle.
[[nodiscard]] inline Vec3 random_on_sphere(Rng& rng) {
  const double mu = 2.0 * rng.next() - 1.0;
  return direction(mu, 2.0 * std::numbers::pi * rng.next());
}

}  // namespace nadir::support
