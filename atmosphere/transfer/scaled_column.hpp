#pragma once

#include <vector>

#include "atmosphere/optical_column.hpp"

namespace nadir::atmosphere {

/// A column whose scattering in the narrow forward peak counts as no scattering at all (delta-M):
/// of each kind the share f = chi_M goes straight on, with M the number of streams,
///
///     s' = s (1 - f),   chi'_l = (chi_l - f) / (1 - f),   absorption unchanged.
///
/// Everything that is computed of the field of scattered light, also along paths, goes by these
/// depths. First scattering alone keeps the true phase function: s P = s' P / (1 - f) (the "TMS"
/// correction). What rays look up, the transmittance between two points, is that of the true
/// column; the peak's share of the ground's light, T' - T, is then part of the path's light.
/// Source: Wiscombe, J. Atmos. Sci. 34, 1408 (1977); Nakajima & Tanaka, JQSRT 40, 51 (1988).
struct ScaledColumn {
  OpticalColumn column;      ///< depths scaled; the kinds' phase functions are the true ones
  std::vector<double> peak;  ///< f, by kind
};

[[nodiscard]] ScaledColumn delta_scaled(const OpticalColumn& column, int streams);

}  // namespace nadir::atmosphere
