#pragma once

#include <vector>

#include "atmosphere/particles/particles.hpp"
#include "atmosphere/profile.hpp"

namespace nadir::atmosphere {

/// Heights of the levels that a scene's column has, descending from 100 km (or the profile's top,
/// if that is lower) to the ground, m above sea level. Fine where haze lies, with levels at the
/// edges of haze and clouds. Dense haze and clouds are cut so that the layers at their edges, where
/// scattered light changes fastest, are optically thin (0.25 of scaled depth) and double inwards.
/// Levels of the profile are added where temperature strays by more than 1 K from a straight line.
/// 25 to 45 layers; one grid for all wavelengths.
/// @throws InputError  ground below what the profile reaches down to, or above its last level
[[nodiscard]] std::vector<double> column_levels_m(const Profile& profile, const Aerosol& aerosol,
                                                  const std::vector<Cloud>& clouds,
                                                  double ground_m);

}  // namespace nadir::atmosphere
