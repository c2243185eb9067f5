#pragma once

namespace CLI {
class App;
}

namespace nadir::sim {

/// `nadir merge A B [C...] -o OUT [-q]`: one picture from runs with different seeds.
void add_merge_command(CLI::App& app);

}  // namespace nadir::sim
