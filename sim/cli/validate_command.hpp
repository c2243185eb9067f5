#pragma once

namespace CLI {
class App;
}

namespace nadir::sim {

/// `nadir validate FILE...`: checks scenarios and material libraries. Mistakes leave the callback
/// as one InputError for all files.
void add_validate_command(CLI::App& app);

}  // namespace nadir::sim
