#include "sim/plan/solver_choice.hpp"

#include <string>

#include "sim/plan/bias_terms.hpp"
#include "support/catch.hpp"

namespace nadir::test {
namespace {

using radiometry::Effect;
using radiometry::EffectSet;
using radiometry::Method;

sim::SceneFacts thermal_facts(double rho) {
  sim::SceneFacts facts;
  facts.arrays.resize(1);
  sim::BandFacts band;
  band.name = "lwir";
  band.greatest_reflectance = rho;
  band.least_emissivity = 1.0 - rho;
  band.coldest_emission = 8.0;
  band.warmest_emission = 10.0;
  facts.arrays[0].bands = {band};
  return facts;
}

sim::EffectPlan plan_of_solver_choice(EffectSet on, double lit = 0.0) {
  sim::EffectPlan effects;
  for (std::size_t i = 0; i < radiometry::effect_count; ++i) {
    effects.decisions[i].effect = static_cast<Effect>(i);
    effects.decisions[i].bound = {{0.0}};
  }
  effects.decisions[radiometry::index_of(Effect::solar_reflection)].bound = {{lit}};
  effects.by_array = {on};
  effects.any = on;
  effects.floor_radiance = {{1.0}};
  effects.dropped = {{0.0}};
  return effects;
}

const EffectSet at_night = EffectSet{}
                               .with(Effect::surface_emission)
                               .with(Effect::sky_emission)
                               .with(Effect::interreflection)
                               .with(Effect::path_transmittance);

}  // namespace

TEST_CASE("a thermal night of high emissivity is left to quads", "[sim][solver_choice]") {
  const auto choice = sim::choose_solver(thermal_facts(0.05), plan_of_solver_choice(at_night));
  CHECK(choice.method == Method::generic);
  CHECK(choice.settings.initial_sample_count == 2);
  CHECK(choice.settings.max_bounces == 1);
  CHECK(choice.settings.mu_samples == 4);
  CHECK(choice.settings.phi_samples == 8);
  CHECK(choice.settings.min_quad_samples == 1);
  CHECK(choice.reason.find("none reflects more than 5 %") != std::string::npos);
}

TEST_CASE("what the limit of bounces leaves out fits into the budget, or paths are taken",
          "[sim][solver_choice]") {
  const double rho = GENERATE(0.02, 0.08, 0.11, 0.15);
  const double accuracy = GENERATE(0.1, 0.01, 0.001, 1e-5);
  CAPTURE(rho, accuracy);
  auto effects = plan_of_solver_choice(at_night);
  effects.relative = accuracy;
  const auto facts = thermal_facts(rho);
  const auto choice = sim::choose_solver(facts, effects);
  const auto bias = sim::bias_terms(facts, effects, choice, {}, 0.0).at(0).at(0);
  CHECK(bias.bounce_limit + bias.thresholds <= 0.1 * accuracy);
  CHECK_FALSE(choice.reason.empty());
  if (choice.method == Method::path) CHECK(choice.path_max_bounces == 0);
}

TEST_CASE("more bounces are taken before paths are", "[sim][solver_choice]") {
  const auto choice = sim::choose_solver(thermal_facts(0.12), plan_of_solver_choice(at_night));
  CHECK(choice.method == Method::generic);
  CHECK(choice.settings.max_bounces == 2);  // 0.12^3 10 / 7.04 = 0.25 %, 0.12^4 0.03 %, of 1 %
}

TEST_CASE("where light counts, surfaces reflect or air is thick paths are taken",
          "[sim][solver_choice]") {
  const auto method = [](double rho, EffectSet on, double lit = 0.0) {
    return sim::choose_solver(thermal_facts(rho), plan_of_solver_choice(on, lit)).method;
  };
  CHECK(method(0.3, at_night) == Method::path);
  CHECK(method(0.05, at_night.with(Effect::solar_reflection), 0.01) == Method::generic);
  CHECK(method(0.05, at_night.with(Effect::solar_reflection), 0.5) == Method::path);
  CHECK(method(0.05, at_night, 0.5) == Method::generic);  // a sun that is left out does not count
  CHECK(method(0.05, at_night.with(Effect::volumes)) == Method::path);
  const EffectSet day = at_night.without(Effect::surface_emission).with(Effect::solar_reflection);
  CHECK(method(0.05, day, 1.0) == Method::path);
  CHECK(method(0.05, day.with(Effect::lamps), 1.0) == Method::path);
}

TEST_CASE("without interreflection no path goes on", "[sim][solver_choice]") {
  const EffectSet day = EffectSet{}.with(Effect::solar_reflection).with(Effect::sky_scattering);
  const auto choice = sim::choose_solver(thermal_facts(0.3), plan_of_solver_choice(day, 1.0));
  CHECK(choice.method == Method::generic);
  CHECK(choice.settings.max_bounces == 0);
  CHECK(choice.settings.mu_samples * choice.settings.phi_samples == 12);
  const auto night = sim::choose_solver(
      thermal_facts(0.3), plan_of_solver_choice(at_night.without(Effect::interreflection)));
  CHECK(night.method == Method::generic);
  CHECK(night.settings.mu_samples * night.settings.phi_samples == 32);
  CHECK(sim::choose_solver(thermal_facts(0.3), plan_of_solver_choice(day.with(Effect::lamps), 1.0))
            .method == Method::path);
}

}  // namespace nadir::test
