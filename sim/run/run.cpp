#include "sim/run/run.hpp"

#include <fstream>
#include <optional>

#include "core/error.hpp"
#include "sim/run/air_stage.hpp"
#include "sim/run/check_view.hpp"
#include "sim/run/detect.hpp"
#include "sim/run/heat_ahead.hpp"
#include "sim/run/render.hpp"
#include "sim/run/stage_clock.hpp"
#include "sim/run/tiles.hpp"
#include "sim/run/world.hpp"
#include "sim/scenario/read_scenario.hpp"

namespace nadir::sim {
namespace {

ReportValues settings_of(const Scenario& scenario, const RunOptions& options) {
  const auto& solver = scenario.solver;
  const auto integer = [](auto value) { return static_cast<std::int64_t>(value); };
  const bool path = scenario.method == radiometry::Method::path;
  return {{"solver", std::string{path ? "path" : "generic"}},
          {"path_max_bounces", integer(scenario.path_max_bounces)},
          {"initial_sample_count", integer(solver.initial_sample_count)},
          {"sample_decay_rate", solver.sample_decay_rate},
          {"max_bounces", integer(solver.max_bounces)},
          {"mu_samples", integer(solver.mu_samples)},
          {"phi_samples", integer(solver.phi_samples)},
          {"min_quad_samples", integer(solver.min_quad_samples)},
          {"replicates", integer(scenario.sampling.replicates)},
          {"samples_per_replicate", integer(scenario.sampling.samples_per_replicate)},
          {"wavelengths_per_band", integer(scenario.sampling.wavelengths_per_band.everywhere)},
          {"seed", integer(options.seed)},
          {"threads", integer(options.threads > 0 ? options.threads : available_threads())}};
}

std::map<std::string, std::uint64_t> counters_of(const radiometry::Counters& c) {
  return {{"primary_rays", c.primary_rays},
          {"target_rays", c.target_rays},
          {"lamp_rays", c.lamp_rays},
          {"path_rays", c.path_rays},
          {"full_samples", c.full_samples},
          {"direct_only_samples", c.direct_only_samples},
          {"truth_rays", c.truth_rays},
          {"volume_events", c.volume_events},
          {"roulette_stops", c.roulette_stops},
          {"rays", c.rays()},
          {"current_weight_stops", c.current_weight_stops},
          {"target_weight_skips", c.target_weight_skips},
          {"full_weight_downgrades", c.full_weight_downgrades},
          {"quick_weight_skips", c.quick_weight_skips},
          {"raw_weight_skips", c.raw_weight_skips},
          {"budget_stops", c.budget_stops},
          {"bounce_limit_stops", c.bounce_limit_stops}};
}

ProductContext context_of(const Scenario& scenario, Diagnostics& diagnostics) {
  ProductContext context;
  context.scenario_name = scenario.name;
  context.title = scenario.title;
  context.time_utc = scenario.time.to_string();
  context.version = NADIR_VERSION;
  context.wanted = scenario.products;
  context.diagnostics = &diagnostics;
  return context;
}

/// How the products place themselves on the earth.
ProductGeometry geometry_of(const Scenario& scenario, const World& world) {
  const geometry::Scene& scene = world.scene.geometry;
  const geometry::Bounds box = scene.bounds();
  const double middle_up_m = 0.5 * (box.lo.z + box.hi.z);
  const auto surface = [&scene](const geometry::Ray& ray) -> std::optional<Vec3> {
    const auto hit = scene.intersect(ray);
    return hit ? std::optional{hit->position} : std::nullopt;
  };
  return {&world.camera, world.frame,
          scenario.time, world.scene.illumination,
          surface,       world.frame.geodetic({0.0, 0.0, middle_up_m}).height_m};
}

RenderOptions render_options(const Scenario& scenario, const RunOptions& options,
                             const World& world) {
  RenderOptions render;
  render.sampling = scenario.sampling;
  render.seed = options.seed;
  render.threads = options.threads;
  render.truth = scenario.products.truth;
  render.progress = options.progress;
  render.asks_for_heat = &world.asks_for_heat;
  render.sky_view = scenario.products.sky_view;
  render.fractions = scenario.products.fractions;
  render.shares = scenario.products.statistics;
  render.frame = &world.frame;
  render.object_names = &world.object_names;
  return render;
}

/// Renders, lets the detectors count and writes, strip by strip.
struct Imaging {
  RenderOptions render;
  ProductContext products;
  std::uint64_t noise_seed = 1;

  ProductWriter::Written run(const World& world, const RunOptions& options, RunReport& report,
                             StageClock& clock, Diagnostics& diagnostics) {
    DetectorStage detectors{world.camera, products.wanted, noise_seed};
    products.calibrations = detectors.calibrations();
    ProductWriter writer{products, options.output};
    const auto counters = clock.stage("render", [&] {
      return render_strips(world.scene, world.camera, render, diagnostics,
                           [&](std::size_t array, ArrayImage&& strip) {
                             detectors.apply(array, strip);
                             writer.take(strip);
                           });
    });
    report.counters = counters_of(counters);
    return clock.stage("write products", [&] { return writer.finish(); });
  }
};

void describe(const Scenario& scenario, const RunOptions& options, RunReport& report) {
  report.version = NADIR_VERSION;
  report.scenario_file = scenario.file;
  report.scenario_name = scenario.name;
  report.scenario_title = scenario.title;
  report.scenario_time_utc = scenario.time.to_string();
  report.options = {{"seed", static_cast<std::int64_t>(options.seed)},
                    {"noise_seed", static_cast<std::int64_t>(options.noise_seed)}};
  report.settings = settings_of(scenario, options);
}

/// Finds out before the work, not after it, whether its results can be kept.
void prepare_output(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  const std::filesystem::path probe = folder / ".nadir-probe";
  const bool writable = !error && std::ofstream{probe}.good();
  std::filesystem::remove(probe, error);
  if (!writable) {
    throw InputError{InputIssue{{folder.string(), 0, 0},
                                "this folder cannot be made or written to",
                                "name another with --output",
                                {}}};
  }
}

/// What a file that was read is to the run.
std::string role_of(const std::filesystem::path& file, const Scenario& scenario) {
  const std::string ending = file.extension().string();
  if (file == scenario.file) return "scenario";
  if (ending == ".xml") return "material library";
  if (ending == ".csv" || ending == ".txt") return "table";
  if (ending == ".air") return "table of the air";
  for (const GeometryInput& input : scenario.geometry) {
    const auto* terrain = std::get_if<TerrainInput>(&input);
    if (terrain != nullptr && terrain->raster == file) return "terrain";
  }
  return "mesh";
}

std::vector<FileRecord> record_inputs(const InputFiles& inputs, const Scenario& scenario) {
  std::vector<FileRecord> records;
  for (const auto& file : inputs.all()) {
    records.push_back(record_file(role_of(file, scenario), file));
  }
  return records;
}

}  // namespace

RunOutcome run_scenario(const RunOptions& options) {
  const ThreadLimit limit{options.threads};  // building the scene is threaded as well
  StageClock clock;
  Diagnostics diagnostics;
  InputFiles inputs;
  RunReport report;
  report.started_utc = clock_utc();

  const Scenario scenario =
      clock.stage("read scenario", [&] { return read_scenario(options.scenario, diagnostics); });
  describe(scenario, options, report);
  World world = clock.stage(
      "build scene", [&] { return load_world(scenario, inputs, diagnostics, options.seed); });
  check_spectra(world, scenario.sampling, diagnostics);
  check_memory(world.camera);
  check_view(world, diagnostics);
  prepare_output(options.output);
  report.inputs = clock.stage("hash inputs", [&] { return record_inputs(inputs, scenario); });
  if (world.heat) clock.stage("heat", [&] { solve_heat_ahead(world, options.seed); });
  std::optional<RayBending> bending;
  if (world.air) {
    clock.stage("air", [&] {
      report.air = finish_air(world, scenario.sampling, diagnostics);
      bending = camera_bending(world, report.air);
    });
  }
  const CameraPlan plan = plan_camera(world, scenario.sampling);
  const ProductGeometry geometry = geometry_of(scenario, world);
  Imaging imaging{render_options(scenario, options, world), context_of(scenario, diagnostics),
                  options.noise_seed};
  imaging.render.plan = &plan;
  imaging.render.bending = bending ? &*bending : nullptr;
  imaging.products.geometry = &geometry;
  ProductWriter::Written written = imaging.run(world, options, report, clock, diagnostics);
  if (world.heat) {
    report.heat = clock.stage("error of temperatures", [&] { return heat_report(world); });
    tell_of_heat(world, diagnostics);
  }
  for (const ProductFile& product : written.files) {
    report.products.push_back(record_file(product.kind, product.path));
  }
  report.arrays = std::move(written.summaries);
  report.stages = clock.stages();
  report.warnings = diagnostics.messages();
  report.peak_memory_bytes = peak_memory_bytes();
  report.finished_utc = clock_utc();
  const std::filesystem::path report_file = options.output / "report.json";
  write_report(report_file, report);
  return {std::move(report), report_file};
}

Validation validate_scenario(const std::filesystem::path& file) {
  Diagnostics diagnostics;
  InputFiles inputs;
  const Scenario scenario = read_scenario(file, diagnostics);
  const World world = load_world(scenario, inputs, diagnostics);
  check_spectra(world, scenario.sampling, diagnostics);
  check_view(world, diagnostics);
  Validation found;
  found.name = scenario.name;
  found.objects = scenario.geometry.size();
  found.materials = scenario.materials.size();
  found.arrays = world.camera.arrays.size();
  for (const auto& array : world.camera.arrays) found.bands += array.bands.size();
  found.stored_primitives = world.scene.geometry.stored_primitives();
  found.represented_primitives = world.scene.geometry.represented_primitives();
  check_memory(world.camera);
  found.warnings = diagnostics.messages();
  return found;
}

}  // namespace nadir::sim
