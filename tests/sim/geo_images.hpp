#pragma once

#include <fstream>

#include "sim/files/envi.hpp"
#include "sim/geo_scene.hpp"

namespace nadir::sim::support {

/// An ENVI image with the value `first + pixel + 1000 band` everywhere.
template <class Number>
void write_counting_image(const std::filesystem::path& image, const sensor::DetectorArray& array,
                          double first) {
  std::ofstream stream{image, std::ios::binary};
  const int pixels = array.samples * array.lines;
  for (std::size_t band = 0; band < array.bands.size(); ++band) {
    for (int i = 0; i < pixels; ++i) {
      const auto value = static_cast<Number>(first + i % 500 + 1000.0 * static_cast<double>(band));
      stream.write(reinterpret_cast<const char*>(&value), sizeof value);
    }
  }
  constexpr int type = std::is_same_v<Number, float> ? 4 : 12;
  std::ofstream{envi_header_of(image)}
      << "ENVI\nsamples = " << array.samples << "\nlines = " << array.lines
      << "\nbands = " << array.bands.size()
      << "\nheader offset = 0\nfile type = ENVI Standard\ndata type = " << type
      << "\ninterleave = bsq\nbyte order = 0\n";
}

}  // namespace nadir::sim::support
