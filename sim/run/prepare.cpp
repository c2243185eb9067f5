#include "sim/run/prepare.hpp"

#include <utility>

#include "sim/run/air_stage.hpp"
#include "sim/run/check_view.hpp"
#include "sim/run/choose_wavelengths.hpp"
#include "sim/run/gather_facts.hpp"
#include "sim/run/heat_ahead.hpp"
#include "sim/run/imaging.hpp"
#include "sim/scenario/read_scenario.hpp"

namespace nadir::sim {
namespace {

// Of the accuracy that is asked for, the wavelengths may spend half beside the sampling:
// docs/wavelengths.md shows how fast their number grows.
constexpr double wavelengths_share = 0.5;

SamplingGoal goal_of(const EffectPlan& effects) {
  SamplingGoal goal;
  for (const auto& floors : effects.floor_radiance) {
    auto& bands = goal.bands.emplace_back();
    for (const double floor : floors) bands.push_back({effects.relative, floor});
  }
  return goal;
}

/// Whether the least number of paths would take more than a quarter of the time: then a first round
/// of four has to do. Some 4 us a path, as the shipped scenes take on one of two threads.
bool is_large(const Camera& camera, double time_s) {
  double pixels = 0.0;
  for (const auto& array : camera.arrays)
    pixels += static_cast<double>(array.samples) * array.lines;
  return pixels * 32.0 * 2e-6 > 0.25 * time_s;
}

/// Fixes the wavelengths of every band, and tells what error they leave.
ByBand settle_wavelengths(PreparedRun& run, bool chosen, Diagnostics& diagnostics) {
  const EffectPlan& effects = run.world.effects;
  if (chosen) {
    WavelengthChoice choice =
        choose_wavelengths(run.world, effects.by_array, wavelengths_share * effects.relative,
                           diagnostics, effects.floor_radiance);
    run.sampling.wavelengths_per_band = std::move(choice.nodes);
    return std::move(choice.error);
  }
  return wavelength_errors(run.world, effects.by_array, run.sampling.wavelengths_per_band,
                           effects.floor_radiance);
}

/// The solver that the goal calls for.
SolverChoice settle_solver(PreparedRun& run, bool chosen) {
  radiometry::SceneDescription& scene = run.world.scene;
  if (!chosen) {
    return {scene.method, scene.path_max_bounces, scene.solver, "stated in the scenario"};
  }
  SolverChoice choice = choose_solver(run.world.facts, run.world.effects);
  scene.method = choice.method;
  scene.path_max_bounces = choice.path_max_bounces;
  scene.solver = choice.settings;
  for (materials::Material& material : scene.materials) material.solver.reset();
  return choice;
}

double air_table_error(const World& world) {
  const auto* air = std::get_if<atmosphere::Tabulated>(&world.scene.atmosphere);
  return air == nullptr ? 0.0 : air->table->interpolation_error;
}

void check(const PreparedRun& run, Diagnostics& diagnostics) {
  check_spectra(run.world, run.sampling, diagnostics);
  check_memory(run.world.camera);
  check_view(run.world, diagnostics);
}

void solve(PreparedRun& run, const RunRequest& request, StageClock& clock,
           Diagnostics& diagnostics) {
  World& world = run.world;
  if (world.heat && request.heat_ahead) {
    clock.stage("heat", [&] { solve_heat_ahead(world, request.seed); });
  }
  if (world.air) {
    clock.stage("air", [&] {
      run.air = finish_air(world, run.sampling, diagnostics, {}, world.effects.by_array);
      run.bending = camera_bending(world, run.air);
    });
  }
  run.plan = plan_camera(world, run.sampling);
}

Scenario scenario_of(const RunRequest& request, Diagnostics& diagnostics) {
  Scenario scenario = read_scenario(request.scenario, diagnostics);
  if (request.accuracy) scenario.accuracy.relative = *request.accuracy;
  if (request.edit) request.edit(scenario);
  return scenario;
}

}  // namespace

PreparedRun prepare_run(const RunRequest& request, StageClock& clock, Diagnostics& diagnostics) {
  InputFiles inputs;
  Scenario scenario =
      clock.stage("read scenario", [&] { return scenario_of(request, diagnostics); });
  World world = clock.stage(
      "build scene", [&] { return load_world(scenario, inputs, diagnostics, request.seed); });
  PreparedRun run{std::move(scenario), std::move(world), {}, {}, {}, {}, {}, {}, {}, {}, {}};
  run.sampling = run.scenario.sampling;
  const bool chooses = run.sampling.wavelengths_per_band == BandNodes{0} || request.has_goal();
  const ByBand wavelength_errors =
      clock.stage("wavelengths", [&] { return settle_wavelengths(run, chooses, diagnostics); });
  const SolverChoice solver = settle_solver(run, request.has_goal());
  run.solver_reason = solver.reason;
  if (request.has_goal()) run.goal = goal_of(run.world.effects);
  if (request.time_s && is_large(run.world.camera, *request.time_s)) {
    run.goal->replicates = 4;
    run.goal->first_samples = 1;
  }
  check(run, diagnostics);
  if (request.checked) request.checked(run.scenario);
  run.inputs = clock.stage("hash inputs", [&] { return record_inputs(inputs, run.scenario); });
  if (request.solve) solve(run, request, clock, diagnostics);
  run.bias = bias_terms(run.world.facts, run.world.effects, solver, wavelength_errors,
                        air_table_error(run.world));
  for (const auto& array : run.bias) {
    auto& totals = run.relative_bias.emplace_back();
    for (const BiasTerms& band : array) totals.push_back(band.total());
  }
  return run;
}

RenderOptions render_options(const PreparedRun& prepared, std::uint64_t seed) {
  const ProductsInput& products = prepared.scenario.products;
  const World& world = prepared.world;
  RenderOptions render;
  render.sampling = prepared.sampling;
  render.seed = seed;
  render.truth = products.truth;
  render.plan = &prepared.plan;
  render.bending = prepared.bending ? &*prepared.bending : nullptr;
  render.asks_for_heat = &world.asks_for_heat;
  render.sky_view = products.sky_view;
  render.fractions = products.fractions;
  render.shares = products.statistics;
  render.frame = &world.frame;
  render.object_names = &world.object_names;
  render.effects = &world.effects.by_array;
  render.goal = prepared.goal ? &*prepared.goal : nullptr;
  render.bias = &prepared.relative_bias;
  return render;
}

}  // namespace nadir::sim
