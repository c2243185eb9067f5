#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/vec.hpp"
#include "thermal/solve/time_grid.hpp"

// Private to this folder.

namespace nadir::thermal {

/// sigma T^4 of a kind of surroundings at every stage, W m^-2.
struct EmissionSeries {
  std::vector<double> shaded;
  std::vector<double> lit;  ///< empty: the same as shaded
};

/// What all cells share at the stages of the steps.
struct SharedStages {
  /// The first day in long steps: each of its two stages is a weighted sum of the stages within, by
  /// which loads keep their mean and their trend.
  struct LongSteps {
    std::array<std::vector<double>, 2> weights;
    std::vector<double> mean;           ///< weights that keep the mean alone
    std::vector<WeatherState> weather;  ///< at each long stage: what all places share
  };

  /// Stages between which the scene does not change.
  struct Run {
    std::size_t begin = 0, end = 0;
    std::size_t epoch = 0;  ///< index into epochs
  };

  TimeGrid grid;
  std::vector<WeatherState> weather;
  std::vector<double> direct_normal, diffuse, sky_long_wave;  ///< as in weather, W m^-2
  std::vector<Between> sun;                                   ///< in the moments of the sun's track
  std::vector<Between> patch_sun;                             ///< in the moments of the patches
  std::vector<std::uint32_t> epochs;      ///< bits that occur in the track, in order of time
  std::vector<Run> runs;                  ///< epochs nearest in time
  std::vector<Vec3> patch_direction;      ///< to the sun at the patches' moments
  std::vector<double> patch_direct;       ///< direct light then; 0 with the sun below the horizon
  std::vector<double> level_cosine;       ///< of the sun at its track's moments, on level ground
  std::vector<float> level_patch_cosine;  ///< likewise at the patches' moments
  std::vector<EmissionSeries> surroundings;  ///< by material; `ground_about` last
  LongSteps long_steps;

  [[nodiscard]] std::size_t surroundings_index(std::uint32_t material) const noexcept {
    return material + 1ULL < surroundings.size() ? material : surroundings.size() - 1;
  }
};

/// All but the emission of surroundings that have a heat balance, which must be solved first.
[[nodiscard]] SharedStages make_shared_stages(const HeatModel& model);

}  // namespace nadir::thermal
