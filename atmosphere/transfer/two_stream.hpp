#pragma once

#include <vector>

#include "atmosphere/transfer/scaled_column.hpp"
#include "atmosphere/transfer/scattered_source.hpp"

namespace nadir::atmosphere {

/// The fast solution: irradiances F by two streams, from which the source in any direction is
///
///     J(mu) = 1/pi sum over kinds omega_k [F_along (1 - beta_k(mu)) + F_against beta_k(mu)]
///
/// with F_along the irradiance of the hemisphere that light in direction mu travels into and beta
/// the share of it that a kind scatters into the other one. Beams by the hybrid of the Eddington
/// and delta-function approximations, all else by quadrature. One azimuth mode.
/// Source: Meador & Weaver, J. Atmos. Sci. 37, 630 (1980), table 1 (modified delta, quadrature);
/// Isaacs, Wang, Worsham & Goldenberg, Appl. Opt. 26, 1272 (1987).
///
/// @param column  scaled for 2 streams
/// @throws InputError for a problem whose sizes are not those of the column
[[nodiscard]] TransferSolution two_stream(const ScaledColumn& column,
                                          const TransferProblem& problem,
                                          const std::vector<double>& mu);

/// Share of light that comes in at a cosine which a kind of scatterer, its forward peak left out,
/// sends back into the hemisphere it came from:
///
///     beta(mu) = (1/2 - 1/2 sum over odd l (2 l + 1) chi_l p_l(mu) int_0^1 p_l) / (1 - peak)
///
/// Near the horizon the true forward peak is spread over both hemispheres, and taking it out of one
/// of them would leave more than half going back: there it is half.
/// Source: Wiscombe & Grams, J. Atmos. Sci. 33, 2440 (1976).
[[nodiscard]] double backscatter(const PhaseFunction& phase, double peak, double mu);

}  // namespace nadir::atmosphere
