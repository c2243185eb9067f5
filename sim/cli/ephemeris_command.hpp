#pragma once

namespace CLI {
class App;
}

namespace nadir::sim {

/// `nadir ephemeris`: where the sun and the moon stand at a time and a site, how bright they are,
/// when they rise and set, as text or JSON.
void add_ephemeris_command(CLI::App& app);

}  // namespace nadir::sim
