#pragma once

namespace CLI {
class App;
}

namespace nadir::sim {

/// `nadir temperature`: the diurnal curve of a place of a scene, with its heat balance.
void add_temperature_command(CLI::App& app);

}  // namespace nadir::sim
