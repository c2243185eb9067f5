#pragma once

#include "core/quantity.hpp"
#include "spectral/curve.hpp"

namespace nadir::radiometry {

/// Spectral flux of a lamp of 1 lm whose spectrum is that of a black body, W um^-1: s B(lambda, T)
/// with s so that 683 lm/W int V s B dlambda = 1 lm. Tabulated from 0.2 to 20 um; between its knots
/// within 1e-4 of Planck's law (relative).
/// @param temperature  colour temperature, 1000 to 25000 K
[[nodiscard]] spectral::Curve flux_of_one_lumen(Kelvin temperature);

}  // namespace nadir::radiometry
