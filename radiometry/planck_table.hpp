#pragma once

#include <vector>

#include "core/quantity.hpp"
#include "spectral/lanes.hpp"

namespace nadir::radiometry {

/// Planck's radiance at the lanes, tabulated over the temperatures of a grid: the function itself
/// costs as much as several rays.
///
/// Cubic between nodes that are as near to each other as the shortest lane needs. Relative error
/// below 1e-4 wherever the radiance is above 1e-35 W m^-2 sr^-1 um^-1, any wavelengths and
/// temperatures; tested for 0.3 .. 14 um.
class PlanckTable {
 public:
  struct Reach {
    Kelvin coldest, hottest;
  };
  PlanckTable(const spectral::Lanes& lanes, const Reach& reach);

  /// @param temperature_k  within the table's reach; 0 below what radiates at all
  [[nodiscard]] spectral::Spectrum at(double temperature_k) const noexcept;

 private:
  int lanes_ = 0, nodes_ = 0;
  double shortest_k_ = 0.0;  // c2 / lambda of the shortest lane
  double least_k_ = 0.0, first_ = 0.0;
  std::vector<float> value_;  // lane fastest; node 1 stands at `first_`
};

}  // namespace nadir::radiometry
