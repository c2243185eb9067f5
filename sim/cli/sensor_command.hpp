#pragma once

namespace CLI {
class App;
}

namespace nadir::sim {

/// `nadir sensor`: the data sheet of a sensor preset or of a scenario's camera.
void add_sensor_command(CLI::App& app);

}  // namespace nadir::sim
