#include "sim/plan/effect_plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "sim/plan/effect_bounds.hpp"

namespace nadir::sim {
namespace {

using radiometry::Effect;
using radiometry::effect_count;
using radiometry::EffectSet;

/// Why an effect is on or off in an array.
enum class Ground { stated, absent, rule, small, needed, pointless };

Effect effect_of(std::size_t index) { return static_cast<Effect>(index); }

EffectSet stated(const EffectsInput& wanted, EffectState state) {
  EffectSet set;
  for (std::size_t i = 0; i < effect_count; ++i) {
    if (wanted.states[i] == state) set = set.with(effect_of(i));
  }
  return set;
}

/// 0.012 %, to two figures.
std::string two_figures(double relative) { return fmt::format("{:.2g} %", 100.0 * relative); }

struct BandBound {
  std::size_t band = 0;
  double bound = 0.0;
};
BandBound worst_of(const std::vector<double>& bounds) {
  const auto worst = std::max_element(bounds.begin(), bounds.end());
  if (worst == bounds.end()) return {};
  return {static_cast<std::size_t>(worst - bounds.begin()), *worst};
}

/// Decides for one detector array.
class ArrayDecisions {
 public:
  ArrayDecisions(const EffectsInput& wanted, const AccuracyInput& accuracy, const SceneFacts& facts,
                 const ArrayFacts& array)
      : wanted_{wanted},
        facts_{facts},
        array_{array},
        budget_{accuracy.effects_share * accuracy.relative},
        dropped_(array.bands.size(), 0.0) {
    for (const BandFacts& band : array.bands) {
      floors_.push_back(
          floor_radiance(facts_without(band, stated(wanted, EffectState::off)), accuracy));
    }
    for (std::size_t i = 0; i < effect_count; ++i) bounds_[i] = bounds_of(effect_of(i));
    decide();
  }

  [[nodiscard]] EffectSet on() const { return on_; }
  [[nodiscard]] Ground ground(std::size_t effect) const { return grounds_[effect]; }
  [[nodiscard]] const std::vector<double>& bound(std::size_t effect) const {
    return bounds_[effect];
  }
  [[nodiscard]] const std::vector<double>& floors() const { return floors_; }
  [[nodiscard]] const std::vector<double>& dropped() const { return dropped_; }

 private:
  /// Beside what the scenario leaves out itself, the effect's own light excepted.
  [[nodiscard]] std::vector<double> bounds_of(Effect effect, EffectSet more_left_out = {}) const {
    const EffectSet off = stated(wanted_, EffectState::off) | more_left_out;
    const SceneFacts scene = scene_without(facts_, off.without(effect));
    std::vector<double> bounds;
    for (std::size_t i = 0; i < array_.bands.size(); ++i) {
      const BandFacts band = facts_without(array_.bands[i], off.without(effect));
      const BandFacts seen = facts_without(array_.bands[i], off);
      bounds.push_back(effect_bound(effect, {scene, array_, band, floors_[i],
                                             seen.least_emissivity * seen.coldest_emission}));
    }
    return bounds;
  }

  void settle(Effect effect, bool on, Ground ground) {
    if (on) on_ = on_.with(effect);
    settled_ = settled_.with(effect);
    grounds_[radiometry::index_of(effect)] = ground;
  }

  /// What is not for the budget to decide.
  void settle_by_rule(Effect effect) {
    const std::size_t i = radiometry::index_of(effect);
    const EffectState asked = wanted_.of(effect);
    if (asked != EffectState::automatic) {
      settle(effect, asked == EffectState::on, Ground::stated);
    } else if (effect == Effect::thermal_solve && facts_.wants_temperatures &&
               facts_.has_solved_temperatures) {
      settle(effect, true, Ground::rule);
    } else if (!(worst_of(bounds_[i]).bound > 0.0)) {
      settle(effect, false, Ground::absent);
    } else if (effect == Effect::detector_noise) {
      settle(effect, array_.has_detector, Ground::rule);
    } else if (effect == Effect::refraction) {
      settle(effect, array_.refraction_pixels >= noticeable_bending_pixels, Ground::rule);
    }
  }

  [[nodiscard]] bool fits(const std::vector<double>& more) const {
    for (std::size_t band = 0; band < more.size(); ++band) {
      if (!(dropped_[band] + more[band] <= budget_)) return false;
    }
    return true;
  }

  void decide() {
    std::vector<std::pair<double, std::size_t>> left;  // worst bound, effect
    for (std::size_t i = 0; i < effect_count; ++i) {
      settle_by_rule(effect_of(i));
      if (!settled_.has(effect_of(i))) left.emplace_back(worst_of(bounds_[i]).bound, i);
    }
    std::sort(left.begin(), left.end());
    for (const auto& [bound, i] : left) {
      const bool drop = fits(bounds_[i]);
      settle(effect_of(i), !drop, drop ? Ground::small : Ground::needed);
      if (!drop) continue;
      for (std::size_t band = 0; band < dropped_.size(); ++band) {
        dropped_[band] += bounds_[i][band];
      }
    }
    drop_pointless();
  }

  /// Effects of light that is left out altogether: shadows without sun, moon and lamps.
  void drop_pointless() {
    EffectSet off;
    for (std::size_t i = 0; i < effect_count; ++i) {
      if (!on_.has(effect_of(i))) off = off.with(effect_of(i));
    }
    for (std::size_t i = 0; i < effect_count; ++i) {
      if (grounds_[i] != Ground::needed) continue;
      const std::vector<double> left = bounds_of(effect_of(i), off);
      const bool emits_unseen =
          effect_of(i) == Effect::thermal_solve && off.has(Effect::surface_emission);
      if (!emits_unseen && worst_of(left).bound > 0.0) continue;
      on_ = on_.without(effect_of(i));
      grounds_[i] = Ground::pointless;
      bounds_[i].assign(left.size(), 0.0);
    }
  }

  const EffectsInput& wanted_;
  const SceneFacts& facts_;
  const ArrayFacts& array_;
  double budget_;
  std::vector<double> floors_, dropped_;
  std::array<std::vector<double>, effect_count> bounds_{};
  std::array<Ground, effect_count> grounds_{};
  EffectSet on_, settled_;
};

/// Makes the sentence that says why.
class Reasons {
 public:
  Reasons(const SceneFacts& facts, const std::vector<ArrayDecisions>& arrays, double budget)
      : facts_{facts}, arrays_{arrays}, budget_{budget} {}

  [[nodiscard]] std::string of(std::size_t effect) const {
    if (arrays_.empty()) return "the camera has no arrays";
    const Ground first = arrays_.front().ground(effect);
    const bool alike = std::all_of(arrays_.begin(), arrays_.end(), [&](const auto& array) {
      return array.ground(effect) == first;
    });
    if (alike) return sentence(effect, first, {});
    std::string kept;
    for (std::size_t a = 0; a < arrays_.size(); ++a) {
      if (!arrays_[a].on().has(effect_of(effect))) continue;
      kept += (kept.empty() ? "" : ", ") + facts_.arrays[a].name;
    }
    const Ground other = weakest(effect);
    if (kept.empty()) return sentence(effect, other, {});
    const Ground on = effect_of(effect) == Effect::detector_noise ? Ground::rule : Ground::needed;
    return fmt::format("array {}: {}; elsewhere it is left out", kept, sentence(effect, on, kept));
  }

 private:
  /// Of the arrays that leave it out: the one that had to weigh it.
  [[nodiscard]] Ground weakest(std::size_t effect) const {
    Ground found = Ground::absent;
    for (const ArrayDecisions& array : arrays_) {
      if (array.ground(effect) == Ground::small) return Ground::small;
      if (array.ground(effect) == Ground::pointless) found = Ground::pointless;
    }
    return found;
  }

  [[nodiscard]] std::string worst(std::size_t effect, bool of_those_on) const {
    BandBound most;
    std::string name;
    for (std::size_t a = 0; a < arrays_.size(); ++a) {
      if (arrays_[a].on().has(effect_of(effect)) != of_those_on) continue;
      const BandBound here = worst_of(arrays_[a].bound(effect));
      if (!name.empty() && here.bound <= most.bound) continue;
      most = here;
      name = facts_.arrays[a].bands.empty() ? "" : facts_.arrays[a].bands[here.band].name;
    }
    // Far above the pixel itself a bound's figure says no more than that.
    return fmt::format("{} in {}", most.bound > 1.0 ? "100 % and more" : two_figures(most.bound),
                       name);
  }

  [[nodiscard]] double worst_bound(std::size_t effect) const {
    double most = 0.0;
    for (const ArrayDecisions& array : arrays_) {
      most = std::max(most, worst_of(array.bound(effect)).bound);
    }
    return most;
  }

  [[nodiscard]] std::string sentence(std::size_t effect, Ground ground,
                                     const std::string& /*arrays*/) const {
    switch (ground) {
      case Ground::stated:
        return "stated in the scenario";
      case Ground::absent:
        return why_absent(effect_of(effect), facts_);
      case Ground::pointless:
        return "nothing that is simulated has anything of it";
      case Ground::rule:
        return by_rule(effect);
      case Ground::small:
        return fmt::format("adds at most {}; all effects left out may add {}", worst(effect, false),
                           two_figures(budget_));
      case Ground::needed:
        break;
    }
    if (!std::isfinite(worst_bound(effect))) return "no bound of it is known beforehand";
    return fmt::format("may add as much as {}", worst(effect, true));
  }

  [[nodiscard]] std::string by_rule(std::size_t effect) const {
    if (effect_of(effect) == Effect::detector_noise) return "the camera has a detector";
    if (effect_of(effect) == Effect::thermal_solve) return "a product shows temperatures";
    double most = 0.0;
    for (const ArrayFacts& array : facts_.arrays) most = std::max(most, array.refraction_pixels);
    return fmt::format("moves lines of sight by at most {:.2g} pixels; those below {} are straight",
                       most, noticeable_bending_pixels);
  }

  const SceneFacts& facts_;
  const std::vector<ArrayDecisions>& arrays_;
  double budget_;
};

}  // namespace

EffectPlan plan_effects(const EffectsInput& wanted, const AccuracyInput& accuracy,
                        const SceneFacts& facts) {
  std::vector<ArrayDecisions> arrays;
  arrays.reserve(facts.arrays.size());
  for (const ArrayFacts& array : facts.arrays) arrays.emplace_back(wanted, accuracy, facts, array);
  EffectPlan plan;
  plan.relative = accuracy.relative;
  for (const ArrayDecisions& array : arrays) {
    plan.by_array.push_back(array.on());
    plan.any = plan.any | array.on();
    plan.floor_radiance.push_back(array.floors());
    plan.dropped.push_back(array.dropped());
  }
  const Reasons reasons{facts, arrays, accuracy.effects_share * accuracy.relative};
  for (std::size_t i = 0; i < effect_count; ++i) {
    EffectDecision& decision = plan.decisions[i];
    decision.effect = effect_of(i);
    decision.asked = wanted.states[i];
    for (const ArrayDecisions& array : arrays) {
      decision.on.push_back(array.on().has(decision.effect));
      decision.bound.push_back(array.bound(i));
    }
    decision.reason = reasons.of(i);
  }
  return plan;
}

}  // namespace nadir::sim
