#include <algorithm>
#include <cmath>
#include <limits>

#include "sim/products/percentile.hpp"
#include "sim/products/report.hpp"
#include "sim/products/running_summary.hpp"

namespace nadir::sim {
namespace {

/// NaN where there is none: a radiance that is not above 0, or no numbers at all.
float relative_error(const BandImage& band, std::size_t pixel) {
  const float relative = band.standard_error[pixel] / band.radiance[pixel];
  const bool has =
      band.radiance[pixel] > 0.0F && std::isfinite(band.radiance[pixel]) && std::isfinite(relative);
  return has ? relative : std::numeric_limits<float>::quiet_NaN();
}

std::uint64_t count_of(const std::vector<float>& values, bool (*condition)(float)) {
  return static_cast<std::uint64_t>(std::count_if(values.begin(), values.end(), condition));
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

void RunningSummary::Range::add(double value) {
  if (!std::isfinite(value)) return;
  // fmin and fmax take the number where the other is NaN, which is how the range starts.
  range.least = std::fmin(range.least, value);
  range.greatest = std::fmax(range.greatest, value);
  sum += value;
  ++count;
}

ValueRange RunningSummary::Range::finish() const {
  ValueRange finished = range;
  if (count > 0) finished.mean = sum / static_cast<double>(count);
  return finished;
}

RunningSummary::RunningSummary(const ArrayImage& first,
                               std::vector<std::optional<std::uint16_t>> top_dn,
                               std::size_t most_pixels)
    : step_{preview_step(first.samples, first.image_lines(), most_pixels)},
      top_dn_{std::move(top_dn)} {
  summary_.name = first.name;
  summary_.samples = first.samples;
  summary_.lines = first.image_lines();
  top_dn_.resize(first.bands.size());
  for (std::size_t b = 0; b < first.bands.size(); ++b) {
    BandSummary& band = bands_.emplace_back().summary;
    band.name = first.bands[b].name;
    band.centre_um = first.bands[b].centre_um;
    band.fwhm_um = first.bands[b].fwhm_um;
    if (top_dn_[b]) bands_[b].numbers.saturated_pixels = 0;
  }
}

void RunningSummary::take_band(const ArrayImage& strip, std::size_t b) {
  const BandImage& band = strip.bands.at(b);
  RunningBand& running = bands_.at(b);
  for (const float value : band.radiance) running.radiance.add(value);
  for (const float value : band.brightness_temperature) running.brightness.add(value);
  for (const std::uint16_t number : band.dn) {
    running.dn.add(number);
    if (number == 0) ++running.numbers.zero_pixels;
    if (top_dn_[b] && number >= *top_dn_[b]) ++*running.numbers.saturated_pixels;
  }
  running.summary.invalid_pixels +=
      count_of(band.radiance, [](float v) { return !std::isfinite(v); });
  running.summary.negative_pixels += count_of(band.radiance, [](float v) { return v < 0.0F; });

  room_.resize(std::min(band.radiance.size(), band.standard_error.size()));
  for (std::size_t i = 0; i < room_.size(); ++i) room_[i] = relative_error(band, i);
  auto& errors = running.relative_errors;
  const auto kept = static_cast<std::ptrdiff_t>(errors.size());
  append_every(step_, strip, room_, errors);
  errors.erase(
      std::remove_if(errors.begin() + kept, errors.end(), [](float e) { return std::isnan(e); }),
      errors.end());
}

void RunningSummary::take(const ArrayImage& strip) {
  const auto& material = strip.truth.material;
  seen_ += material.size();
  sky_ += static_cast<std::uint64_t>(std::count(material.begin(), material.end(), 0U));
  summary_.invalid_pixels += count_invalid_pixels(strip);
  for (std::size_t b = 0; b < bands_.size(); ++b) take_band(strip, b);
}

ArraySummary RunningSummary::finish() {
  if (seen_ > 0) {
    summary_.surface_share = 1.0 - static_cast<double>(sky_) / static_cast<double>(seen_);
  }
  for (RunningBand& running : bands_) {
    BandSummary& band = running.summary;
    band.radiance = running.radiance.finish();
    band.brightness_temperature = running.brightness.finish();
    band.median_relative_error = percentile(running.relative_errors, 0.5);
    band.p95_relative_error = percentile(running.relative_errors, 0.95);
    if (running.dn.count > 0) {
      running.numbers.range = running.dn.finish();
      band.dn = running.numbers;
    }
    summary_.bands.push_back(std::move(band));
    running.relative_errors = {};  // megabytes that nobody needs any more
  }
  return std::move(summary_);
}

ArraySummary summarise(const ArrayImage& image) {
  RunningSummary summary{image, {}, std::numeric_limits<std::size_t>::max()};
  summary.take(image);
  return summary.finish();
}

}  // namespace nadir::sim
