#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/diagnostics.hpp"
#include "sim/plan/solver_choice.hpp"
#include "sim/plan/wavelength_choice.hpp"
#include "sim/products/report.hpp"
#include "sim/run/pixel_ray.hpp"
#include "sim/run/sampling_goal.hpp"
#include "sim/run/stage_clock.hpp"
#include "sim/run/world.hpp"
#include "sim/scenario/scenario.hpp"

namespace nadir::sim {

/// What decides a run's samples beside its scenario.
struct RunRequest {
  std::filesystem::path scenario;
  std::uint64_t seed = 1;
  /// Relative standard error that every band of every pixel is sampled to. With it solver and
  /// wavelengths are chosen by the planner.
  std::optional<double> accuracy;
  /// Wall clock that the whole run may take; likewise.
  std::optional<double> time_s;
  /// Changes the scenario before anything is loaded, as the audit and the study do.
  std::function<void(Scenario&)> edit{};
  /// Called when everything is read and found right, before temperatures and air are solved.
  std::function<void(const Scenario&)> checked{};
  /// Temperatures are solved ahead for every pixel, as a whole picture needs them; otherwise when a
  /// ray first asks.
  bool heat_ahead = true;
  bool solve = true;  ///< false: neither temperatures nor air: nothing of it can be rendered

  /// Whether sampling follows a goal instead of the scenario's numbers.
  [[nodiscard]] bool has_goal() const { return accuracy || time_s; }
};

/// A run that only has to be rendered: everything is read, planned and solved. Stays where it is:
/// render_options point into it.
struct PreparedRun {
  Scenario scenario;
  World world;                        ///< its air finished
  SamplingInput sampling;             ///< the scenario's, its wavelengths chosen where asked for
  CameraPlan plan;                    ///< the lanes of every array
  std::optional<RayBending> bending;  ///< of the camera's rays
  std::optional<SamplingGoal> goal;   ///< none: the scenario's samples
  std::string solver_reason;          ///< why this solver; "stated in the scenario"
  BiasByBand bias;                    ///< what sampling does not show
  ByBand relative_bias;               ///< its totals
  ReportValues air;                   ///< how the air was computed
  std::vector<FileRecord> inputs;     ///< with digests
};

/// @param clock  gets the stages
/// @throws InputError for mistakes in the scenario or in a file that it names
[[nodiscard]] PreparedRun prepare_run(const RunRequest& request, StageClock& clock,
                                      Diagnostics& diagnostics);

/// Options that render what was prepared.
/// @param prepared  must outlive what uses them
[[nodiscard]] RenderOptions render_options(const PreparedRun& prepared, std::uint64_t seed);

}  // namespace nadir::sim
