#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sim/products/promises.hpp"
#include "sim/run/prepare.hpp"
#include "sim/run/render.hpp"

namespace nadir::sim {

/// How a run with a goal came out.
struct GoalResult {
  const RunRequest& request;
  const RenderTally& tally;
  double seconds = 0.0;  ///< wall clock of the whole run
};

/// What was asked for, what came of it, and whether that is what was promised: every pixel's
/// standard error, the systematic error that is stated beside it, the time within 5 %.
[[nodiscard]] GoalReport goal_report(const PreparedRun& run, const GoalResult& result);

/// What was foretold, as it came. @param stages  of the whole run
[[nodiscard]] RunFact run_fact(const RenderTally& tally, const std::vector<StageTime>& stages,
                               double seconds);

/// Warns of surfaces that are far brighter than anything in the picture: light from them that fewer
/// than one path in some thousand meets is in no error that sampling states.
void warn_of_hidden_light(const PreparedRun& run, const std::vector<ArraySummary>& images,
                          Diagnostics& diagnostics);

/// What was promised and not kept, one sentence each.
[[nodiscard]] std::vector<std::string> broken_promises(const Promises& promises);

}  // namespace nadir::sim
