#pragma once

#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <type_traits>
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

/// Every plane that an image can have, each with numbers of its own; bands B1 .. at 0.48, 0.56,
/// 0.655 and 10.9 um, the last without a detector.
inline ArrayImage full_array(int samples, int lines) {
  ArrayImage image = synthetic_array(samples, lines, {0.48, 0.56, 0.655, 10.9});
  image.paths = 8;
  const std::size_t pixels = image.pixels();
  float next = 1.0F;
  const auto fill = [&](auto& plane) {
    using Number = typename std::decay_t<decltype(plane)>::value_type;
    next += 1.0F;
    for (std::size_t i = 0; i < pixels; ++i) {
      plane.push_back(static_cast<Number>(next + static_cast<float>(i % 1000)));
    }
  };
  for (BandImage& band : image.bands) {
    if (band.centre_um > 3.0) {
      fill(band.brightness_temperature_error);
    } else {
      fill(band.dn);
      fill(band.electrons);
      fill(band.noise);
    }
    for (const float radiance : band.radiance) {
      band.shares.path.push_back(0.25F * radiance);
      band.shares.emission.push_back(0.5F * radiance);
    }
  }
  TruthImage& truth = image.truth;
  truth.object_names = {"house"};
  for (std::size_t i = 0; i < pixels; ++i) truth.object.push_back(static_cast<unsigned>(i % 2));
  for (const auto& plane : truth_planes) {
    if ((truth.*plane.values).empty()) fill(truth.*plane.values);
  }
  for (const auto& plane : place_planes) fill(truth.*plane.values);
  truth.fractions.resize(1 + truth.material_names.size());
  for (auto& plane : truth.fractions) fill(plane);
  return image;
}

/// Some lines of an image.
inline ArrayImage strip_of(const ArrayImage& image, int first_line, int lines) {
  ArrayImage strip = image;
  strip.lines = lines;
  strip.first_line = first_line;
  strip.all_lines = image.lines;
  const auto width = static_cast<std::ptrdiff_t>(image.samples);
  const auto cut = [&](auto& plane) {
    if (plane.empty()) return;
    const auto begin = plane.begin() + first_line * width;
    plane = std::decay_t<decltype(plane)>(begin, begin + lines * width);
  };
  for (BandImage& band : strip.bands) {
    for (auto* plane : {&band.radiance, &band.standard_error, &band.brightness_temperature,
                        &band.brightness_temperature_error, &band.shares.path,
                        &band.shares.emission, &band.electrons, &band.noise}) {
      cut(*plane);
    }
    cut(band.dn);
  }
  cut(strip.truth.material);
  cut(strip.truth.object);
  for (const auto& plane : truth_planes) cut(strip.truth.*plane.values);
  for (const auto& plane : place_planes) cut(strip.truth.*plane.values);
  for (auto& plane : strip.truth.fractions) cut(plane);
  return strip;
}

}  // namespace nadir::sim::support
