#pragma once

#include <vector>

#include "atmosphere/optical_column.hpp"

namespace nadir::atmosphere {

/// What a column of air sends to the ground at one wavelength and absorption term.
struct ColumnFluxes {
  /// Of each height of the sun: what reaches the ground unscattered, on a plane normal to it, and
  /// what of its light is scattered onto level ground; both per irradiance outside the air.
  std::vector<double> direct, diffuse;
  double spherical_albedo = 0.0;  ///< share of what level ground sends up that comes back
  double emitted = 0.0;           ///< irradiance of level ground, in the unit of pi times Planck's
};

/// Irradiances alone: the mean over azimuth by discrete ordinates (discrete_ordinates.hpp), for all
/// heights of the sun and the air's emission in one solution, over black ground. The narrow forward
/// peak of scattering, which the scaled column counts as direct, is diffuse here.
///
/// @param cos_zenith  of the sun at the ground, -1 to 1; its light comes on a path through shells
/// @param planck      radiance of a black body at each level (layers + 1); empty: no emission
/// @param streams     even, 2 to 128
[[nodiscard]] ColumnFluxes column_fluxes(const OpticalColumn& column,
                                         const std::vector<double>& cos_zenith,
                                         const std::vector<double>& planck, int streams);

}  // namespace nadir::atmosphere
