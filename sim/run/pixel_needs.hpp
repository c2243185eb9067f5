#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "sim/run/image.hpp"
#include "sim/run/sampling_goal.hpp"
#include "spectral/band_quadrature.hpp"

namespace nadir::sim {

/// Paths that a pixel needs to meet the goals of all bands, by the error s that is stated after N
/// paths:
///
///     need = N max over bands (s / goal)^2
///
/// as the variance of a mean falls with 1/N. A band whose goal is 0 or whose error is no number
/// asks for nothing.
[[nodiscard]] double paths_needed(const ArrayImage& image, std::size_t pixel,
                                  const std::vector<BandGoal>& goals);

/// The mean over all pixels, of each no more than the most that it would be given.
[[nodiscard]] double mean_need(const ArrayImage& image, const std::vector<BandGoal>& goals,
                               double most_paths);

struct PixelNeed {
  double paths = 0.0;
  std::span<const spectral::BandQuadrature> quadratures{};  ///< for brightness temperatures
};
/// States the errors of a pixel no smaller than those of one with this need: goal sqrt(need / N) in
/// every band.
void state_need(ArrayImage& image, std::size_t pixel, const std::vector<BandGoal>& goals,
                const PixelNeed& stated_need);

/// States no pixel's error smaller than that of one which needs half of what the pixels of its
/// block of 8 x 8 need on average: a pixel whose replicates happen to agree is not done before its
/// neighbours are nearly so. Pixels without paths stay as they are.
void state_needs_of_blocks(ArrayImage& image, const std::vector<BandGoal>& goals,
                           std::span<const spectral::BandQuadrature> quadratures);

}  // namespace nadir::sim
