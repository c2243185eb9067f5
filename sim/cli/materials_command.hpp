#pragma once

namespace CLI {
class App;
}

namespace nadir::sim {

/// nadir materials [NAME] [--library FILE] [--format text|json]
void add_materials_command(CLI::App& app);

}  // namespace nadir::sim
