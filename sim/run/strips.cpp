#include "sim/run/strips.hpp"

#include <algorithm>

namespace nadir::sim {
namespace {

template <class Number>
void append_plane(std::vector<Number>& plane, const std::vector<Number>& more) {
  plane.insert(plane.end(), more.begin(), more.end());
}

void append_band(BandImage& band, const BandImage& more) {
  for (auto plane :
       {&BandImage::radiance, &BandImage::standard_error, &BandImage::brightness_temperature,
        &BandImage::brightness_temperature_error, &BandImage::electrons, &BandImage::noise}) {
    append_plane(band.*plane, more.*plane);
  }
  append_plane(band.dn, more.dn);
  append_plane(band.shares.path, more.shares.path);
  append_plane(band.shares.emission, more.shares.emission);
}

}  // namespace

std::vector<Strip> cut_into_strips(int samples, int lines, int unit) {
  constexpr int least_pixels = 1 << 17;
  const int units = std::max(1, (least_pixels / samples + unit - 1) / unit);
  const int each = units * unit;
  std::vector<Strip> strips;
  for (int line = 0; line < lines; line += each) {
    strips.push_back({line, std::min(each, lines - line)});
  }
  return strips;
}

void append(ArrayImage& image, const ArrayImage& strip) {
  for (std::size_t i = 0; i < image.bands.size(); ++i) append_band(image.bands[i], strip.bands[i]);
  append_plane(image.truth.material, strip.truth.material);
  append_plane(image.truth.object, strip.truth.object);
  for (const auto& plane : truth_planes) {
    append_plane(image.truth.*plane.values, strip.truth.*plane.values);
  }
  for (const auto& plane : place_planes) {
    append_plane(image.truth.*plane.values, strip.truth.*plane.values);
  }
  for (std::size_t i = 0; i < image.truth.fractions.size(); ++i) {
    append_plane(image.truth.fractions[i], strip.truth.fractions[i]);
  }
  image.lines += strip.lines;
}

}  // namespace nadir::sim
