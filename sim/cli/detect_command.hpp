#pragma once

namespace CLI {
class App;
}

namespace nadir::sim {

/// `nadir detect`: further noisy images of a scenario that was rendered.
void add_detect_command(CLI::App& app);

}  // namespace nadir::sim
