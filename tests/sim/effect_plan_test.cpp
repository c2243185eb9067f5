#include "sim/plan/effect_plan.hpp"

#include <cmath>
#include <limits>

#include "sim/plan/effect_bounds.hpp"
#include "support/catch.hpp"

using namespace nadir;
using namespace nadir::sim;
using radiometry::Effect;
using radiometry::index_of;

namespace {

/// A grey surface of 0.5 under a sun and a sky of a hundredth of its light, no air before the
/// camera, at a temperature that is not seen to emit.
BandFacts sunny_band() {
  BandFacts band;
  band.name = "red";
  band.least_reflectance = band.greatest_reflectance = 0.5;
  band.least_emissivity = band.greatest_emissivity = 0.5;
  band.coldest_emission = band.warmest_emission = 1e-12;
  band.sun_irradiance = 1000.0;
  band.sky_scattering = band.least_sky_scattering = 10.0;
  return band;
}

SceneFacts sunny() {
  SceneFacts facts;
  facts.has_sun = facts.has_air = true;
  facts.arrays.push_back({"wide", {sunny_band()}});
  return facts;
}

const EffectDecision& decision(const EffectPlan& plan, Effect effect) {
  return plan.decisions[index_of(effect)];
}

EffectsInput with(Effect effect, EffectState state) {
  EffectsInput wanted;
  wanted.states[index_of(effect)] = state;
  return wanted;
}

}  // namespace

TEST_CASE("a day keeps sunlight and leaves out what is not there or does not show",
          "[plan][effects]") {
  const EffectPlan plan = plan_effects({}, {}, sunny());
  for (const Effect kept : {Effect::solar_reflection, Effect::sky_scattering,
                            Effect::interreflection, Effect::shadows}) {
    CAPTURE(radiometry::name_of(kept));
    CHECK(plan.any.has(kept));
  }
  for (const Effect gone : {Effect::lunar_reflection, Effect::lamps, Effect::surface_emission,
                            Effect::volumes, Effect::leaf_transmission, Effect::psf,
                            Effect::path_transmittance, Effect::thermal_solve}) {
    CAPTURE(radiometry::name_of(gone));
    CHECK_FALSE(plan.any.has(gone));
  }
  CHECK(decision(plan, Effect::volumes).reason == "the scenario has no volumes");
  CHECK(decision(plan, Effect::surface_emission).reason ==
        "adds at most 2e-11 % in red; all effects left out may add 0.25 %");
  CHECK(decision(plan, Effect::path_transmittance).reason == "the air takes nothing away");
}

TEST_CASE("what is dropped adds up to no more than its share, the smallest first",
          "[plan][effects]") {
  SceneFacts facts = sunny();
  BandFacts& band = facts.arrays[0].bands[0];
  // The floor is 0.5 * 10 + 0.5e-12 = 5: bounds of 0.1 %, 0.12 % and 0.05 %.
  band.path_emission = 5e-3;
  band.path_scattering = 6e-3;
  band.moon_irradiance = 0.25e-2 * std::acos(-1.0);  // x 0.5 / pi / (1 - 0.5)
  facts.has_moon = true;
  const EffectPlan plan = plan_effects({}, {}, facts);
  CHECK(plan.floor_radiance[0][0] == Approx(5.0).epsilon(1e-5));
  CHECK_FALSE(plan.any.has(Effect::lunar_reflection));
  CHECK_FALSE(plan.any.has(Effect::path_emission));
  CHECK(plan.any.has(Effect::path_scattering));
  // 1e-4: the floor has 2e-2 E / pi of the moon as well, but less than of the sky
  CHECK(plan.dropped[0][0] == Approx(0.0015).epsilon(1e-4));
  CHECK(plan.dropped[0][0] <= AccuracyInput{}.effects_share * plan.relative);

  AccuracyInput generous;
  generous.relative = 0.02;
  CHECK_FALSE(plan_effects({}, generous, facts).any.has(Effect::path_scattering));
  AccuracyInput strict;
  strict.effects_share = 0.0;
  CHECK(plan_effects({}, strict, facts).any.has(Effect::lunar_reflection));
  CHECK_FALSE(plan_effects({}, strict, facts).any.has(Effect::lamps));  // there is nothing of them
}

TEST_CASE("an effect is dropped only if every band allows it", "[plan][effects]") {
  SceneFacts facts = sunny();
  facts.arrays[0].bands.push_back(sunny_band());
  facts.arrays[0].bands[1].name = "swir";
  facts.arrays[0].bands[1].path_emission = 0.1;  // 2 % of the floor
  const EffectPlan plan = plan_effects({}, {}, facts);
  CHECK(plan.by_array[0].has(Effect::path_emission));
  CHECK(decision(plan, Effect::path_emission).reason == "may add as much as 2 % in swir");
}

TEST_CASE("every array decides for itself", "[plan][effects]") {
  SceneFacts facts = sunny();
  facts.arrays.push_back({"thermal", {sunny_band()}});
  facts.arrays[1].bands[0].name = "lw";
  facts.arrays[1].bands[0].warmest_emission = facts.arrays[1].bands[0].coldest_emission = 9.0;
  const EffectPlan plan = plan_effects({}, {}, facts);
  CHECK(decision(plan, Effect::surface_emission).on == std::vector<bool>{false, true});
  CHECK(plan.any.has(Effect::surface_emission));
  CHECK(decision(plan, Effect::surface_emission).reason ==
        "array thermal: may add as much as 95 % in lw; elsewhere it is left out");
}

TEST_CASE("what the scenario states always holds and uses up nothing", "[plan][effects]") {
  const EffectPlan off =
      plan_effects(with(Effect::solar_reflection, EffectState::off), {}, sunny());
  CHECK_FALSE(off.any.has(Effect::solar_reflection));
  CHECK(decision(off, Effect::solar_reflection).bound[0][0] > 10.0);  // but is told
  CHECK(decision(off, Effect::solar_reflection).reason == "stated in the scenario");
  CHECK(off.dropped[0][0] < 1e-9);
  // Nothing is left that could throw a shadow.
  CHECK_FALSE(off.any.has(Effect::shadows));
  const EffectPlan on = plan_effects(with(Effect::lamps, EffectState::on), {}, sunny());
  CHECK(on.any.has(Effect::lamps));
}

TEST_CASE("shadows go with all light that throws them", "[plan][effects]") {
  SceneFacts facts = sunny();
  facts.arrays[0].bands[0].sun_irradiance = 1e-3;  // 6e-5 of the floor
  const EffectPlan plan = plan_effects({}, {}, facts);
  CHECK_FALSE(plan.any.has(Effect::solar_reflection));
  CHECK_FALSE(plan.any.has(Effect::shadows));
}

TEST_CASE("the planner never drops noise, and refraction by its own rule", "[plan][effects]") {
  SceneFacts facts = sunny();
  facts.arrays[0].has_detector = true;
  facts.arrays[0].bands[0].noise_radiance = 1e-9;
  facts.has_refraction = true;
  facts.arrays[0].refraction_pixels = 0.09;
  EffectPlan plan = plan_effects({}, {}, facts);
  CHECK(plan.any.has(Effect::detector_noise));
  CHECK_FALSE(plan.any.has(Effect::refraction));
  CHECK(decision(plan, Effect::refraction).reason ==
        "moves lines of sight by at most 0.09 pixels; those below 0.1 are straight");
  facts.arrays[0].refraction_pixels = 0.1;
  plan = plan_effects({}, {}, facts);
  CHECK(plan.any.has(Effect::refraction));
}

TEST_CASE("heat is solved where a product shows it, seen or not", "[plan][effects]") {
  SceneFacts facts = sunny();
  facts.has_solved_temperatures = true;
  facts.arrays[0].bands[0].warmest_solved_emission = 1e-12;
  CHECK_FALSE(plan_effects({}, {}, facts).any.has(Effect::thermal_solve));
  facts.wants_temperatures = true;
  CHECK(plan_effects({}, {}, facts).any.has(Effect::thermal_solve));
}

TEST_CASE("what nothing is known of is kept", "[plan][effects]") {
  SceneFacts facts = sunny();
  facts.arrays[0].bands[0].lamp_irradiance = std::numeric_limits<double>::infinity();
  facts.has_lamps = facts.has_volumes = true;
  const EffectPlan plan = plan_effects({}, {}, facts);
  CHECK(plan.any.has(Effect::lamps));
  CHECK(plan.any.has(Effect::volumes));
  CHECK(decision(plan, Effect::volumes).reason == "no bound of it is known beforehand");
}

TEST_CASE("a scene without any light or arrays can be planned", "[plan][effects]") {
  SceneFacts dark;
  dark.arrays.push_back({"a", {BandFacts{}}});
  const EffectPlan plan = plan_effects({}, {}, dark);
  CHECK(plan.any == radiometry::EffectSet{});
  CHECK(plan.floor_radiance[0][0] > 0.0);
  CHECK(plan_effects({}, {}, SceneFacts{}).by_array.empty());
}
