#pragma once

#include <cstdint>
#include <vector>

#include "sim/run/probe.hpp"

namespace nadir::sim {

struct PilotOptions {
  int most_pixels = 256;
  double most_cpu_s = 1.0;  ///< stops adding pixels then; the first few are always looked at
};

/// What a few random pixels, sampled with few paths, say of a picture.
struct Pilot {
  std::vector<ProbedPixel> pixels;
  std::vector<double> seconds_per_path;  ///< by array, of one processor; NaN: no pixel of it seen
  radiometry::Counters counters;
  double paths = 0.0;  ///< of all pixels
  double cpu_s = 0.0, wall_s = 0.0;
  /// Of it, what the first pixels took when they were rendered for the first time and not again
  /// later: temperatures that had to be solved, memory that had to be touched.
  double first_touch_s = 0.0;
};

/// Samples random pixels of a finished world, a few at first, then as many as time allows.
/// @param options  of the render: its effects, plan, bending and seed; its sampling and goal are
///                 replaced by 8 replicates of 2 to 64 paths
[[nodiscard]] Pilot run_pilot(const World& world, const RenderOptions& options,
                              const PilotOptions& limits, Diagnostics& diagnostics);

}  // namespace nadir::sim
