#pragma once

#include "core/quantity.hpp"
#include "spectral/curve.hpp"

namespace nadir::spectral {

/// Luminous efficacy of radiation at its peak, lm W^-1: K_cd of the SI's candela. (K_m at 555 nm in
/// air is 683.002; the difference, 3e-6, is below the table's.)
inline constexpr double luminous_efficacy_lm_per_w = 683.0;

/// Spectral luminous efficiency V of the eye by day (photopic, CIE 1924), 1 at its peak; 0 outside
/// 0.38 to 0.78 um in air. Linear between the table's 5 nm, its wavelengths taken to vacuum.
/// Source: CIE 018:2019, The Basis of Physical Photometry, table 1; also CIE S 010 / ISO
/// 23539:2005.
[[nodiscard]] double luminous_efficiency(Micrometres wavelength) noexcept;

/// Photometric quantity of a spectral one: 683 lm/W int V(lambda) c(lambda) dlambda. W um^-1 gives
/// lm, radiance cd m^-2. Exact for the lines of both tables. NaN if the curve does not cover the
/// visible.
[[nodiscard]] double luminous(const Curve& curve);

}  // namespace nadir::spectral
