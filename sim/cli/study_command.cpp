#include "sim/cli/study_command.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <memory>

#include "sim/run/progress.hpp"
#include "sim/study/run_study.hpp"

namespace nadir::sim {
namespace {

struct StudyCommandOptions {
  StudyOptions study;
  std::string budget = "10min";
  bool quiet = false;
};

void print_advice(const Recommendation& advice) {
  if (!advice.reached) {
    fmt::print("  {:>4g} %  {}\n", 100.0 * advice.target, advice.reason);
    return;
  }
  fmt::print("  {:>4g} %  {}; {} x {} paths a pixel, picture in {}\n", 100.0 * advice.target,
             readable(advice.settings), advice.replicates, advice.samples,
             readable_duration(advice.picture_s));
}

void run_study_command(StudyCommandOptions options) {
  options.study.budget_s = budget_from(options.budget);
  if (options.study.output.empty()) {
    options.study.output =
        std::filesystem::path{"out"} / (options.study.scenario.stem().string() + "-study");
  }
  if (!options.quiet) {
    options.study.tell = [](const std::string& text) { fmt::print(stderr, "{}\n", text); };
  }
  const StudyOutcome outcome = run_study(options.study);
  for (const std::string& warning : outcome.warnings) fmt::print(stderr, "warning: {}\n", warning);
  if (options.quiet) return;
  fmt::print("{} rows {} {}; for an error of\n", outcome.result.rows.size(),
             outcome.measured ? "measured in" : "had been measured in",
             readable_duration(outcome.spent_s));
  for (const Recommendation& advice : outcome.result.recommendations) print_advice(advice);
  for (const auto& file : outcome.files) fmt::print("{}\n", file.string());
}

}  // namespace

void add_study_command(CLI::App& app) {
  auto options = std::make_shared<StudyCommandOptions>();
  CLI::App* command =
      app.add_subcommand("study", "What accuracy costs in time: sweeps settings, recommends some");
  command->add_option("scenario", options->study.scenario, "Scenario file (XML)")->required();
  command->add_option("-b,--budget", options->budget,
                      "Time for everything: 90s, 10min, 1h [10min]");
  command->add_option("-o,--output", options->study.output,
                      "Folder for the pages [out/<scenario's file name>-study]");
  command
      ->add_option("--pixels", options->study.pixels,
                   "Pixels to study; 0: as the budget allows [0]")
      ->check(CLI::Range(0, 100000));
  command->add_option("--seed", options->study.seed, "Seed of all random numbers [1]")
      ->check(CLI::Range(std::uint64_t{0}, std::uint64_t{0x7FFFFFFFFFFFFFFF}));
  command->add_option("--threads", options->study.threads, "Threads; 0: one per processor [0]")
      ->check(CLI::Range(0, 1024));
  command->add_flag("-q,--quiet", options->quiet, "Print warnings and errors only");
  command->callback([options] { run_study_command(*options); });
}

}  // namespace nadir::sim
