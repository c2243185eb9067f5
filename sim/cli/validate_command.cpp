#include "sim/cli/validate_command.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <string>
#include <vector>

#include "core/diagnostics.hpp"
#include "core/error.hpp"
#include "sim/scenario/material_library.hpp"
#include "sim/scenario/read_scenario.hpp"

namespace nadir::sim {
namespace {

std::string counted(std::size_t count, const std::string& thing) {
  return fmt::format("{} {}{}", count, thing, count == 1 ? "" : "s");
}

std::string summary(const Scenario& scenario) {
  std::size_t bands = 0;
  for (const ArrayInput& array : scenario.camera.arrays) bands += array.bands.size();
  return counted(scenario.geometry.size(), "object") + ", " +
         counted(scenario.materials.size(), "material") + ", " + counted(bands, "band") + " in " +
         counted(scenario.camera.arrays.size(), "array");
}

/// Prints what is right and what is doubtful. @throws InputError for what is wrong
void validate(const std::string& file) {
  if (is_material_library(file)) {
    fmt::print("{}: ok ({})\n", file, counted(read_material_library(file).size(), "material"));
    return;
  }
  Diagnostics diagnostics;
  const Scenario scenario = read_scenario(file, diagnostics);
  fmt::print("{}: ok ({})\n", file, summary(scenario));
  for (const std::string& message : diagnostics.messages()) fmt::print("  {}\n", message);
}

}  // namespace

void add_validate_command(CLI::App& app) {
  auto files = std::make_shared<std::vector<std::string>>();
  CLI::App* command = app.add_subcommand("validate", "Check scenario files and material libraries");
  command->add_option("FILE", *files, "Scenarios or material libraries")->required();
  command->callback([files] {
    std::vector<InputIssue> mistakes;
    for (const std::string& file : *files) {
      try {
        validate(file);
      } catch (const InputError& error) {
        mistakes.insert(mistakes.end(), error.issues().begin(), error.issues().end());
      }
    }
    std::fflush(stdout);  // what is right is shown before what is wrong, even in one log
    if (!mistakes.empty()) throw InputError{std::move(mistakes)};
  });
}

}  // namespace nadir::sim
