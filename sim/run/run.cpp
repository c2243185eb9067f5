#include "sim/run/run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <utility>

#include "core/error.hpp"
#include "sim/run/audit.hpp"
#include "sim/run/check_view.hpp"
#include "sim/run/heat_ahead.hpp"
#include "sim/run/imaging.hpp"
#include "sim/run/pilot.hpp"
#include "sim/run/prediction.hpp"
#include "sim/run/prepare.hpp"
#include "sim/run/promise_report.hpp"
#include "sim/run/run_key.hpp"
#include "sim/run/tile_journal.hpp"
#include "sim/run/tiles.hpp"
#include "sim/scenario/read_scenario.hpp"

namespace nadir::sim {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

ReportValues settings_of(const PreparedRun& run, const RunOptions& options) {
  const radiometry::SceneDescription& scene = run.world.scene;
  const materials::SolverSettings& solver = scene.solver;
  const auto integer = [](auto value) { return static_cast<std::int64_t>(value); };
  const bool path = scene.method == radiometry::Method::path;
  int most_wavelengths = 0;
  for (const ArrayPlan& array : run.plan.arrays) {
    for (const auto& band : array.quadratures) {
      most_wavelengths = std::max(most_wavelengths, static_cast<int>(band.wavelengths.size()));
    }
  }
  return {{"solver", std::string{path ? "path" : "generic"}},
          {"path_max_bounces", integer(scene.path_max_bounces)},
          {"initial_sample_count", integer(solver.initial_sample_count)},
          {"sample_decay_rate", solver.sample_decay_rate},
          {"max_bounces", integer(solver.max_bounces)},
          {"mu_samples", integer(solver.mu_samples)},
          {"phi_samples", integer(solver.phi_samples)},
          {"min_quad_samples", integer(solver.min_quad_samples)},
          {"replicates", integer(run.goal ? run.goal->replicates : run.sampling.replicates)},
          {"samples_per_replicate",
           integer(run.goal ? run.goal->first_samples : run.sampling.samples_per_replicate)},
          {"wavelengths_per_band", integer(most_wavelengths)},
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

void describe(const PreparedRun& run, const RunOptions& options, RunReport& report) {
  report.version = NADIR_VERSION;
  report.scenario_file = run.scenario.file;
  report.scenario_name = run.scenario.name;
  report.scenario_title = run.scenario.title;
  report.scenario_time_utc = run.scenario.time.to_string();
  report.options = {{"seed", static_cast<std::int64_t>(options.seed)},
                    {"noise_seed", static_cast<std::int64_t>(options.noise_seed)}};
  if (options.accuracy) report.options.emplace_back("accuracy", *options.accuracy);
  if (options.time_s) report.options.emplace_back("time_s", *options.time_s);
  report.settings = settings_of(run, options);
  report.air = run.air;
  report.inputs = run.inputs;
}

/// One run, step by step; each step needs those before it.
class Run {
 public:
  explicit Run(const RunOptions& options)
      : options_{options},
        request_{options.scenario,
                 options.seed,
                 options.accuracy,
                 options.time_s,
                 {},
                 [this](const Scenario& scenario) {
                   prepare_output(options_.output, scenario.products);
                 }} {}

  RunOutcome make() {
    const ThreadLimit limit{options_.threads};  // building the scene is threaded as well
    report_.started_utc = clock_utc();
    run_.emplace(prepare_run(request_, clock_, diagnostics_));
    describe(*run_, options_, report_);
    foretell();
    journal_.emplace(options_.output, run_key(*run_, request_),
                     TileJournal::Options{options_.fresh, options_.more, {}}, diagnostics_);
    render();
    audit();
    return conclude();
  }

 private:
  void tell(const std::string& line) const {
    if (options_.tell) options_.tell(line);
  }

  /// A pilot, where the run is long enough to bear it, and what it says.
  void foretell() {
    Promises& promises = report_.promises;
    promises.names = camera_names(run_->world.camera);
    promises.effects = effect_sheets(run_->world.effects, promises.names);
    promises.settings_reason = run_->solver_reason;
    promises.bias = run_->bias;
    const RenderOptions render = render_options(*run_, options_.seed);
    const Pilot pilot = clock_.stage(
        "pilot", [&] { return run_pilot(run_->world, render, pilot_limits(), diagnostics_); });
    const PredictionBasis basis{*run_, clock_.stages(), options_.time_s, options_.threads};
    promises.prediction = predict(basis, pilot);
    cost_effects(basis, pilot, *promises.prediction, promises.effects);
  }

  /// A tenth of a second is lost on nobody; of a run that may take longer, a hundredth.
  [[nodiscard]] PilotOptions pilot_limits() const {
    PilotOptions limits;
    limits.most_cpu_s = options_.time_s ? std::max(0.1, 0.01 * *options_.time_s) : 0.2;
    return limits;
  }

  /// When the render has to end, so that products and audit are done in time.
  [[nodiscard]] TimeGoal time_goal() const {
    const double audit_share = options_.audit == std::optional{0} ? 0.0 : 0.03;
    const double rest_s = report_.promises.prediction->products_s + audit_share * *options_.time_s;
    TimeGoal goal;
    goal.end = start_ + std::chrono::duration_cast<Clock::duration>(
                            std::chrono::duration<double>(*options_.time_s - rest_s));
    goal.stop_at_goal = options_.accuracy.has_value();
    return goal;
  }

  /// The rounds that are to be made, given what the journal has from before: those that are missing
  /// where a run was interrupted, one more with --more, none where it is finished.
  [[nodiscard]] RenderRounds rounds_to_make() const {
    const std::uint32_t done = journal_->finished();
    // What a time goal had time for is taken as it is; other rounds are mended where one is
    // damaged.
    const std::uint32_t kept = options_.time_s ? done : 0;
    if (options_.more) return {kept, std::max(done + 1, journal_->begun())};
    return {kept, std::max({done, journal_->begun(), 1U})};
  }

  void tell_of_journal(const RenderRounds& rounds) const {
    if (journal_->tiles_at_start() == 0) return;
    tell(rounds.end == journal_->finished()
             ? std::string{"all samples were there: nothing is rendered"}
             : fmt::format("{}: {} finished tiles were there",
                           options_.more ? "extended" : "resumed", journal_->tiles_at_start()));
  }

  void render() {
    RenderOptions render = render_options(*run_, options_.seed);
    render.threads = options_.threads;
    render.progress = options_.progress;
    render.store = &*journal_;
    render.rounds = rounds_to_make();
    const bool to_sample = render.rounds.end > journal_->finished();
    TimeGoal time;
    if (options_.time_s && to_sample) {
      time = time_goal();
      render.time = &time;
    }
    if (options_.time_s && !to_sample) {
      diagnostics_.warn(
          "the folder has a finished run: nothing was sampled; --more goes on sampling, --fresh "
          "starts over");
    }
    tell_of_journal(render.rounds);
    if (to_sample) journal_->begin(render.rounds.end);
    Imaging imaging{
        run_->scenario, run_->world, {options_.output, options_.noise_seed}, diagnostics_};
    clock_.stage("render", [&] {
      imaging.take([&](const StripSink& sink) {
        tally_ = render_strips(run_->world.scene, run_->world.camera, render, diagnostics_, sink);
      });
    });
    written_ = clock_.stage("write products", [&] { return imaging.finish(); });
    journal_->finish(std::max(tally_.rounds, render.rounds.end));
    if (!run_->scenario.products.keep_samples) journal_->discard();
  }

  void audit() {
    if (options_.audit == std::optional{0}) return;
    const RunFact fact = run_fact(tally_, clock_.stages(), 0.0);
    const std::vector<StageTime> stages = clock_.stages();
    clock_.stage("audit", [&] {
      report_.promises.audit =
          audit_run({request_, *run_, stages, fact.mean_paths, options_.threads, options_.audit},
                    diagnostics_);
    });
    const AuditReport& found = *report_.promises.audit;
    if (found.found_any()) diagnostics_.warn("audit: " + found.verdict);
  }

  RunOutcome conclude() {
    const World& world = run_->world;
    if (world.heat) {
      report_.heat = clock_.stage("error of temperatures", [&] { return heat_report(world); });
      tell_of_heat(world, diagnostics_);
    }
    for (const ProductFile& product : written_.files) {
      report_.products.push_back(record_file(product.kind, product.path));
    }
    report_.arrays = std::move(written_.summaries);
    warn_of_hidden_light(*run_, report_.arrays, diagnostics_);
    report_.counters = counters_of(tally_.counters);
    report_.stages = clock_.stages();
    report_.warnings = diagnostics_.messages();
    report_.peak_memory_bytes = peak_memory_bytes();
    report_.finished_utc = clock_utc();
    Promises& promises = report_.promises;
    const double seconds = seconds_since(start_);
    promises.fact = run_fact(tally_, report_.stages, seconds);
    if (request_.has_goal()) promises.goal = goal_report(*run_, {request_, tally_, seconds});
    const std::filesystem::path report_file = options_.output / "report.json";
    write_report(report_file, report_);
    std::vector<std::string> broken = broken_promises(promises);
    return {std::move(report_), report_file, std::move(broken)};
  }

  const RunOptions& options_;
  RunRequest request_;
  Clock::time_point start_ = Clock::now();
  StageClock clock_;
  Diagnostics diagnostics_;
  RunReport report_;
  std::optional<PreparedRun> run_;
  std::optional<TileJournal> journal_;
  RenderTally tally_;
  ProductWriter::Written written_;
};

}  // namespace

RunOutcome run_scenario(const RunOptions& options) { return Run{options}.make(); }

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
