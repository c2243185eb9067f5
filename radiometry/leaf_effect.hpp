#pragma once

#include <vector>

#include "materials/bound_material.hpp"
#include "spectral/lanes.hpp"

namespace nadir::radiometry {

struct LeafScene {
  const std::vector<materials::Material>& materials;
  const std::vector<materials::BoundMaterial>& bound;  ///< the same, at the lanes
  const spectral::Lanes& lanes;
};

/// The materials with leaves that let nothing through: their reflectance stays, and so does the
/// emissivity, which is not to be asked of mixtures here (theirs follows from what they scatter).
/// Panes and solids of glass stay as they are. Empty where no material has a leaf that transmits.
[[nodiscard]] std::vector<materials::BoundMaterial> without_leaf_transmission(
    const LeafScene& scene);

}  // namespace nadir::radiometry
