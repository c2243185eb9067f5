#include "sim/cli/detect_command.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>

#include "core/diagnostics.hpp"
#include "sim/run/detect.hpp"

namespace nadir::sim {
namespace {

struct DetectOptions {
  std::filesystem::path scenario, output;
  std::uint64_t seed = 1;
};

void detect(const DetectOptions& options) {
  const std::filesystem::path output = options.output.empty()
                                           ? std::filesystem::path{"out"} / options.scenario.stem()
                                           : options.output;
  Diagnostics diagnostics;
  const auto written = detect_again(options.scenario, output, options.seed, diagnostics);
  for (const std::string& warning : diagnostics.messages()) {
    fmt::print(stderr, "warning: {}\n", warning);
  }
  for (const std::filesystem::path& file : written) fmt::print("{}\n", file.string());
}

}  // namespace

void add_detect_command(CLI::App& app) {
  auto options = std::make_shared<DetectOptions>();
  CLI::App* command = app.add_subcommand(
      "detect", "Another noisy image of what a run has rendered: one render, many images");
  command->add_option("scenario", options->scenario, "Scenario file (XML)")->required();
  command->add_option("-o,--output", options->output,
                      "Folder of the run's products [out/<scenario's file name>]");
  command->add_option("--seed", options->seed, "Seed of the detectors' noise")
      ->required()
      ->check(CLI::Range(std::uint64_t{0}, std::uint64_t{0x7FFFFFFFFFFFFFFF}));
  command->callback([options] { detect(*options); });
}

}  // namespace nadir::sim
