#pragma once

#include <cstddef>
#include <vector>

#include "sim/run/strip_renderer.hpp"

namespace nadir::sim {

/// How far a pixel is from its goal: the largest of its bands' errors over what each may have.
[[nodiscard]] std::vector<double> errors_over_goals(const ArrayImage& image,
                                                    const std::vector<BandGoal>& goals);

/// Samples a replicate that bring all pixels to one common error over their goals, with so many
/// paths in all. A pixel of error e after N paths needs N (e / common)^2 of them.
///
/// The common error is found by bisection. Pixels that are there already get none; none gets more
/// than `most` samples a replicate.
struct PathBudget {
  double paths = 0.0;  ///< in all
  int replicates = 16;
  int most = 16384;
  double least_error = 0.0;  ///< no pixel is brought below this
};
[[nodiscard]] std::vector<int> samples_for_budget(const ArrayImage& image,
                                                  const std::vector<double>& errors,
                                                  const PathBudget& budget);

/// Renders a strip until a moment: one round of the least samples, then rounds that spend what time
/// is left where errors are largest.
/// @param end     of this strip
/// @param rounds  told the number of the first round that nobody has sampled yet
[[nodiscard]] ArrayImage render_until(StripRenderer& strip, const ArrayJob& job,
                                      const RenderOptions& options, TimeGoal::Clock::time_point end,
                                      std::uint32_t& rounds);

}  // namespace nadir::sim
