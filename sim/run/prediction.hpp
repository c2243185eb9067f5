#pragma once

#include <optional>
#include <vector>

#include "sim/products/plan_sheet.hpp"
#include "sim/products/promises.hpp"
#include "sim/run/pilot.hpp"
#include "sim/run/prepare.hpp"
#include "sim/run/stage_clock.hpp"

namespace nadir::sim {

/// What a prediction is made from besides the pilot.
struct PredictionBasis {
  const PreparedRun& run;
  const std::vector<StageTime>& stages;  ///< that are done
  std::optional<double> time_s;          ///< wall clock that the whole run may take
  int threads = 0;                       ///< 0: one per processor
};

/// Foretells time, memory and error of a run. docs/plan-and-audit.md has the model.
[[nodiscard]] Prediction predict(const PredictionBasis& basis, const Pilot& pilot);

/// Fills in what each effect costs of the predicted time, or would cost. A model: shares of the
/// render's time by kind of ray, and the stages by which effects need them.
void cost_effects(const PredictionBasis& basis, const Pilot& pilot, const Prediction& prediction,
                  std::vector<EffectSheet>& effects);

/// The names of a camera's arrays and bands.
[[nodiscard]] CameraNames camera_names(const Camera& camera);

/// What the run is asked for.
struct WantedText {
  std::optional<double> accuracy, time_s;
};
/// Everything that `nadir plan` shows of a prepared run. @param pilot  null: none was made
[[nodiscard]] PlanSheet plan_sheet(const PredictionBasis& basis, const WantedText& wanted,
                                   const Pilot* pilot);

}  // namespace nadir::sim
