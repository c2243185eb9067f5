#include <fmt/format.h>

#include "sim/run/prediction.hpp"

namespace nadir::sim {
namespace {

std::string wanted_text(const WantedText& wanted) {
  std::string text;
  if (wanted.accuracy) {
    text = fmt::format("a standard error of {:.3g} % in every band", 100.0 * *wanted.accuracy);
  }
  if (wanted.time_s) text += fmt::format("{}{:.4g} s", text.empty() ? "" : " or ", *wanted.time_s);
  return text.empty() ? "the samples of the scenario" : text;
}

std::string solver_text(const radiometry::SceneDescription& scene) {
  if (scene.method == radiometry::Method::path) {
    return scene.path_max_bounces > 0
               ? fmt::format("path solver, at most {} bounces", scene.path_max_bounces)
               : "path solver, no limit of bounces";
  }
  const materials::SolverSettings& s = scene.solver;
  return fmt::format(
      "generic solver, {} samples, decay {:.3g}, {} x {} quads of at least {}, at most {} bounces",
      s.initial_sample_count, s.sample_decay_rate, s.mu_samples, s.phi_samples, s.min_quad_samples,
      s.max_bounces);
}

std::string samples_text(const PreparedRun& run, bool timed) {
  if (!run.goal) {
    return fmt::format("{} replicates of {} paths a pixel", run.sampling.replicates,
                       run.sampling.samples_per_replicate);
  }
  const int least = run.goal->replicates * run.goal->first_samples;
  if (timed)
    return fmt::format("rounds until the time is up, in {} replicates", run.goal->replicates);
  return fmt::format("doubling rounds in {} replicates until all bands are done: {} to {} paths",
                     run.goal->replicates, least, run.goal->replicates * run.goal->most_samples);
}

std::vector<std::vector<PlannedBand>> planned_bands(const PreparedRun& run) {
  std::vector<std::vector<PlannedBand>> all;
  const EffectPlan& effects = run.world.effects;
  for (std::size_t i = 0; i < run.world.camera.arrays.size(); ++i) {
    const auto& bands = run.world.camera.arrays[i].bands;
    auto& planned = all.emplace_back();
    for (std::size_t b = 0; b < bands.size(); ++b) {
      planned.push_back({spectral::centre(bands[b].response).value,
                         run.sampling.wavelengths_per_band.of(i, b), effects.floor_radiance[i][b],
                         effects.dropped[i][b], run.bias.empty() ? BiasTerms{} : run.bias[i][b]});
    }
  }
  return all;
}

}  // namespace

PlanSheet plan_sheet(const PredictionBasis& basis, const WantedText& wanted, const Pilot* pilot) {
  const PreparedRun& run = basis.run;
  PlanSheet sheet;
  sheet.scenario = run.scenario.name;
  sheet.title = run.scenario.title;
  sheet.file = run.scenario.file.string();
  sheet.wanted = wanted_text(wanted);
  sheet.relative = run.world.effects.relative;
  sheet.effects_share = run.scenario.accuracy.effects_share;
  sheet.names = camera_names(run.world.camera);
  for (const sensor::DetectorArray& array : run.world.camera.arrays) {
    sheet.pixels.push_back(static_cast<std::uint64_t>(array.samples) *
                           static_cast<std::uint64_t>(array.lines));
  }
  sheet.bands = planned_bands(run);
  sheet.solver = solver_text(run.world.scene);
  sheet.solver_reason = run.solver_reason;
  sheet.samples = samples_text(run, wanted.time_s.has_value());
  sheet.effects = effect_sheets(run.world.effects, sheet.names);
  if (pilot != nullptr) {
    sheet.prediction = predict(basis, *pilot);
    cost_effects(basis, *pilot, *sheet.prediction, sheet.effects);
  }
  return sheet;
}

}  // namespace nadir::sim
