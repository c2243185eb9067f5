#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "sim/products/band_choice.hpp"
#include "sim/run/image.hpp"

namespace nadir::sim {

/// As many pixels, or fewer, as are kept for pictures and percentiles.
inline constexpr std::size_t most_preview_pixels = 4'194'304;  // 2048 x 2048

/// The least whole number n so that every n-th sample of every n-th line are not more pixels than
/// that.
[[nodiscard]] int preview_step(int samples, int lines, std::size_t most_pixels);

/// Least and greatest of the finite values.
struct Extremes {
  double least = 0.0, greatest = 0.0;
  bool any = false;

  void add(const std::vector<float>& values);
  void add(const Extremes& other);
};

/// What holds for all pixels of an image, of bands that its quick look may show.
struct ShownFacts {
  BandChoice choice;
  std::vector<Extremes> extremes;  ///< of each band: radiance or, for Look::temperature, K
  std::size_t invalid_pixels = 0;  ///< that have no value to show
};

/// What a quick look needs of an image that comes in strips: the pixels of the bands that may be
/// shown, all of them or every n-th of every n-th line, and what holds for all.
class Preview {
 public:
  /// @param first        the first strip
  /// @param wanted       bands, as in QuickLookOptions
  /// @param most_pixels  how many are kept at most
  Preview(const ArrayImage& first, const std::vector<std::string>& wanted,
          std::size_t most_pixels = most_preview_pixels);
  /// The strips in their order, the first included.
  void take(const ArrayImage& strip);

  /// The kept pixels; planes that no quick look needs are empty.
  [[nodiscard]] const ArrayImage& image() const noexcept { return image_; }
  [[nodiscard]] int step() const noexcept { return step_; }
  /// Of one of the choices of `choices_of`. @throws std::out_of_range for others
  [[nodiscard]] const ShownFacts& facts(const BandChoice& choice) const;

 private:
  int step_ = 1;
  ArrayImage image_;
  std::vector<std::size_t> bands_;  // whose pixels are kept
  std::vector<ShownFacts> facts_;
};

/// Appends those values of a strip's plane that a preview keeps.
template <class Number>
void append_every(int step, const ArrayImage& strip, const std::vector<Number>& plane,
                  std::vector<Number>& kept) {
  if (plane.empty()) return;
  if (step == 1) {
    kept.insert(kept.end(), plane.begin(), plane.end());
    return;
  }
  const auto width = static_cast<std::size_t>(strip.samples), n = static_cast<std::size_t>(step);
  for (int line = 0; line < strip.lines; ++line) {
    if ((strip.first_line + line) % step != 0) continue;
    const std::size_t row = static_cast<std::size_t>(line) * width;
    for (std::size_t sample = 0; sample < width; sample += n) kept.push_back(plane[row + sample]);
  }
}

}  // namespace nadir::sim
