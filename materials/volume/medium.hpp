#pragma once

#include <variant>
#include <vector>

#include "spectral/curve.hpp"

// What a participating volume is made of, as a scenario describes it: plain data.

namespace nadir::materials {

/// Henyey & Greenstein, Astrophys. J. 93, 70 (1941).
struct HenyeyGreenstein {
  spectral::Curve g = spectral::Curve::constant(0.0);  ///< mean cosine, (-1, 1)
};
struct RayleighPhase {};
/// Phase function over scattering angle and wavelength, any positive scale: it is normalised.
struct TabulatedPhase {
  std::vector<double> angle_rad;      ///< ascending, 0 to pi
  std::vector<double> wavelength_um;  ///< ascending; one entry holds everywhere
  std::vector<double> value;          ///< angle fastest
};
using PhaseFunction = std::variant<HenyeyGreenstein, RayleighPhase, TabulatedPhase>;

/// Coefficients at density 1.
struct Medium {
  spectral::Curve absorption = spectral::Curve::constant(0.0);  ///< 1/m, >= 0
  spectral::Curve scattering = spectral::Curve::constant(0.0);  ///< 1/m, >= 0
  PhaseFunction phase = HenyeyGreenstein{};
};

}  // namespace nadir::materials
