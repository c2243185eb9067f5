#pragma once

namespace CLI {
class App;
}

namespace nadir::sim {

/// `nadir schema --xsd|--reference`: the files that are generated from the scenario's table.
void add_schema_command(CLI::App& app);

}  // namespace nadir::sim
