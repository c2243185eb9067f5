#pragma once

#include <string>

#include "spectral/curve.hpp"
#include "spectral/lanes.hpp"

namespace nadir::spectral {

/// The curve at each lane, for a quantity that must be known at all of them.
/// @param what  names the quantity in the message, such as "the sun's irradiance"
/// @throws InputError where the curve does not cover the lanes
[[nodiscard]] Spectrum at_all(const Curve& curve, const Lanes& lanes, const std::string& what);

}  // namespace nadir::spectral
