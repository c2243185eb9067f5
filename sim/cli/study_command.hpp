#pragma once

namespace CLI {
class App;
}

namespace nadir::sim {

void add_study_command(CLI::App& app);

}  // namespace nadir::sim
