#pragma once

namespace CLI {
class App;
}

namespace nadir::sim {

/// `nadir project`: where places appear in the image, and what the image shows where.
void add_project_command(CLI::App& app);

}  // namespace nadir::sim
