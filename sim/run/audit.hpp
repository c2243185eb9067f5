#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/diagnostics.hpp"
#include "sim/products/promises.hpp"
#include "sim/run/prediction.hpp"
#include "sim/run/prepare.hpp"
#include "sim/run/probe.hpp"
#include "sim/run/stage_clock.hpp"

namespace nadir::sim {

/// A run that was rendered and is to be audited.
struct AuditRequest {
  const RunRequest& request;             ///< by which it was prepared
  const PreparedRun& run;                ///< with its effects
  const std::vector<StageTime>& stages;  ///< that it took, the render among them
  double mean_paths = 0.0;               ///< a pixel got, where it was sampled to a goal
  int threads = 0;                       ///< 0: one per processor
  /// That are looked at, whatever it costs; 0: no audit; none: as many as `most_share` pays for.
  std::optional<int> pixels;
  double most_share = 0.03;  ///< of the run's processor time, where pixels are not stated
};

/// Renders random pixels again with every effect on that was dropped by `auto`: with the same
/// random numbers, so that what the paths have in common cancels in the difference. The scene is
/// loaded once more, with what the dropped effects need.
/// docs/plan-and-audit.md has the statistics and the costs.
[[nodiscard]] AuditReport audit_run(const AuditRequest& request, Diagnostics& diagnostics);

/// What two renders of the same pixels differ by, against a budget relative to
/// max(radiance, floor). The error of a difference is that of the replicates' differences.
/// @param names  of arrays and bands
void compare_pixels(std::span<const ProbedPixel> dropped, std::span<const ProbedPixel> complete,
                    const ByBand& floor, const CameraNames& names, AuditReport& report);

}  // namespace nadir::sim
