#pragma once

#include <array>
#include <optional>

#include "core/error.hpp"
#include "radiometry/effect.hpp"

// Which effects are simulated, and how much error a picture may have.

namespace nadir::sim {

enum class EffectState {
  automatic,  ///< simulated where its bound exceeds its share of the error budget
  on,
  off
};

/// <effects solar_reflection="auto" .../>
struct EffectsInput {
  std::array<EffectState, radiometry::effect_count> states{};  ///< automatic
  SourceLocation where;                                        ///< of the element

  [[nodiscard]] EffectState of(radiometry::Effect effect) const {
    return states[radiometry::index_of(effect)];
  }
};

/// <accuracy relative_percent="1" .../>: the error budget of every band, from which the planner
/// decides, and to which `nadir run --accuracy` samples.
///
/// A pixel's budget is relative * max(radiance, floor).
struct AccuracyInput {
  double relative = 0.01;
  /// W m^-2 sr^-1 um^-1, of all bands; none: of the sensor's noise, or of the scene.
  std::optional<double> floor_radiance;
  /// Where no floor is stated and a band has a detector: what error of the floor is worth no more
  /// work, in units of the sensor's noise-equivalent radiance: relative * floor = fraction * NEdL.
  double noise_fraction = 0.5;
  /// Of the budget, what all dropped effects may add up to; the rest is for sampling, wavelengths
  /// and solver.
  double effects_share = 0.25;
};

}  // namespace nadir::sim
