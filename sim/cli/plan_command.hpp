#pragma once

namespace CLI {
class App;
}

namespace nadir::sim {

/// nadir plan SCENARIO [--accuracy 1%] [--time 60s] [--format table|json] [--no-pilot]
///            [--threads N] [--seed N]
void add_plan_command(CLI::App& app);

}  // namespace nadir::sim
