#pragma once

#include <vector>

#include "atmosphere/transfer/mode_solver.hpp"
#include "atmosphere/transfer/scaled_column.hpp"
#include "atmosphere/transfer/scattered_source.hpp"

namespace nadir::atmosphere {

/// The layers of a column with their kinds mixed.
/// @param degrees  how many Legendre coefficients are kept
[[nodiscard]] std::vector<LayerOptics> layer_optics(const ScaledColumn& scaled, int degrees);

/// How a beam's strength runs through the layers.
[[nodiscard]] std::vector<SourceProfile> beam_profiles(const BeamIn& beam,
                                                       const std::vector<LayerOptics>& layers);

/// How Planck radiance runs through the layers.
[[nodiscard]] std::vector<SourceProfile> planck_profiles(const std::vector<double>& planck);

/// Sizes agree, cosines lie in -1 to 1.
/// @throws InputError that says what does not
void check(const ScaledColumn& scaled, const TransferProblem& problem,
           const std::vector<double>& mu);

}  // namespace nadir::atmosphere
