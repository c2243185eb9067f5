#pragma once

#include <cstdint>
#include <utility>
#include <vector>

namespace nadir::sim {

/// A pixel of an array's image.
struct StudyPixel {
  int sample = 0, line = 0;
  [[nodiscard]] bool operator==(const StudyPixel&) const = default;
};

/// An image's size in pixels.
struct ImageSize {
  int samples = 0, lines = 0;
  [[nodiscard]] std::uint64_t pixels() const noexcept {
    return static_cast<std::uint64_t>(samples) * static_cast<std::uint64_t>(lines);
  }
};

/// Pixels of an image, stratified: it is cut into bands of lines, each band into cells, so that
/// there are `count` cells, nearly square and nearly alike, and one pixel is drawn in each. Each
/// pixel at most once, in the order of lines; all of them where there are no more than `count`.
[[nodiscard]] std::vector<StudyPixel> stratified_pixels(const ImageSize& image, int count,
                                                        std::uint64_t seed);

/// Shares pixels out among images in proportion to their sizes, but at least a quarter of an equal
/// share to each, and to none more than it has.
[[nodiscard]] std::vector<int> share_pixels(const std::vector<ImageSize>& images, int count);

}  // namespace nadir::sim
