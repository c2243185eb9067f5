#include "sim/study/study_pixels.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "core/random.hpp"

namespace nadir::sim {
namespace {

/// Where a cell of a row or column of `cells` begins.
int edge(int cell, int cells, int length) {
  return static_cast<int>(static_cast<std::int64_t>(cell) * length / cells);
}

/// A number of [lo, hi), which is not empty.
int drawn_in(int lo, int hi, Rng& random) {
  const int offset = static_cast<int>(random.next() * (hi - lo));
  return std::min(lo + offset, hi - 1);
}

}  // namespace

std::vector<StudyPixel> stratified_pixels(const ImageSize& image, int count, std::uint64_t seed) {
  std::set<std::pair<int, int>> drawn;  // line and sample
  Rng random{seed, 0};
  const auto wanted = static_cast<std::size_t>(
      std::min<std::uint64_t>(image.pixels(), static_cast<std::uint64_t>(std::max(0, count))));
  if (wanted > 0) {
    // Bands of lines, each cut into its own number of cells, so that they are as many as wanted.
    const double ratio = static_cast<double>(image.lines) / image.samples;
    const int bands = std::clamp(static_cast<int>(std::lround(std::sqrt(count * ratio))), 1,
                                 std::min(image.lines, static_cast<int>(wanted)));
    for (int b = 0; b < bands; ++b) {
      const int cells = std::min(image.samples, edge(b + 1, bands, static_cast<int>(wanted)) -
                                                    edge(b, bands, static_cast<int>(wanted)));
      for (int c = 0; c < cells; ++c) {
        const int line =
            drawn_in(edge(b, bands, image.lines), edge(b + 1, bands, image.lines), random);
        const int sample =
            drawn_in(edge(c, cells, image.samples), edge(c + 1, cells, image.samples), random);
        drawn.insert({line, sample});
      }
    }
  }
  // An image narrower than its cells leaves some over: anywhere.
  while (drawn.size() < wanted) {
    drawn.insert({drawn_in(0, image.lines, random), drawn_in(0, image.samples, random)});
  }
  std::vector<StudyPixel> places;
  for (const auto& [line, sample] : drawn) places.push_back({sample, line});
  return places;
}

std::vector<int> share_pixels(const std::vector<ImageSize>& images, int count) {
  double all = 0.0;
  for (const ImageSize& image : images) all += static_cast<double>(image.pixels());
  const double least = 0.25 * count / static_cast<double>(images.size());
  std::vector<int> shares;
  for (const ImageSize& image : images) {
    const double pixels = static_cast<double>(image.pixels());
    const double share = std::max({1.0, least, count * pixels / all});
    shares.push_back(static_cast<int>(std::min(pixels, std::round(share))));
  }
  return shares;
}

}  // namespace nadir::sim
