#pragma once

namespace CLI {
class App;
}

namespace nadir::sim {

/// nadir run SCENARIO [--output DIR] [--seed N] [--threads N] [--quiet]
void add_run_command(CLI::App& app);

}  // namespace nadir::sim
