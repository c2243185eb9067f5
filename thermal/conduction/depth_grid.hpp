#pragma once

#include <cstddef>
#include <vector>

#include "thermal/conduction/layers.hpp"

namespace nadir::thermal {

/// How finely a stack is cut.
struct GridSettings {
  double first_fraction = 0.05;  ///< first interval over the damping depth of a day
  double growth = 1.3;           ///< of each interval over the one above it, within a layer
  int least_per_layer = 1;       ///< intervals
};

/// Nodes of a stack: at the surface, at every joint of layers, and graded between. Each node holds
/// the heat of the half intervals beside it. Thin layers that conduct so well that they have one
/// temperature get a single interval.
///
/// Depth is counted in damping depths of a day, layer by layer: xi = sum of L / d. An interval that
/// begins at xi is at most first_fraction + (growth - 1) xi long: that is what intervals grow to in
/// a uniform ground, and it makes what lies beneath a thin sheet as fine as its depth asks for, not
/// as fine as the sheet.
///
/// A stack behind an open back has one node. So has a stack that conducts so well that its Biot
/// number is below 0.01 (L / k below 4e-4 m2 K/W: 18 mm of steel; some 0.1 K at 500 W m^-2), unless
/// its back has a given temperature.
///
/// The deepest node of a stack on a fixed temperature has that temperature and no heat of its own.
struct DepthGrid {
  std::vector<double> depth_m;             ///< of the nodes, 0 first
  std::vector<double> conductance_w_m2_k;  ///< between neighbours, nodes - 1
  std::vector<double> capacity_j_m2_k;     ///< of each node
  std::vector<double> heat_w_m2;           ///< released at each node

  [[nodiscard]] std::size_t nodes() const noexcept { return depth_m.size(); }
};

/// More nodes than any sensible stack has: scratch memory is on the stack.
inline constexpr std::size_t most_nodes = 128;

/// @throws InputError for settings out of range, for more than most_nodes nodes, and whatever
///         check(stack) refuses
[[nodiscard]] DepthGrid make_grid(const LayerStack& stack, const GridSettings& settings = {});

}  // namespace nadir::thermal
