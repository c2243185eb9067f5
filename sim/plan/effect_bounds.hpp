#pragma once

#include <string>

#include "radiometry/effect.hpp"
#include "sim/plan/scene_facts.hpp"
#include "sim/scenario/effects_input.hpp"

// How much a band of a pixel may change when one effect is left out. docs/effects.md derives each
// formula. Light is followed in radiance: a surface of reflectance rho makes of surroundings that
// are nowhere brighter than L at most rho L, so what falls in once adds up to at most
// first / (1 - rho) after all reflections.

namespace nadir::sim {

/// The radiance below which errors no longer count relative to the pixel, W m^-2 sr^-1 um^-1:
/// stated; or relative * floor = noise_fraction * NEdL; or the scene's darkest ordinary surface,
///
///     eps_min B(T_min) + max(rho_min, 0.02) max(L_sky, 0.02 (E_sun + E_moon) / pi)
///
/// a surface of at least 0.02 in shade, under the sky or, without any, under the 0.02 of the direct
/// light that its surroundings reflect. Never 0.
[[nodiscard]] double floor_radiance(const BandFacts& band, const AccuracyInput& accuracy);

/// One band, and what its bounds are relative to.
struct BoundContext {
  const SceneFacts& scene;
  const ArrayFacts& array;
  const BandFacts& band;
  double floor = 0.0;           ///< W m^-2 sr^-1 um^-1, > 0
  double least_emission = 0.0;  ///< what every surface sends out at least, likewise
};

/// Upper bound of what the effect adds to (or changes in) a pixel of the band, relative to
/// max(radiance, floor). 0: the scene has nothing of it; infinity: nothing is known.
[[nodiscard]] double effect_bound(radiometry::Effect effect, const BoundContext& context);

/// Facts of the same band with effects taken out of it.
[[nodiscard]] BandFacts facts_without(BandFacts band, radiometry::EffectSet left_out);
[[nodiscard]] SceneFacts scene_without(SceneFacts scene, radiometry::EffectSet left_out);

/// Why a scene has nothing of an effect, as a sentence without full stop.
[[nodiscard]] std::string why_absent(radiometry::Effect effect, const SceneFacts& facts);

/// Lines of sight that air bends by less are taken as straight (camera_bending).
inline constexpr double noticeable_bending_pixels = 0.1;

}  // namespace nadir::sim
