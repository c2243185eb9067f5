#pragma once

#include <vector>

namespace nadir::sim {

/// The value below which `fraction` of the values lie, linear between order statistics (type 7 of
/// R. J. Hyndman and Y. Fan, "Sample quantiles in statistical packages", The American Statistician
/// 50, 361 (1996)). Reorders the values, which must be finite; NaN where there are none.
[[nodiscard]] double percentile(std::vector<float>& values, double fraction);

}  // namespace nadir::sim
