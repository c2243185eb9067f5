#pragma once

#include <vector>

#include "atmosphere/transfer/scaled_column.hpp"
#include "atmosphere/transfer/scattered_source.hpp"

namespace nadir::atmosphere {

/// The discrete-ordinate solution of radiative transfer in a plane-parallel column: for each
/// azimuth mode one solution for all sources at once (mode_solver.hpp). The direct beam follows the
/// transmittances given, exponentially within a layer, so that it may come along a spherical path,
/// also from below the horizon; a layer on the edge of the earth's shadow is lit linearly. Planck
/// radiance runs linearly in optical depth within a layer.
///
/// A beam's azimuth modes end when two in a row stay below 1e-5 of the mean over azimuth at every
/// place, at the latest with mode streams - 1.
///
/// Source: Chandrasekhar, "Radiative Transfer" (1950); Stamnes, Tsay, Wiscombe & Jayaweera, Appl.
/// Opt. 27, 2502 (1988); delta-M: Wiscombe, J. Atmos. Sci. 34, 1408 (1977); pseudo-spherical beam:
/// Dahlback & Stamnes, Planet. Space Sci. 39, 671 (1991).
///
/// @param streams  even, 2 to 128; the column must have been scaled for as many
/// @param mu       directions at which the source is wanted, see ScatteredSource
/// @throws InputError for other streams, or a problem whose sizes are not those of the column
[[nodiscard]] TransferSolution discrete_ordinates(const ScaledColumn& column,
                                                  const TransferProblem& problem, int streams,
                                                  const std::vector<double>& mu);

}  // namespace nadir::atmosphere
