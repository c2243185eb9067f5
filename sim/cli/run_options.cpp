#include "sim/cli/run_options.hpp"

#include <CLI/CLI.hpp>
#include <string>

#include "core/error.hpp"
#include "sim/run/accuracy_options.hpp"

namespace nadir::sim {
namespace {

/// Reads an option's text, and tells of a mistake as the option's.
template <class Parse>
auto reading(std::optional<double>& value, const std::string& name, Parse parse) {
  return [&value, name, parse](const std::string& text) {
    try {
      value = parse(text);
    } catch (const InputError& error) {
      throw CLI::ValidationError{name, error.issues().front().message};
    }
  };
}

}  // namespace

void add_goal_options(CLI::App& command, GoalOptions& options) {
  command
      .add_option_function<std::string>(
          "--accuracy", reading(options.accuracy, "--accuracy", parse_accuracy),
          "Standard error that every band of every pixel is sampled to, relative to its radiance "
          "or the floor (1%, 0.01); solver and wavelengths are chosen")
      ->type_name("SHARE");
  command
      .add_option_function<std::string>("--time", reading(options.time_s, "--time", parse_duration),
                                        "Time that the whole may take (60s, 10min, 1h30min)")
      ->type_name("TIME");
}

}  // namespace nadir::sim
