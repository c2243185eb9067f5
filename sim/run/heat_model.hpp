#pragma once

#include "sim/run/load_heat.hpp"
#include "thermal/solve/heat_model.hpp"

namespace nadir::sim {

/// Everything that the heat balance needs, read and put together: weather, the sun's way, layers
/// with their substances, what the materials absorb and emit.
/// @param known  by material: how warm those are that are not solved, as their neighbours see them
/// @throws InputError
[[nodiscard]] thermal::HeatModel load_heat_model(
    const Scenario& scenario, const HeatScene& scene,
    const std::vector<thermal::SurroundingSurface>& known, InputFiles& files,
    Diagnostics& diagnostics);

/// The weather from `history_s` before the picture on.
struct HeatWeather {
  thermal::Weather weather;
  double history_s = 86400.0;
};
/// As far back as the scenario says, or else as the layers remember and the weather reaches.
/// @param least_s  how far back it must reach in any case
[[nodiscard]] HeatWeather load_heat_weather(const Scenario& scenario, double least_s,
                                            InputFiles& files, Diagnostics& diagnostics,
                                            const std::vector<thermal::LayerStack>& stacks = {});

}  // namespace nadir::sim
