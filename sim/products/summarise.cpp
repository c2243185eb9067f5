#include <algorithm>
#include <cmath>

#include "sim/products/percentile.hpp"
#include "sim/products/report.hpp"

namespace nadir::sim {
namespace {

ValueRange range_of(const std::vector<float>& values) {
  ValueRange range;
  double sum = 0.0;
  std::uint64_t count = 0;
  for (const double value : values) {
    if (!std::isfinite(value)) continue;
    // fmin and fmax take the number where the other is NaN, which is how the range starts.
    range.least = std::fmin(range.least, value);
    range.greatest = std::fmax(range.greatest, value);
    sum += value;
    ++count;
  }
  if (count > 0) range.mean = sum / static_cast<double>(count);
  return range;
}

std::vector<float> relative_errors(const BandImage& band) {
  std::vector<float> errors;
  const std::size_t count = std::min(band.radiance.size(), band.standard_error.size());
  for (std::size_t i = 0; i < count; ++i) {
    const float relative = band.standard_error[i] / band.radiance[i];
    if (band.radiance[i] > 0.0F && std::isfinite(band.radiance[i]) && std::isfinite(relative)) {
      errors.push_back(relative);
    }
  }
  return errors;
}

std::uint64_t count_of(const std::vector<float>& values, bool (*condition)(float)) {
  return static_cast<std::uint64_t>(std::count_if(values.begin(), values.end(), condition));
}

BandSummary summarise(const BandImage& band) {
  BandSummary summary;
  summary.name = band.name;
  summary.centre_um = band.centre_um;
  summary.fwhm_um = band.fwhm_um;
  summary.radiance = range_of(band.radiance);
  std::vector<float> errors = relative_errors(band);
  summary.median_relative_error = percentile(errors, 0.5);
  summary.p95_relative_error = percentile(errors, 0.95);
  summary.brightness_temperature = range_of(band.brightness_temperature);
  summary.invalid_pixels = count_of(band.radiance, [](float v) { return !std::isfinite(v); });
  summary.negative_pixels = count_of(band.radiance, [](float v) { return v < 0.0F; });
  return summary;
}

std::uint64_t count_invalid_pixels(const ArrayImage& image) {
  std::uint64_t count = 0;
  for (std::size_t i = 0; i < image.pixels(); ++i) {
    count += std::any_of(image.bands.begin(), image.bands.end(), [i](const BandImage& band) {
      return i >= band.radiance.size() || !std::isfinite(band.radiance[i]);
    });
  }
  return count;
}

}  // namespace

ArraySummary summarise(const ArrayImage& image) {
  ArraySummary summary;
  summary.name = image.name;
  summary.samples = image.samples;
  summary.lines = image.lines;
  const auto& material = image.truth.material;
  if (!material.empty()) {
    const auto sky = std::count(material.begin(), material.end(), 0U);
    summary.surface_share = 1.0 - static_cast<double>(sky) / static_cast<double>(material.size());
  }
  summary.invalid_pixels = count_invalid_pixels(image);
  for (const BandImage& band : image.bands) summary.bands.push_back(summarise(band));
  return summary;
}

}  // namespace nadir::sim
