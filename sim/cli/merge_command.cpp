#include "sim/cli/merge_command.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <string>

#include "sim/cli/exit_codes.hpp"
#include "sim/run/merge_runs.hpp"
#include "sim/run/progress.hpp"

namespace nadir::sim {
namespace {

struct MergeCommandOptions {
  MergeOptions merge;
  bool quiet = false;
};

void print_merged(const RunOutcome& outcome) {
  for (const ArraySummary& array : outcome.report.arrays) {
    for (const BandSummary& band : array.bands) {
      fmt::print("  {:<10} {:<16} median error {:5.2f} %\n", array.name, band.name,
                 100.0 * band.median_relative_error);
    }
  }
  for (const FileRecord& product : outcome.report.products) {
    fmt::print("{}\n", product.path.string());
  }
  fmt::print("{}\n", outcome.report_file.string());
}

void merge_from_command_line(MergeCommandOptions options) {
  Progress progress{stderr, Progress::style_for(stderr, options.quiet)};
  options.merge.progress = [&](std::size_t done, std::size_t all) { progress.update(done, all); };
  options.merge.tell = [&](const std::string& line) {
    if (!options.quiet) fmt::print(stderr, "{}\n", line);
  };
  const RunOutcome outcome = merge_runs(options.merge);
  for (const std::string& warning : outcome.report.warnings) {
    fmt::print(stderr, "warning: {}\n", warning);
  }
  if (!options.quiet) print_merged(outcome);
  if (outcome.broken_promises.empty()) return;
  for (const std::string& promise : outcome.broken_promises) fmt::print(stderr, "{}\n", promise);
  throw PromiseNotKept{};
}

}  // namespace

void add_merge_command(CLI::App& app) {
  auto options = std::make_shared<MergeCommandOptions>();
  CLI::App* command = app.add_subcommand(
      "merge", "One picture from runs of one scenario with different seeds, and its error");
  command->add_option("runs", options->merge.runs, "Folders of two runs or more")
      ->required()
      ->expected(2, 1000);
  command->add_option("-o,--output", options->merge.output, "Folder for the merged run")
      ->required();
  command
      ->add_option("--noise-seed", options->merge.noise_seed,
                   "Seed of the detectors' noise, apart from the render's [1]")
      ->check(CLI::Range(std::uint64_t{0}, std::uint64_t{0x7FFFFFFFFFFFFFFF}));
  command->add_option("--threads", options->merge.threads, "Threads; 0: one per processor [0]")
      ->check(CLI::Range(0, 1024));
  command->add_flag("-q,--quiet", options->quiet, "Print warnings and errors only");
  command->callback([options] { merge_from_command_line(*options); });
}

}  // namespace nadir::sim
