#include "sim/cli/run_command.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>

#include "sim/cli/exit_codes.hpp"
#include "sim/run/accuracy_options.hpp"
#include "sim/run/progress.hpp"
#include "sim/run/run.hpp"

namespace nadir::sim {
namespace {

struct RunCommandOptions {
  RunOptions run;
  std::optional<std::string> accuracy, time;  // as typed
  int audit = -1;                             // as many pixels as 3 % of the run pay for
  bool quiet = false;
};

void print_outcome(const RunOutcome& outcome) {
  const RunReport& report = outcome.report;
  double render_s = 0.0;
  for (const StageTime& stage : report.stages) {
    if (stage.name == "render") render_s = stage.wall_s;
  }
  const double rays = static_cast<double>(report.counters.at("rays"));
  fmt::print("rendered in {:.1f} s, {:.1f} million rays\n", render_s, rays * 1e-6);
  for (const ArraySummary& array : report.arrays) {
    for (const BandSummary& band : array.bands) {
      fmt::print(
          "  {:<10} {:<16} {:8.4f} um   mean {:10.4g} W m^-2 sr^-1 um^-1   "
          "median error {:5.2f} %\n",
          array.name, band.name, band.centre_um, band.radiance.mean,
          100.0 * band.median_relative_error);
    }
  }
  for (const FileRecord& product : report.products) fmt::print("{}\n", product.path.string());
  fmt::print("{}\n", outcome.report_file.string());
}

/// What was typed as numbers, and a folder where none was named.
void settle(RunCommandOptions& options) {
  RunOptions& run = options.run;
  if (run.output.empty()) run.output = std::filesystem::path{"out"} / run.scenario.stem();
  if (options.accuracy) run.accuracy = parse_accuracy(*options.accuracy);
  if (options.time) run.time_s = parse_duration(*options.time);
  if (options.audit >= 0) run.audit = options.audit;
}

void check_finite(const RunReport& report) {
  for (const ArraySummary& array : report.arrays) {
    if (array.invalid_pixels == 0) continue;
    throw std::runtime_error{fmt::format("{} pixels of array {} have no finite radiance",
                                         array.invalid_pixels, array.name)};
  }
}

void run_scenario(RunCommandOptions options) {
  settle(options);
  Progress progress{stderr, Progress::style_for(stderr, options.quiet)};
  options.run.progress = [&](std::size_t done, std::size_t all) { progress.update(done, all); };
  if (!options.quiet) {
    options.run.tell = [](const std::string& line) { fmt::print(stderr, "{}\n", line); };
  }
  const RunOutcome outcome = run_scenario(options.run);
  for (const std::string& warning : outcome.report.warnings) {
    fmt::print(stderr, "warning: {}\n", warning);
  }
  if (!options.quiet) print_outcome(outcome);
  check_finite(outcome.report);
  if (outcome.broken_promises.empty()) return;
  for (const std::string& promise : outcome.broken_promises) fmt::print(stderr, "{}\n", promise);
  throw PromiseNotKept{};
}

}  // namespace

void add_run_command(CLI::App& app) {
  auto options = std::make_shared<RunCommandOptions>();
  CLI::App* command = app.add_subcommand("run", "Render a scenario into band images");
  command->add_option("scenario", options->run.scenario, "Scenario file (XML)")->required();
  command->add_option("-o,--output", options->run.output,
                      "Folder for the products [out/<scenario's file name>]");
  // Up to 2^63 - 1, the largest that every reader of the report's JSON can hold; refuses negatives.
  command->add_option("--seed", options->run.seed, "Seed of all random numbers [1]")
      ->check(CLI::Range(std::uint64_t{0}, std::uint64_t{0x7FFFFFFFFFFFFFFF}));
  command
      ->add_option("--noise-seed", options->run.noise_seed,
                   "Seed of the detectors' noise, apart from the render's [1]")
      ->check(CLI::Range(std::uint64_t{0}, std::uint64_t{0x7FFFFFFFFFFFFFFF}));
  command->add_option("--threads", options->run.threads, "Threads; 0: one per processor [0]")
      ->check(CLI::Range(0, 1024));
  command->add_option("--accuracy", options->accuracy,
                      "Sample every band of every pixel to this relative standard error, as 1%; "
                      "solver and wavelengths are chosen");
  command->add_option("--time", options->time,
                      "Sample until the run has taken so long, as 60s or 10min; solver and "
                      "wavelengths are chosen");
  command
      ->add_option("--audit", options->audit,
                   "Pixels to be rendered again with the effects that were left out; 0: none "
                   "[as many as 3 % of the run's time pay for]")
      ->check(CLI::Range(0, 100000000));
  CLI::Option* more =
      command->add_flag("--more", options->run.more, "Add as many samples again to a finished run");
  command
      ->add_flag("--fresh", options->run.fresh,
                 "Start over: forget what an earlier run has left in the folder")
      ->excludes(more);
  command->add_flag("-q,--quiet", options->quiet, "Print warnings and errors only");
  command->callback([options] { run_scenario(*options); });
}

}  // namespace nadir::sim
