#pragma once

#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "core/error.hpp"
#include "core/quantity.hpp"
#include "geometry/region.hpp"
#include "materials/volume/medium.hpp"

// Participating volumes as a scenario describes them: plain data.

namespace nadir::radiometry {

/// Values at cell centres of a regular grid that fills the box of its region; x fastest, then y,
/// then z; interpolated linearly between centres, held beyond the outer ones.
struct ScalarGrid {
  int columns = 0, rows = 0, layers = 0;  ///< along x, y, z of the region's own axes
  std::vector<float> value;
};

struct Volume {
  std::string name;
  geometry::Region region;
  materials::Medium medium;
  std::shared_ptr<const ScalarGrid> density;  ///< factor on the coefficients, >= 0; null: 1
  std::variant<Kelvin, std::shared_ptr<const ScalarGrid>> temperature = Kelvin{0.0};
  SourceLocation where{};
};

}  // namespace nadir::radiometry
