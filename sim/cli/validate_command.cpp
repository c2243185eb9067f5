#include "sim/cli/validate_command.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "sim/run/load_camera.hpp"
#include "sim/run/run.hpp"
#include "sim/scenario/material_library.hpp"
#include "sim/scenario/read_scenario.hpp"
#include "sim/scenario/sensor_file.hpp"

namespace nadir::sim {
namespace {

std::string counted(std::uint64_t count, const std::string& one, const std::string& many) {
  return fmt::format("{} {}", count, count == 1 ? one : many);
}

std::string counted(std::uint64_t count, const std::string& thing) {
  return counted(count, thing, thing + "s");
}

std::string summary(const Validation& found) {
  return counted(found.objects, "object") + " of " +
         counted(found.represented_primitives, "triangle or shape", "triangles and shapes") + " (" +
         fmt::format("{} stored", found.stored_primitives) + "), " +
         counted(found.materials, "material") + ", " + counted(found.bands, "band") + " in " +
         counted(found.arrays, "array");
}

/// Prints what is right and what is doubtful. @throws InputError for what is wrong
void validate(const std::string& file) {
  if (is_material_library(file)) {
    fmt::print("{}: ok ({})\n", file, counted(read_material_library(file).size(), "material"));
    return;
  }
  if (is_sensor_file(file)) {
    InputFiles files;
    Diagnostics diagnostics;
    const Camera camera = load_sensor_file(file, files, diagnostics).camera;
    std::size_t bands = 0;
    for (const auto& array : camera.arrays) bands += array.bands.size();
    fmt::print("{}: ok ({} in {})\n", file, counted(bands, "band"),
               counted(camera.arrays.size(), "array"));
    return;
  }
  const Validation found = validate_scenario(file);
  fmt::print("{}: ok ({})\n", file, summary(found));
  for (const std::string& warning : found.warnings) fmt::print("  {}\n", warning);
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
