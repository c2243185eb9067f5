#pragma once

#include <string>

#include "spectral/curve.hpp"
#include "spectral/lanes.hpp"

namespace nadir::spectral {

/// The curve at each lane, for a quantity that must be known at all of them.
/// @param what  names the quantity in the message, such as "the sun's irradiance"
/// @throws InputError where the curve does not cover the lanes
[[nodiscard]] Spectrum at_all(const Curve& curve, const Lanes& lanes, const std::string& what);

/// The curve for what a lane stands for: its mean over the lane's interval; at the wavelength alone
/// where there is none, or the curve does not reach over it. NaN outside the curve.
[[nodiscard]] double lane_mean(const Curve& curve, Micrometres wavelength,
                               const AbsorptionLane& lane);

/// The same at each lane, for light with lines as fine as the sun's.
/// @throws InputError where the curve does not cover the lanes
[[nodiscard]] Spectrum mean_at_all(const Curve& curve, const Lanes& lanes, const std::string& what);

}  // namespace nadir::spectral
