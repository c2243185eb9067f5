#pragma once

#include "atmosphere/make/lane_views.hpp"

namespace nadir::atmosphere {

// Irradiance of level ground by what one lane scatters out of a beam: int L d(sin^2 z) dphi / 2 by
// the trapezoid rule over the sky's own nodes. Good to 2 % with 12 nodes and more for a sky without
// sharp peaks.

/// With the body above the horizon the narrow peak about it is not resolved.
[[nodiscard]] double body_sky_flux(const LaneFields& fields, const ViewShape& shape,
                                   const LaneView& sky, const LaneFields::Beam& beam);

}  // namespace nadir::atmosphere
