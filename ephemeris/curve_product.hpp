#pragma once

#include <functional>
#include <vector>

#include "spectral/curve.hpp"

namespace nadir::ephemeris {

/// The rule outside its table that a curve's values there tell. Where both ends are 0, `zero` and
/// `hold` are the same curve.
[[nodiscard]] spectral::Outside outside_of(const spectral::Curve& curve);

/// A curve times a factor that varies with wavelength, tabulated at the curve's own wavelengths and
/// at those given that it covers. Keeps the curve's rule outside; a constant becomes a table over
/// the given wavelengths, whose ends hold beyond.
/// @param at_um  strictly ascending, at least two
[[nodiscard]] spectral::Curve product(const spectral::Curve& curve,
                                      const std::vector<double>& at_um,
                                      const std::function<double(Micrometres)>& factor);

}  // namespace nadir::ephemeris
