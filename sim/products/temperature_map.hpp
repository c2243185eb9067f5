#pragma once

#include <vector>

#include "sim/products/tone_map.hpp"
#include "sim/run/image.hpp"

namespace nadir::sim {

/// The temperatures at the ends of a colour map.
struct TemperatureRange {
  double lo_k = 0.0, hi_k = 0.0;
};

/// Brightness temperatures of a band in K, from its plane or, where that is missing, from its
/// radiance at the centre wavelength. NaN where the radiance is no finite number or negative.
[[nodiscard]] std::vector<float> temperatures_of(const BandImage& band);

/// From the 0.5th to the 99.5th percentile of the pixels that see a surface (see
/// `surface_pixels`), widened to 2 K at least, lest noise of a uniform scene look like a pattern.
[[nodiscard]] TemperatureRange temperature_range(const ArrayImage& image,
                                                 const std::vector<float>& temperature_k);

/// Paints temperatures through `inferno`, clamped at the range's ends; NaN in `invalid_colour`.
[[nodiscard]] Picture temperature_map(const std::vector<float>& temperature_k,
                                      TemperatureRange range);

/// Round values from lo to hi, 1, 2 or 5 times a power of ten apart, at most `most` of them.
[[nodiscard]] std::vector<double> round_ticks(double lo, double hi, int most);

}  // namespace nadir::sim
