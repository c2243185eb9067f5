#pragma once

#include "core/statistics.hpp"
#include "spectral/band_quadrature.hpp"

namespace nadir::sim {

/// The brightness temperature of a band's radiance with the standard error of that, K, carried
/// through Planck's law to first order.
[[nodiscard]] Estimate brightness_temperature(const spectral::BandQuadrature& quadrature,
                                              const Estimate& radiance);

}  // namespace nadir::sim
