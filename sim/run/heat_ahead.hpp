#pragma once

#include "sim/products/report.hpp"
#include "sim/run/world.hpp"

namespace nadir::sim {

/// Solves the heat balance of what the first path of every pixel meets, all of it in parallel, so
/// that few rays of the picture have to wait for a temperature. Nothing where no band sees heat.
void solve_heat_ahead(const World& world, std::uint64_t seed);

/// Tells of solved temperatures that are not what the scenario asks for: held at a limit, not
/// repeating their day.
void tell_of_heat(const World& world, Diagnostics& diagnostics);

/// What the heat balance of a world that has one has cost so far, and how good it is.
[[nodiscard]] ReportValues heat_report(const World& world);

}  // namespace nadir::sim
