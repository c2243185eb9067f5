#include "sim/run/strips.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

namespace nadir::sim {
namespace {

template <class Number>
void append_plane(std::vector<Number>& plane, const std::vector<Number>& more) {
  plane.insert(plane.end(), more.begin(), more.end());
}

/// The planes of a band that are floats, but for its shares.
constexpr auto float_planes = std::to_array<std::vector<float> BandImage::*>(
    {&BandImage::radiance, &BandImage::standard_error, &BandImage::brightness_temperature,
     &BandImage::brightness_temperature_error, &BandImage::bias, &BandImage::electrons,
     &BandImage::noise});

/// Where a tile lies in a strip.
struct Inset {
  std::size_t strip_samples, samples, lines, first;
};

template <class Number>
void paste_plane(std::vector<Number>& plane, const std::vector<Number>& tile, const Inset& inset) {
  if (plane.empty() || tile.empty()) return;
  for (std::size_t line = 0; line < inset.lines; ++line) {
    std::copy_n(
        tile.begin() + static_cast<std::ptrdiff_t>(line * inset.samples), inset.samples,
        plane.begin() + static_cast<std::ptrdiff_t>(inset.first + line * inset.strip_samples));
  }
}

void paste_band(BandImage& band, const BandImage& tile, const Inset& inset) {
  for (const auto plane : float_planes) paste_plane(band.*plane, tile.*plane, inset);
  paste_plane(band.dn, tile.dn, inset);
  paste_plane(band.shares.path, tile.shares.path, inset);
  paste_plane(band.shares.emission, tile.shares.emission, inset);
}

void paste_truth(TruthImage& truth, const TruthImage& tile, const Inset& inset) {
  paste_plane(truth.material, tile.material, inset);
  paste_plane(truth.object, tile.object, inset);
  for (const auto& plane : truth_planes) {
    paste_plane(truth.*plane.values, tile.*plane.values, inset);
  }
  for (const auto& plane : place_planes) {
    paste_plane(truth.*plane.values, tile.*plane.values, inset);
  }
  for (std::size_t i = 0; i < truth.fractions.size(); ++i) {
    paste_plane(truth.fractions[i], tile.fractions[i], inset);
  }
}

void paste_paths(ArrayImage& strip, const ArrayImage& tile, const Inset& inset) {
  if (strip.pixel_paths.empty()) return;
  std::vector<std::uint32_t> paths;
  for (std::size_t pixel = 0; pixel < tile.pixels(); ++pixel) paths.push_back(tile.paths_of(pixel));
  paste_plane(strip.pixel_paths, paths, inset);
}

void append_band(BandImage& band, const BandImage& more) {
  for (const auto plane : float_planes) append_plane(band.*plane, more.*plane);
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

void paste(ArrayImage& strip, const ArrayImage& tile) {
  const auto size = [](int number) { return static_cast<std::size_t>(number); };
  const Inset inset{size(strip.samples), size(tile.samples), size(tile.lines),
                    size(tile.first_line - strip.first_line) * size(strip.samples) +
                        size(tile.first_sample - strip.first_sample)};
  for (std::size_t i = 0; i < strip.bands.size(); ++i) {
    paste_band(strip.bands[i], tile.bands[i], inset);
  }
  paste_truth(strip.truth, tile.truth, inset);
  paste_paths(strip, tile, inset);
}

void append(ArrayImage& image, const ArrayImage& strip) {
  for (std::size_t i = 0; i < image.bands.size(); ++i) append_band(image.bands[i], strip.bands[i]);
  append_plane(image.pixel_paths, strip.pixel_paths);
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
