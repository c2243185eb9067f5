#include "sim/products/preview.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>

#include "sim/products/temperature_map.hpp"

namespace nadir::sim {
namespace {

int every(int count, int step) { return (count + step - 1) / step; }

std::size_t pixels_at(int samples, int lines, int step) {
  return static_cast<std::size_t>(every(samples, step)) *
         static_cast<std::size_t>(every(lines, step));
}

/// Pixels of which any of the bands has no finite radiance.
std::size_t count_invalid(const ArrayImage& strip, const std::vector<std::size_t>& bands) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < strip.pixels(); ++i) {
    count += std::any_of(bands.begin(), bands.end(), [&](std::size_t band) {
      return !std::isfinite(strip.bands[band].radiance[i]);
    });
  }
  return count;
}

void add_strip(const ArrayImage& strip, ShownFacts& facts) {
  const auto& bands = facts.choice.bands;
  if (facts.choice.look == Look::temperature) {
    const std::vector<float> temperature_k = temperatures_of(strip.bands[bands[0]]);
    facts.extremes[0].add(temperature_k);
    facts.invalid_pixels += static_cast<std::size_t>(
        std::count_if(temperature_k.begin(), temperature_k.end(),
                      [](float kelvin) { return !std::isfinite(kelvin); }));
    return;
  }
  for (std::size_t c = 0; c < bands.size(); ++c) {
    facts.extremes[c].add(strip.bands[bands[c]].radiance);
  }
  facts.invalid_pixels += count_invalid(strip, bands);
}

}  // namespace

int preview_step(int samples, int lines, std::size_t most_pixels) {
  int step = 1;
  while (step < std::max(samples, lines) && pixels_at(samples, lines, step) > most_pixels) ++step;
  return step;
}

void Extremes::add(const std::vector<float>& values) {
  for (const float value : values) {
    if (!std::isfinite(value)) continue;
    least = any ? std::min<double>(least, value) : value;
    greatest = any ? std::max<double>(greatest, value) : value;
    any = true;
  }
}

void Extremes::add(const Extremes& other) {
  if (!other.any) return;
  least = any ? std::min(least, other.least) : other.least;
  greatest = any ? std::max(greatest, other.greatest) : other.greatest;
  any = true;
}

Preview::Preview(const ArrayImage& first, const std::vector<std::string>& wanted,
                 std::size_t most_pixels)
    : step_{preview_step(first.samples, first.image_lines(), most_pixels)} {
  image_.name = first.name;
  image_.samples = every(first.samples, step_);
  image_.lines = every(first.image_lines(), step_);
  for (const BandImage& band : first.bands) {
    BandImage& kept = image_.bands.emplace_back();
    kept.name = band.name;
    kept.centre_um = band.centre_um;
    kept.fwhm_um = band.fwhm_um;
  }
  std::set<std::size_t> bands;
  for (BandChoice& choice : choices_of(image_, wanted)) {
    bands.insert(choice.bands.begin(), choice.bands.end());
    const std::size_t count = choice.bands.size();
    facts_.push_back({std::move(choice), std::vector<Extremes>(count), 0});
  }
  bands_.assign(bands.begin(), bands.end());
  for (const std::size_t band : bands_) image_.bands[band].radiance.reserve(image_.pixels());
}

void Preview::take(const ArrayImage& strip) {
  const bool contest = facts_.size() > 1;  // decided by contrast above the noise
  const bool warm = facts_.front().choice.look == Look::temperature;
  for (const std::size_t b : bands_) {
    const BandImage& band = strip.bands.at(b);
    BandImage& kept = image_.bands.at(b);
    append_every(step_, strip, band.radiance, kept.radiance);
    if (contest) append_every(step_, strip, band.standard_error, kept.standard_error);
    if (!warm) continue;
    append_every(step_, strip, band.brightness_temperature, kept.brightness_temperature);
  }
  for (ShownFacts& facts : facts_) add_strip(strip, facts);
  append_every(step_, strip, strip.truth.material, image_.truth.material);
}

const ShownFacts& Preview::facts(const BandChoice& choice) const {
  const auto found = std::find_if(facts_.begin(), facts_.end(), [&](const ShownFacts& facts) {
    return facts.choice.bands == choice.bands;
  });
  if (found == facts_.end()) throw std::out_of_range("no such choice of bands");
  return *found;
}

}  // namespace nadir::sim
