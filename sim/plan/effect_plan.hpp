#pragma once

#include <array>
#include <string>
#include <vector>

#include "radiometry/effect.hpp"
#include "sim/plan/scene_facts.hpp"
#include "sim/scenario/effects_input.hpp"

namespace nadir::sim {

/// A number for every band, by array and band.
using ByBand = std::vector<std::vector<double>>;

/// What is done about one effect.
struct EffectDecision {
  radiometry::Effect effect{};
  EffectState asked = EffectState::automatic;
  std::vector<bool> on;  ///< by array
  /// Upper bound of what the effect adds to (or, where it is one that takes away, changes in) a
  /// pixel of the band, relative to max(radiance, floor); infinity where nothing is known.
  ByBand bound;
  std::string reason;  ///< one sentence
  [[nodiscard]] bool on_somewhere() const {
    for (const bool on_here : on) {
      if (on_here) return true;
    }
    return false;
  }
};

/// Which effects a run simulates, and what error that makes at most.
struct EffectPlan {
  std::array<EffectDecision, radiometry::effect_count> decisions;  ///< in the order of the enum
  std::vector<radiometry::EffectSet> by_array;
  radiometry::EffectSet any;  ///< of any array
  ByBand floor_radiance;      ///< W m^-2 sr^-1 um^-1
  ByBand dropped;             ///< sum of the bounds of what `automatic` left out, relative
  double relative = 0.01;     ///< accuracy that was planned for
};

/// Decides. For each array the effects that are left to it are dropped, those with the smallest
/// bounds first, as long as the bounds of all that is dropped add up, in every band, to no more
/// than effects_share * relative. What the scenario does not contain is off.
/// Pure: reads no file, traces no ray.
[[nodiscard]] EffectPlan plan_effects(const EffectsInput& wanted, const AccuracyInput& accuracy,
                                      const SceneFacts& facts);

}  // namespace nadir::sim
