#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/statistics.hpp"
#include "radiometry/counters.hpp"
#include "sim/plan/camera_plan.hpp"
#include "sim/run/render.hpp"
#include "sim/run/world.hpp"

namespace nadir::sim {

/// A pixel of the camera's.
struct PixelPlace {
  int array = 0, sample = 0, line = 0;
};

/// What was found at one pixel, by band.
struct ProbedPixel {
  PixelPlace place;
  std::vector<Estimate> bands;                  ///< W m^-2 sr^-1 um^-1
  std::vector<std::vector<double>> replicates;  ///< [band][replicate]: means of the replicates
  std::uint32_t paths = 0;                      ///< sampled
  double cpu_s = 0.0;                           ///< processor time it took
};
struct ProbeResult {
  std::vector<ProbedPixel> pixels;  ///< in the order asked for
  radiometry::Counters counters;
  double cpu_s = 0.0, wall_s = 0.0;
};

/// Renders chosen pixels of a finished world (its air solved) with exactly the random numbers that
/// a run with these options would use. Truth planes are not computed.
[[nodiscard]] ProbeResult probe_pixels(const World& world, const RenderOptions& options,
                                       std::span<const PixelPlace> places,
                                       Diagnostics& diagnostics);

/// Pixels drawn at random over all arrays, in proportion to their pixels but at least one of each
/// array where `count` allows; each at most once, in the order of arrays, lines and samples.
[[nodiscard]] std::vector<PixelPlace> random_pixels(const World& world, int count,
                                                    std::uint64_t seed);

}  // namespace nadir::sim
