#include "sim/run/pixel_needs.hpp"

#include <algorithm>
#include <cmath>

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

double mean_need(const ArrayImage& image, const std::vector<BandGoal>& goals) {
  double sum = 0.0;
  for (std::size_t pixel = 0; pixel < image.pixels(); ++pixel) {
    sum += paths_needed(image, pixel, goals);
  }
  return sum / static_cast<double>(std::max<std::size_t>(image.pixels(), 1));
}

void state_need(ArrayImage& image, std::size_t pixel, const std::vector<BandGoal>& goals,
                double need) {
  const double paths = image.paths_of(pixel);
  for (std::size_t b = 0; b < goals.size(); ++b) {
    BandImage& band = image.bands[b];
    const double own = band.standard_error[pixel];
    const double stated = goals[b].error_of(band.radiance[pixel]) * std::sqrt(need / paths);
    if (!(stated > own)) continue;
    band.standard_error[pixel] = static_cast<float>(stated);
    if (band.brightness_temperature_error.empty()) continue;
    // To first order, error / radiance is the same share of either; an own error of 0 has none.
    float& kelvin = band.brightness_temperature_error[pixel];
    if (own > 0.0) kelvin = static_cast<float>(kelvin * (stated / own));
  }
}

}  // namespace nadir::sim
