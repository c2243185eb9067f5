#pragma once

#include <cstddef>
#include <vector>

#include "sim/files/air_runs.hpp"

// The runs from one height as a grid of directions: a part of table_of_runs.

namespace nadir::sim {

/// Two neighbours on an axis and the share of the second; the ends are held.
struct NodePair {
  std::size_t first = 0, second = 0;
  double share = 0.0;
};
[[nodiscard]] NodePair node_pair(const std::vector<double>& nodes, double at);

struct GridSettings {
  double ground_m = 0.0, top_m = 0.0;
  std::size_t lanes = 0;
  bool sunlit = false;
  bool sky = false;  ///< whole radiances; else sources, and the horizon where there are both sides
};

/// @param runs  from one height, within the air; whole ways have infinite length
/// @throws InputError  that lists missing runs; runs that give the same twice
[[nodiscard]] atmosphere::AirTable::View view_of_runs(const std::vector<AirRun>& runs,
                                                      const GridSettings& settings);

}  // namespace nadir::sim
