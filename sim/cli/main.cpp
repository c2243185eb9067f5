#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <cstdio>
#include <exception>

#include "core/error.hpp"
#include "sim/cli/atmosphere_command.hpp"
#include "sim/cli/detect_command.hpp"
#include "sim/cli/ephemeris_command.hpp"
#include "sim/cli/exit_codes.hpp"
#include "sim/cli/materials_command.hpp"
#include "sim/cli/merge_command.hpp"
#include "sim/cli/plan_command.hpp"
#include "sim/cli/project_command.hpp"
#include "sim/cli/run_command.hpp"
#include "sim/cli/schema_command.hpp"
#include "sim/cli/sensor_command.hpp"
#include "sim/cli/study_command.hpp"
#include "sim/cli/temperature_command.hpp"
#include "sim/cli/validate_command.hpp"

namespace {

int run(int argc, char** argv) {
  CLI::App app{"Nadir: the image that a satellite, aircraft or drone camera would take of a place"};
  app.name("nadir");
  app.set_version_flag("--version", "nadir " NADIR_VERSION);
  app.require_subcommand(1);
  nadir::sim::add_run_command(app);
  nadir::sim::add_validate_command(app);
  nadir::sim::add_atmosphere_command(app);
  nadir::sim::add_detect_command(app);
  nadir::sim::add_ephemeris_command(app);
  nadir::sim::add_materials_command(app);
  nadir::sim::add_merge_command(app);
  nadir::sim::add_plan_command(app);
  nadir::sim::add_project_command(app);
  nadir::sim::add_schema_command(app);
  nadir::sim::add_sensor_command(app);
  nadir::sim::add_study_command(app);
  nadir::sim::add_temperature_command(app);
  try {
    app.parse(argc, argv);
    return nadir::sim::exit_done;
  } catch (const CLI::ParseError& error) {
    const int code = app.exit(error);  // prints help, version or what is wrong
    return code == 0 ? nadir::sim::exit_done : nadir::sim::exit_bad_input;
  }
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const nadir::InputError& error) {
    fmt::print(stderr, "{}", error.what());
    return nadir::sim::exit_bad_input;
  } catch (const nadir::sim::PromiseNotKept&) {
    return nadir::sim::exit_promise_not_kept;
  } catch (const std::exception& error) {
    fmt::print(stderr, "nadir: {}\n", error.what());
    return nadir::sim::exit_our_fault;
  }
}
