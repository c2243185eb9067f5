#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "sim/plan/effect_plan.hpp"
#include "sim/plan/solver_choice.hpp"

// What `nadir plan` shows of a run before it is made, and its report beside what came of it.

namespace nadir::sim {

/// The names by which figures of bands are shown.
struct ArrayNames {
  std::string array;
  std::vector<std::string> bands;
};
using CameraNames = std::vector<ArrayNames>;

/// One effect: what is done about it and what that costs.
struct EffectSheet {
  std::string name;
  /// Begins with "on" or "off": "on", "on (stated)", "on in 1 of 2 arrays: thermal", "off (auto)",
  /// "off (absent)", "off (stated)".
  std::string state;
  ByBand bound;  ///< relative to max(radiance, floor); infinity where nothing is known
  std::string reason;
  double seconds = 0.0;        ///< wall clock of the run that goes into it, by the cost model
  double seconds_if_on = 0.0;  ///< what it would cost; the same where it is on
};
/// @param names  of the arrays, in the plan's order
[[nodiscard]] std::vector<EffectSheet> effect_sheets(const EffectPlan& plan,
                                                     const CameraNames& names);

/// How the errors of a band's pixels are expected to be, relative to max(radiance, floor).
struct BandForecast {
  double median_error = std::numeric_limits<double>::quiet_NaN();
  double p95_error = std::numeric_limits<double>::quiet_NaN();
  double met =
      std::numeric_limits<double>::quiet_NaN();  ///< share of pixels that meet the accuracy
};

/// What a run is expected to take, from a pilot.
struct Prediction {
  double seconds = 0.0;  ///< wall clock of the whole run
  double load_s = 0.0, heat_s = 0.0, air_s = 0.0, render_s = 0.0, products_s = 0.0;
  double render_cpu_s = 0.0;
  double memory_bytes = 0.0;  ///< at the peak
  double mean_paths = 0.0;    ///< a pixel
  std::vector<std::vector<BandForecast>> bands;
  /// Accuracy that 95 % of the pixels of every band meet; NaN where it is not known.
  double reachable = std::numeric_limits<double>::quiet_NaN();
  double seconds_per_path = 0.0;  ///< of one processor
  std::uint64_t pilot_pixels = 0, pilot_paths = 0;
  double pilot_s = 0.0;  ///< wall clock of the pilot
};

/// One band of the plan.
struct PlannedBand {
  double centre_um = 0.0;
  int wavelengths = 0;
  double floor_radiance = 0.0;  ///< W m^-2 sr^-1 um^-1
  double dropped = 0.0;         ///< sum of the bounds of what is left out, relative
  BiasTerms bias;
};

/// Everything that `nadir plan` prints.
struct PlanSheet {
  std::string scenario, title, file;
  std::string wanted;  ///< "1 % in every band", "60 s", "as the scenario says"
  double relative = 0.01, effects_share = 0.25;
  std::vector<EffectSheet> effects;
  CameraNames names;
  std::vector<std::uint64_t> pixels;  ///< of every array
  std::vector<std::vector<PlannedBand>> bands;
  std::string solver;  ///< "path solver, 8 bounces at most", ...
  std::string solver_reason;
  std::string samples;  ///< "4 x 8 paths a pixel", "as many as 1 % needs, at least 32"
  std::optional<Prediction> prediction;  ///< none: no pilot
  std::vector<std::string> warnings;
};

/// A table for people, at most 120 columns wide.
[[nodiscard]] std::string plan_text(const PlanSheet& sheet);
/// JSON, units in the names; null for what is infinite or not known.
[[nodiscard]] std::string plan_json(const PlanSheet& sheet);

/// Parts of it as JSON values, for the report.
[[nodiscard]] std::string effects_json(const std::vector<EffectSheet>& effects,
                                       const CameraNames& names);
[[nodiscard]] std::string prediction_json(const Prediction& prediction, const CameraNames& names);
[[nodiscard]] std::string bias_json(const BiasByBand& bias, const CameraNames& names);

}  // namespace nadir::sim
