#pragma once

#include "core/vec.hpp"
#include "materials/volume/medium.hpp"
#include "spectral/lanes.hpp"

namespace nadir::materials {

/// The phase function of Henyey & Greenstein, with g per lane:
///
///     p = (1 - g^2) / (4 pi (1 + g^2 - 2 g cos)^(3/2))                             [sr^-1]
///
/// Normalised over the sphere; its mean cosine is g. Written with x = 1 - cos, so that nothing
/// cancels at a narrow forward peak: 1 + g^2 - 2 g cos = (1 - g)^2 + 2 g x.
/// Source: Astrophys. J. 93, 70 (1941), doi:10.1086/144246.
class BoundHenyeyGreenstein {
 public:
  /// @throws InputError for g that is not above -1 and below 1, or does not cover the lanes
  BoundHenyeyGreenstein(const HenyeyGreenstein& phase, const spectral::Lanes& lanes);

  /// @param x  1 - cosine of the scattering angle, [0, 2]
  [[nodiscard]] spectral::Spectrum eval(double x) const noexcept;
  /// A number x = 1 - cos, drawn from the mean of the lanes' functions.
  [[nodiscard]] double sample(double choice, double u) const noexcept;

 private:
  [[nodiscard]] float value(int lane, float x) const noexcept;

  spectral::Spectrum g_;
  spectral::Spectrum front_;          // (1 - g^2) / 4 pi
  spectral::Spectrum start_, least_;  // (1 - g)^2, and the least of (1 - g)^2 + 2 g x
  bool grey_ = true;                  // the same g at all lanes
};

}  // namespace nadir::materials
