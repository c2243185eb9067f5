#pragma once

namespace CLI {
class App;
}

namespace nadir::sim {

/// nadir atmosphere table SCENARIO --out FILE
/// nadir atmosphere show FILE [--csv]
/// nadir atmosphere import --from tape7|modtran-csv|uvspec FILES... --out FILE
/// nadir atmosphere cache [--clear]
void add_atmosphere_command(CLI::App& app);

}  // namespace nadir::sim
