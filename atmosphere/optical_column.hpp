#pragma once

#include <memory>
#include <vector>

#include "atmosphere/particles/phase_function.hpp"

namespace nadir::atmosphere {

/// The air at one wavelength and one absorption term: what light meets from the top of the air
/// (level 0) down to the ground (the last level). Within a layer everything is mixed evenly and
/// optical depth grows evenly with height: make layers thin where the air changes fast.
struct OpticalColumn {
  /// One kind of scatterer: air molecules, the haze of one altitude range, a cloud.
  struct Kind {
    std::vector<double> scattering;  ///< vertical optical depth by layer
    std::shared_ptr<const PhaseFunction> phase;
  };
  std::vector<double> level_height_m;       ///< layers + 1, descending
  std::vector<double> level_temperature_k;  ///< layers + 1
  std::vector<double> absorption;  ///< vertical optical depth by layer, gases and particles
  std::vector<Kind> kinds;         ///< the first is Rayleigh scattering; those that matter nowhere
                                   ///< are left out by whoever makes the column

  [[nodiscard]] int layers() const { return static_cast<int>(absorption.size()); }
  [[nodiscard]] double scattering(int layer) const {
    double sum = 0.0;
    for (const Kind& kind : kinds) sum += kind.scattering[static_cast<std::size_t>(layer)];
    return sum;
  }
  [[nodiscard]] double depth(int layer) const {
    return absorption[static_cast<std::size_t>(layer)] + scattering(layer);
  }
};

}  // namespace nadir::atmosphere
