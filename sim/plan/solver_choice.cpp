#include "sim/plan/solver_choice.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "sim/plan/bias_terms.hpp"

namespace nadir::sim {
namespace {

using radiometry::Effect;
using radiometry::EffectSet;
using radiometry::Method;

// The rules of docs/solver-settings.md, "What --accuracy chooses".
constexpr double most_thermal_reflectance = 0.15;  // emissivity above 0.85
constexpr double most_lit = 0.1;  // what bodies and lamps may have of a thermal band's light
constexpr double share_of_bounces = 0.1;  // of the accuracy, what the bounce limit may take
constexpr int most_thermal_bounces = 3;   // beyond, paths are as cheap

bool any_on(const EffectPlan& effects, Effect effect) {
  return std::any_of(effects.by_array.begin(), effects.by_array.end(),
                     [&](EffectSet set) { return set.has(effect); });
}

/// The largest that bodies and lamps may have of any band, relative.
double lit_share(const EffectPlan& effects) {
  double largest = 0.0;
  for (std::size_t a = 0; a < effects.by_array.size(); ++a) {
    for (const Effect effect :
         {Effect::solar_reflection, Effect::lunar_reflection, Effect::lamps}) {
      if (!effects.by_array[a].has(effect)) continue;
      for (const double bound : effects.decisions[radiometry::index_of(effect)].bound.at(a)) {
        largest = std::max(largest, bound);
      }
    }
  }
  return largest;
}

double greatest_reflectance(const SceneFacts& facts) {
  double greatest = 0.0;
  for (const ArrayFacts& array : facts.arrays) {
    for (const BandFacts& band : array.bands) {
      greatest = std::max(greatest, band.greatest_reflectance);
    }
  }
  return greatest;
}

bool all_glow(const EffectPlan& effects) {
  return !effects.by_array.empty() &&
         std::all_of(effects.by_array.begin(), effects.by_array.end(),
                     [](EffectSet set) { return set.has(Effect::surface_emission); });
}

/// The largest bias of a solver's bounce limit and thresholds over all bands.
double solver_bias(const SceneFacts& facts, const EffectPlan& effects, const SolverChoice& solver) {
  double largest = 0.0;
  for (const auto& array : bias_terms(facts, effects, solver, {}, 0.0)) {
    for (const BiasTerms& band : array) {
      largest = std::max(largest, band.bounce_limit + band.thresholds);
    }
  }
  return largest;
}

SolverChoice paths(std::string reason) {
  SolverChoice choice;
  choice.reason = std::move(reason);
  return choice;
}

SolverChoice quads(int samples, int bounces, bool thermal) {
  SolverChoice choice;
  choice.method = Method::generic;
  choice.settings.initial_sample_count = samples;
  choice.settings.max_bounces = bounces;
  choice.settings.mu_samples = thermal ? 4 : 2;
  choice.settings.phi_samples = thermal ? 8 : 6;
  choice.settings.min_quad_samples = 1;
  return choice;
}

SolverChoice one_reflection(bool thermal) {
  SolverChoice choice = quads(1, 0, thermal);
  choice.reason = fmt::format(
      "Light between surfaces is left out: sun and sky are met from each place by rays over {} x "
      "{} parts of the hemisphere, which no path goes on from.",
      choice.settings.mu_samples, choice.settings.phi_samples);
  return choice;
}

SolverChoice thermal_or_paths(const SceneFacts& facts, const EffectPlan& effects, double rho) {
  double bias = 0.0;
  for (int bounces = 1; bounces <= most_thermal_bounces; ++bounces) {
    SolverChoice choice = quads(2, bounces, true);
    choice.settings.sample_decay_rate = 1.0;  // two samples to the last: bounces are few
    bias = solver_bias(facts, effects, choice);
    if (bias > share_of_bounces * effects.relative) continue;
    choice.reason = fmt::format(
        "All bands see surfaces by their own heat and none reflects more than {:.3g} %: 2 samples, "
        "{} bounce{} and 4 x 8 quads need a sixth of the time that paths need. Light reflected "
        "more than {} times is at most {:.2g} %.",
        100.0 * rho, bounces, bounces > 1 ? "s" : "", bounces + 1, 100.0 * bias);
    return choice;
  }
  return paths(fmt::format(
      "Paths without limit: with {} bounces up to {:.2g} % of the light could be missing, of the "
      "{:.2g} % that the accuracy leaves for it.",
      most_thermal_bounces, 100.0 * bias, 100.0 * share_of_bounces * effects.relative));
}

}  // namespace

SolverChoice choose_solver(const SceneFacts& facts, const EffectPlan& effects) {
  const bool glow = all_glow(effects);
  const double lit = lit_share(effects);
  const bool thermal = glow && lit <= most_lit;
  if (any_on(effects, Effect::volumes)) {
    return paths("Paths without limit: they follow light through volumes, without bias.");
  }
  if (any_on(effects, Effect::lamps) && !thermal) {
    return paths(
        "Paths without limit: among lamps no setting of the generic solver is more efficient.");
  }
  if (!any_on(effects, Effect::interreflection)) return one_reflection(thermal);
  const double rho = greatest_reflectance(facts);
  if (thermal && rho <= most_thermal_reflectance) return thermal_or_paths(facts, effects, rho);
  if (thermal) {
    return paths(fmt::format(
        "Paths without limit: surfaces reflect up to {:.3g} % in a thermal band, and a limit of "
        "bounces would be felt.",
        100.0 * rho));
  }
  return paths(fmt::format(
      "Paths without limit, which have no bias: light of sun, moon or lamps counts, and surfaces "
      "reflect up to {:.3g} % of it on to others.",
      100.0 * rho));
}

}  // namespace nadir::sim
