#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "spectral/lanes.hpp"

namespace nadir::materials {

/// The phase function of Rayleigh for unpolarised light, without depolarisation, at every lane:
///
///     p = 3 / (16 pi) (1 + cos^2)                                                  [sr^-1]
///
/// Source: Chandrasekhar, Radiative Transfer (1960), section 3, eq. 30.
class BoundRayleigh {
 public:
  explicit BoundRayleigh(int lanes) noexcept : lanes_{lanes} {}

  /// @param x  1 - cosine of the scattering angle, [0, 2]
  [[nodiscard]] spectral::Spectrum eval(double x) const noexcept {
    const double cosine = 1.0 - x;
    const double p = 3.0 / 16.0 * std::numbers::inv_pi * (1.0 + cosine * cosine);
    return spectral::Spectrum{lanes_, static_cast<float>(p)};
  }
  /// The distribution function gives c^3 + 3 c = 2 d with d = 4 u - 2; c = 2 sinh(asinh(d) / 3).
  [[nodiscard]] static double sample(double u) noexcept {
    const double cosine = 2.0 * std::sinh(std::asinh(4.0 * u - 2.0) / 3.0);
    return std::clamp(1.0 - cosine, 0.0, 2.0);
  }

 private:
  int lanes_;
};

}  // namespace nadir::materials
