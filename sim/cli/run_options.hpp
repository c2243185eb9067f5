#pragma once

#include <optional>

namespace CLI {
class App;
}

namespace nadir::sim {

/// What a run is asked to reach.
struct GoalOptions {
  std::optional<double> accuracy;  ///< relative standard error
  std::optional<double> time_s;    ///< wall clock
};

/// Adds --accuracy and --time to a command. Text that is no accuracy or no time ends with exit
/// code 2.
/// @param options  must outlive the parsing
void add_goal_options(CLI::App& command, GoalOptions& options);

}  // namespace nadir::sim
