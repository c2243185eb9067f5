#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "sim/products/plan_sheet.hpp"
#include "sim/run/sampling_goal.hpp"

// What a run's report tells of what was promised: effects, prediction and fact, audit, goal, bias.

namespace nadir::sim {

/// What rendering pixels again with everything on that `auto` had dropped came to.
struct AuditReport {
  std::vector<std::string> effects;      ///< that were on again
  std::vector<std::string> not_audited;  ///< effects that were not, each with its reason
  std::string verdict;                   ///< one sentence
  std::uint64_t pixels = 0;              ///< looked at
  double budget = 0.0;                   ///< of what is left out, relative to max(radiance, floor)
  /// Largest |difference| relative to max(radiance, floor), and the standard error of that one.
  double largest = 0.0, largest_error = 0.0;
  std::string array, band;  ///< where it was found
  int sample = 0, line = 0;
  /// Pixels any band of which differs by more than the budget, and by more than the budget and
  /// what chance explains.
  std::uint64_t beyond = 0, surely_beyond = 0;
  /// Upper 95 % confidence bounds of the shares of such pixels in the picture.
  double beyond_share = 1.0, surely_beyond_share = 1.0;
  double seconds = 0.0, cpu_s = 0.0;

  [[nodiscard]] bool found_any() const { return surely_beyond > 0; }
};

/// What accuracy or time was asked for, and what came of it.
struct GoalReport {
  std::optional<double> accuracy;  ///< relative
  std::optional<double> time_s;
  double seconds = 0.0;  ///< wall clock of the run
  GoalOutcome outcome;
  bool kept = false;
  std::string sentence;  ///< what was kept or not, for people
};

/// What a run has come to, as `Prediction` foretells it.
struct RunFact {
  double seconds = std::numeric_limits<double>::quiet_NaN();
  double render_s = std::numeric_limits<double>::quiet_NaN();
  double memory_bytes = std::numeric_limits<double>::quiet_NaN();
  double mean_paths = std::numeric_limits<double>::quiet_NaN();
  std::vector<std::vector<BandForecast>> bands;
};

/// All of it; what is empty is not shown.
struct Promises {
  CameraNames names;  ///< by which figures of bands are shown
  std::vector<EffectSheet> effects;
  std::string settings_reason;  ///< why this solver and these samples
  std::optional<Prediction> prediction;
  std::optional<RunFact> fact;
  std::optional<AuditReport> audit;
  std::optional<GoalReport> goal;
  BiasByBand bias;
};

/// As one JSON object with the keys `effects`, `settings_reason`, `prediction`, `fact`, `audit`,
/// `goal`, `bias`, in this order.
[[nodiscard]] std::string promises_json(const Promises& promises);

}  // namespace nadir::sim
