#include "sim/run/promise_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sim/run/accuracy_options.hpp"
#include "sim/run/prediction.hpp"

namespace nadir::sim {
namespace {

// A run that was to take a minute and took three seconds more kept its promise.
constexpr double time_tolerance = 0.05;

/// The largest systematic error of any band, and which band has it.
struct LargestBias {
  double relative = 0.0;
  std::string band;
};
LargestBias largest_bias(const PreparedRun& run) {
  LargestBias largest;
  const CameraNames names = camera_names(run.world.camera);
  for (std::size_t a = 0; a < run.relative_bias.size(); ++a) {
    for (std::size_t b = 0; b < run.relative_bias[a].size(); ++b) {
      if (run.relative_bias[a][b] <= largest.relative) continue;
      largest = {run.relative_bias[a][b], names[a].array + " " + names[a].bands[b]};
    }
  }
  return largest;
}

/// The largest error that the run's own settings make, of any band: left-out effects, bounces,
/// thresholds, wavelengths; what the model of the air is off by is not theirs.
double largest_own_bias(const PreparedRun& run) {
  double largest = 0.0;
  for (const auto& array : run.bias) {
    for (const BiasTerms& band : array) largest = std::max(largest, band.total() - band.air_table);
  }
  return largest;
}

/// The smallest share of pixels of any array that meet the goals of all their bands.
double least_met(const GoalOutcome& outcome) {
  double met = 1.0;
  for (const ArrayOutcome& array : outcome.arrays) met = std::min(met, array.met);
  return met;
}
double worst_error(const GoalOutcome& outcome) {
  double worst = 0.0;
  for (const ArrayOutcome& array : outcome.arrays) {
    for (const BandOutcome& band : array.bands) worst = std::max(worst, band.worst);
  }
  return worst;
}

std::string percent(double share) { return fmt::format("{:.3g} %", 100.0 * share); }

/// Downwards, so that 99.999 % does not read as all.
std::string share_of_pixels(double share) {
  return fmt::format("{:.2f} %", std::floor(1e4 * share) * 1e-2);
}

std::string error_sentence(const PreparedRun& run, double accuracy, const GoalReport& goal) {
  const double met = least_met(goal.outcome);
  const LargestBias bias = largest_bias(run);
  std::string text =
      met >= 1.0 ? fmt::format("every pixel has a standard error of at most {}", percent(accuracy))
                 : fmt::format(
                       "{} of the pixels have a standard error of at most {}, the worst has {}",
                       share_of_pixels(met), percent(accuracy), percent(worst_error(goal.outcome)));
  return text + fmt::format("; systematic errors are at most {} ({})", percent(bias.relative),
                            bias.band.empty() ? "any band" : bias.band);
}

}  // namespace

GoalReport goal_report(const PreparedRun& run, const GoalResult& result) {
  GoalReport goal;
  goal.accuracy = result.request.accuracy;
  goal.time_s = result.request.time_s;
  goal.seconds = result.seconds;
  goal.outcome = result.tally.outcome;
  goal.kept = true;
  if (goal.accuracy) {
    goal.sentence = error_sentence(run, *goal.accuracy, goal);
    goal.kept = least_met(goal.outcome) >= 1.0 && largest_own_bias(run) <= *goal.accuracy;
  }
  if (goal.time_s) {
    const bool in_time = goal.seconds <= (1.0 + time_tolerance) * *goal.time_s;
    if (!goal.sentence.empty()) goal.sentence += "; ";
    goal.sentence += fmt::format("the run took {} of {}", duration_text(goal.seconds),
                                 duration_text(*goal.time_s));
    goal.kept = goal.kept && in_time;
  }
  return goal;
}

RunFact run_fact(const RenderTally& tally, const std::vector<StageTime>& stages, double seconds) {
  RunFact fact;
  fact.seconds = seconds;
  fact.memory_bytes = static_cast<double>(peak_memory_bytes());
  for (const StageTime& stage : stages) {
    if (stage.name == "render") fact.render_s = stage.wall_s;
  }
  double paths = 0.0, pixels = 0.0;
  for (const ArrayOutcome& array : tally.outcome.arrays) {
    paths += array.mean_paths * static_cast<double>(array.pixels);
    pixels += static_cast<double>(array.pixels);
    auto& bands = fact.bands.emplace_back();
    for (const BandOutcome& band : array.bands) {
      BandForecast& found = bands.emplace_back();
      found.p95_error = band.p95;
      found.met = band.met;
    }
  }
  if (pixels > 0.0) fact.mean_paths = paths / pixels;
  return fact;
}

void warn_of_hidden_light(const PreparedRun& run, const std::vector<ArraySummary>& images,
                          Diagnostics& diagnostics) {
  // A tile's first look has 1024 paths or more; what none of them meets has, with 95 % confidence,
  // less than 3 / 1024 of the chances ("rule of three": Hanley and Lippman-Hand, JAMA 249, 1743,
  // 1983).
  constexpr double unseen_chance = 3.0 / 1024.0, far_brighter = 10.0;
  const EffectPlan& effects = run.world.effects;
  for (std::size_t a = 0; a < images.size(); ++a) {
    if (!effects.by_array[a].has(radiometry::Effect::surface_emission)) continue;
    for (std::size_t b = 0; b < images[a].bands.size(); ++b) {
      const BandFacts& facts = run.world.facts.arrays[a].bands[b];
      const double brightest = facts.greatest_emissivity * facts.warmest_emission;
      const double unseen = unseen_chance * facts.greatest_reflectance * brightest;
      const bool hidden = brightest > far_brighter * images[a].bands[b].radiance.greatest;
      if (!hidden || !(unseen > effects.relative * effects.floor_radiance[a][b])) continue;
      diagnostics.warn(fmt::format(
          "array {}, band {}: some surface emits {:.3g} W m^-2 sr^-1 um^-1, more than ten times "
          "what "
          "any pixel shows; what it lights may be missed by all paths, and is then in no stated "
          "error",
          images[a].name, images[a].bands[b].name, brightest));
    }
  }
}

std::vector<std::string> broken_promises(const Promises& promises) {
  std::vector<std::string> broken;
  if (promises.goal && !promises.goal->kept) {
    broken.push_back("promise not kept: " + promises.goal->sentence);
  }
  if (promises.goal && promises.audit && promises.audit->found_any()) {
    broken.push_back("promise not kept: " + promises.audit->verdict);
  }
  return broken;
}

}  // namespace nadir::sim
