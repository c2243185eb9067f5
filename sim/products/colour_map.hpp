#pragma once

#include "sim/products/canvas.hpp"

namespace nadir::sim {

/// "Inferno", a map from black through red to pale yellow in which equal steps look equal, also in
/// grey and to the colour-blind.
///
/// @param fraction  0 .. 1; values beyond are clamped, NaN gives `invalid_colour`
/// Accuracy: within 1.2 of 255 of the published table of 256 colours.
/// Source: S. van der Walt and N. Smith, "mpl colormaps" (2015), https://bids.github.io/colormap;
/// licence CC0 1.0. Every fifth colour of their table, linear between.
[[nodiscard]] Rgb inferno(double fraction);

/// What a value that is no number is painted with. Neither the map nor a scene holds it.
inline constexpr Rgb invalid_colour{255, 0, 255};

}  // namespace nadir::sim
