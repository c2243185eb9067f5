#include "sim/run/pixel_needs.hpp"

#include <algorithm>
#include <cmath>

#include "sim/run/brightness.hpp"
#include "sim/run/tiles.hpp"

namespace nadir::sim {

double paths_needed(const ArrayImage& image, std::size_t pixel,
                    const std::vector<BandGoal>& goals) {
  double most = 0.0;
  for (std::size_t b = 0; b < goals.size(); ++b) {
    const BandImage& band = image.bands[b];
    const double ratio =
        static_cast<double>(band.standard_error[pixel]) / goals[b].error_of(band.radiance[pixel]);
    if (std::isfinite(ratio)) most = std::max(most, ratio * ratio);
  }
  return most * image.paths_of(pixel);
}

double mean_need(const ArrayImage& image, const std::vector<BandGoal>& goals, double most_paths) {
  double sum = 0.0;
  for (std::size_t pixel = 0; pixel < image.pixels(); ++pixel) {
    sum += std::min(paths_needed(image, pixel, goals), most_paths);
  }
  return sum / static_cast<double>(std::max<std::size_t>(image.pixels(), 1));
}

void state_need(ArrayImage& image, std::size_t pixel, const std::vector<BandGoal>& goals,
                const PixelNeed& stated_need) {
  const double paths = image.paths_of(pixel);
  for (std::size_t b = 0; b < goals.size(); ++b) {
    BandImage& band = image.bands[b];
    const double own = band.standard_error[pixel];
    const double stated =
        goals[b].error_of(band.radiance[pixel]) * std::sqrt(stated_need.paths / paths);
    if (!(stated > own)) continue;
    band.standard_error[pixel] = static_cast<float>(stated);
    if (band.brightness_temperature_error.empty() || b >= stated_need.quadratures.size()) continue;
    const Estimate kelvin =
        brightness_temperature(stated_need.quadratures[b], {band.radiance[pixel], stated});
    band.brightness_temperature_error[pixel] = static_cast<float>(kelvin.standard_error);
  }
}

void state_needs_of_blocks(ArrayImage& image, const std::vector<BandGoal>& goals,
                           std::span<const spectral::BandQuadrature> quadratures) {
  constexpr int edge = 8;
  constexpr double share = 0.5;
  for (const Tile& block : cut_into_tiles(0, image.samples, image.lines, edge)) {
    std::vector<std::size_t> pixels;
    double need = 0.0;
    for (int line = block.first_line; line < block.first_line + block.lines; ++line) {
      for (int sample = block.first_sample; sample < block.first_sample + block.samples; ++sample) {
        const auto pixel =
            static_cast<std::size_t>(line) * static_cast<std::size_t>(image.samples) +
            static_cast<std::size_t>(sample);
        if (image.paths_of(pixel) == 0) continue;
        pixels.push_back(pixel);
        need += paths_needed(image, pixel, goals);
      }
    }
    const double least =
        share * need / static_cast<double>(std::max<std::size_t>(pixels.size(), 1));
    for (const std::size_t pixel : pixels) state_need(image, pixel, goals, {least, quadratures});
  }
}

}  // namespace nadir::sim
