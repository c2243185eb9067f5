#include "sim/cli/schema_command.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "sim/scenario/write_reference.hpp"
#include "sim/scenario/write_xsd.hpp"

namespace nadir::sim {

void add_schema_command(CLI::App& app) {
  struct Options {
    bool xsd = false, reference = false;
  };
  auto options = std::make_shared<Options>();
  CLI::App* command =
      app.add_subcommand("schema", "Writes the scenario's schema or reference page");
  command->group("");  // for Nadir's developers: not in the help
  CLI::Option_group* which = command->add_option_group("output");
  which->add_flag("--xsd", options->xsd, "The XML Schema: scenes/schema/nadir.xsd");
  which->add_flag("--reference", options->reference, "The page: docs/scenario-reference.md");
  which->require_option(1);
  command->callback(
      [options] { fmt::print("{}", options->xsd ? write_xsd() : write_reference()); });
}

}  // namespace nadir::sim
