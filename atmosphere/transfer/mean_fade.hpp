#pragma once

#include <cmath>

namespace nadir::atmosphere {

/// int_0^1 exp(-x s) ds = (1 - exp(-x)) / x, with its limit 1 at 0; x of either sign.
[[nodiscard]] inline double mean_fade(double x) noexcept {
  return std::abs(x) < 1e-9 ? 1.0 - 0.5 * x : -std::expm1(-x) / x;
}

}  // namespace nadir::atmosphere
