#include "thermal/conduction/depth_grid.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/error.hpp"

namespace nadir::thermal {
namespace {

constexpr Seconds day{86400.0};

void check_settings(const GridSettings& settings) {
  if (!(std::isfinite(settings.first_fraction) && settings.first_fraction > 0.0)) {
    throw InputError("the first interval of the depth grid must be positive and finite");
  }
  if (!(std::isfinite(settings.growth) && settings.growth >= 1.0)) {
    throw InputError("the growth of the depth grid's intervals must be at least 1 and finite");
  }
  if (settings.least_per_layer < 1) {
    throw InputError("a layer needs at least one interval of the depth grid");
  }
}

/// Everything at one temperature: see DepthGrid.
bool is_lumped(const LayerStack& stack) {
  if (std::holds_alternative<OpenBack>(stack.back)) return true;
  if (std::holds_alternative<FixedBack>(stack.back)) return false;
  constexpr double resistance_limit_m2_k_w = 4e-4;  // Biot number 0.01 at 25 W m^-2 K^-1
  double resistance = 0.0;
  for (const Layer& layer : stack.layers) {
    resistance += layer.thickness_m / layer.substance.conductivity_w_m_k;
  }
  return resistance <= resistance_limit_m2_k_w;
}

DepthGrid lumped(const LayerStack& stack) {
  DepthGrid grid{{0.0}, {}, {0.0}, {0.0}};
  for (const Layer& layer : stack.layers) {
    grid.capacity_j_m2_k[0] += layer.substance.heat_capacity_j_m3_k() * layer.thickness_m;
    grid.heat_w_m2[0] += layer.heat_w_m2;
  }
  return grid;
}

/// Intervals of geometric growth from `first` on that fill `length`: their number, before rounding.
double intervals_needed(double length, double first, double growth) {
  const double ratio = length / first;
  const double slope = growth - 1.0;
  return slope * ratio < 1e-6 ? ratio : std::log1p(slope * ratio) / std::log1p(slope);
}

/// Shares of a layer's thickness, growing geometrically, 1 in sum.
std::vector<double> graded_shares(std::size_t count, double growth) {
  std::vector<double> shares(count);
  double size = 1.0, sum = 0.0;
  for (double& share : shares) {
    share = size;
    sum += size;
    size *= growth;
  }
  for (double& share : shares) share /= sum;
  return shares;
}

void append_interval(DepthGrid& grid, const Layer& layer, double share) {
  const double length = share * layer.thickness_m;
  const double half_capacity = 0.5 * length * layer.substance.heat_capacity_j_m3_k();
  const double half_heat = 0.5 * share * layer.heat_w_m2;
  grid.depth_m.push_back(grid.depth_m.back() + length);
  grid.conductance_w_m2_k.push_back(layer.substance.conductivity_w_m_k / length);
  grid.capacity_j_m2_k.back() += half_capacity;
  grid.heat_w_m2.back() += half_heat;
  grid.capacity_j_m2_k.push_back(half_capacity);
  grid.heat_w_m2.push_back(half_heat);
}

[[noreturn]] void too_many() {
  throw InputError("the layers would have more than " + std::to_string(most_nodes) +
                   " nodes: let the intervals of the depth grid grow faster or begin larger");
}

}  // namespace

DepthGrid make_grid(const LayerStack& stack, const GridSettings& settings) {
  check(stack);
  check_settings(settings);
  if (is_lumped(stack)) return lumped(stack);
  DepthGrid grid{{0.0}, {}, {0.0}, {0.0}};
  double xi = 0.0;  // depth in damping depths
  for (const Layer& layer : stack.layers) {
    const double length = layer.thickness_m / damping_depth(layer.substance, day).value;
    const double first = settings.first_fraction + (settings.growth - 1.0) * xi;
    const double needed = std::max(intervals_needed(length, first, settings.growth),
                                   static_cast<double>(settings.least_per_layer));
    if (!(needed < most_nodes)) too_many();
    const auto count = static_cast<std::size_t>(std::ceil(needed));
    for (const double share : graded_shares(count, settings.growth)) {
      append_interval(grid, layer, share);
    }
    xi += length;
    if (grid.nodes() > most_nodes) too_many();
  }
  if (std::holds_alternative<FixedBack>(stack.back)) grid.capacity_j_m2_k.back() = 0.0;
  return grid;
}

}  // namespace nadir::thermal
