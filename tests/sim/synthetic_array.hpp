#pragma once

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "sim/run/image.hpp"

namespace nadir::sim::support {

inline constexpr float nan_value = std::numeric_limits<float>::quiet_NaN();

/// An array of bands B1, B2, ... at these centres. Radiance rises from pixel to pixel, with the
/// band as its hundreds; the first line sees the sky.
inline ArrayImage synthetic_array(int samples, int lines, const std::vector<double>& centres_um) {
  ArrayImage image;
  image.name = "cam";
  image.samples = samples;
  image.lines = lines;
  const std::size_t pixels = image.pixels();
  for (std::size_t b = 0; b < centres_um.size(); ++b) {
    BandImage band;
    band.name = "B" + std::to_string(b + 1);
    band.centre_um = centres_um[b];
    band.fwhm_um = 0.06;
    for (std::size_t i = 0; i < pixels; ++i) {
      band.radiance.push_back(static_cast<float>(100 * (b + 1)) + static_cast<float>(i));
      band.standard_error.push_back(0.01F * band.radiance.back());
      if (band.centre_um > 3.0) {
        band.brightness_temperature.push_back(280.0F + static_cast<float>(i) * 0.1F);
      }
    }
    image.bands.push_back(band);
  }
  image.truth.material_names = {"grass", "roof, tiled"};
  for (std::size_t i = 0; i < pixels; ++i) {
    const bool sky = i < static_cast<std::size_t>(samples);
    image.truth.material.push_back(sky ? 0U : 1U + static_cast<std::uint32_t>(i % 2));
    image.truth.range_m.push_back(sky ? nan_value : 1000.0F + static_cast<float>(i));
    image.truth.temperature_k.push_back(sky ? nan_value : 290.0F);
    image.truth.sun_elevation_deg.push_back(sky ? nan_value : 30.0F);
    image.truth.shadow_fraction.push_back(sky ? nan_value : 0.25F);
  }
  return image;
}

}  // namespace nadir::sim::support
