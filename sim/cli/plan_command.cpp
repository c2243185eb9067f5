#include "sim/cli/plan_command.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "sim/cli/run_options.hpp"
#include "sim/run/pilot.hpp"
#include "sim/run/prediction.hpp"
#include "sim/run/prepare.hpp"
#include "sim/run/stage_clock.hpp"
#include "sim/run/tiles.hpp"

namespace nadir::sim {
namespace {

struct PlanOptions {
  std::filesystem::path scenario;
  GoalOptions goal;
  std::string format = "table";
  bool no_pilot = false;
  int threads = 0;
  std::uint64_t seed = 1;
};

void print_plan(const PlanOptions& options) {
  const ThreadLimit limit{options.threads};
  Diagnostics diagnostics;
  StageClock clock;
  RunRequest request;
  request.scenario = options.scenario;
  request.seed = options.seed;
  request.accuracy = options.goal.accuracy;
  request.time_s = options.goal.time_s;
  request.solve = !options.no_pilot;
  const PreparedRun run = prepare_run(request, clock, diagnostics);
  std::optional<Pilot> pilot;
  if (!options.no_pilot) {
    RenderOptions render = render_options(run, options.seed);
    render.threads = options.threads;
    pilot = run_pilot(run.world, render, PilotOptions{}, diagnostics);
  }
  PlanSheet sheet =
      plan_sheet({run, clock.stages(), options.goal.time_s, options.threads},
                 {options.goal.accuracy, options.goal.time_s}, pilot ? &*pilot : nullptr);
  sheet.warnings = diagnostics.messages();
  for (const std::string& warning : sheet.warnings) fmt::print(stderr, "warning: {}\n", warning);
  fmt::print("{}", options.format == "json" ? plan_json(sheet) : plan_text(sheet));
}

}  // namespace

void add_plan_command(CLI::App& app) {
  auto options = std::make_shared<PlanOptions>();
  CLI::App* command = app.add_subcommand(
      "plan", "What a run would simulate and leave out, why, and what it would take");
  command->add_option("scenario", options->scenario, "Scenario file (XML)")->required();
  add_goal_options(*command, options->goal);
  command->add_option("--format", options->format, "table or json [table]")
      ->check(CLI::IsMember({"table", "json"}));
  command->add_flag("--no-pilot", options->no_pilot,
                    "Render no pixels: no seconds, memory and errors are foretold");
  command->add_option("--threads", options->threads, "Threads; 0: one per processor [0]")
      ->check(CLI::Range(0, 1024));
  command->add_option("--seed", options->seed, "Seed of all random numbers [1]")
      ->check(CLI::Range(std::uint64_t{0}, std::uint64_t{0x7FFFFFFFFFFFFFFF}));
  command->callback([options] { print_plan(*options); });
}

}  // namespace nadir::sim
