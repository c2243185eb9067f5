#pragma once

namespace CLI {
class App;
}

namespace nadir::sim {

/// nadir materials [NAME] [--library FILE] [--format text|json]
/// nadir materials therm FILE [--output FILE.csv]
void add_materials_command(CLI::App& app);

}  // namespace nadir::sim
