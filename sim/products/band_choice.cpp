#include "sim/products/band_choice.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "sim/products/percentile.hpp"

namespace nadir::sim {
namespace {

// Red, green and blue of the eye, at the centres that Landsat's and Sentinel-2's bands share.
constexpr std::array natural_um{0.655, 0.56, 0.48};
constexpr double natural_reach_um = 0.06;
constexpr double clearest_thermal_um = 10.9;

using Bands = std::vector<std::size_t>;

double distance_um(const ArrayImage& image, std::size_t band, double target_um) {
  return std::abs(image.bands[band].centre_um - target_um);
}

std::size_t nearest(const ArrayImage& image, const Bands& bands, double target_um) {
  return *std::min_element(bands.begin(), bands.end(), [&](std::size_t a, std::size_t b) {
    return distance_um(image, a, target_um) < distance_um(image, b, target_um);
  });
}

bool is_natural(const ArrayImage& image, const Bands& rgb) {
  for (std::size_t c = 0; c < 3; ++c) {
    if (distance_um(image, rgb[c], natural_um[c]) > natural_reach_um) return false;
  }
  return rgb[0] != rgb[1] && rgb[1] != rgb[2];
}

/// Spread of the picture above its noise; 1 % of the mean stands in for noise that is not known.
double contrast(const BandImage& band) {
  std::vector<float> values, errors;
  for (std::size_t i = 0; i < band.radiance.size(); ++i) {
    if (std::isfinite(band.radiance[i])) values.push_back(band.radiance[i]);
    if (i < band.standard_error.size() && std::isfinite(band.standard_error[i])) {
      errors.push_back(band.standard_error[i]);
    }
  }
  if (values.empty()) return -1.0;
  const double spread = percentile(values, 0.98) - percentile(values, 0.02);
  const double noise = errors.empty() ? 0.0 : percentile(errors, 0.5);
  const double unit = noise + 0.01 * std::abs(percentile(values, 0.5));
  return unit > 0.0 ? spread / unit : 0.0;
}

std::optional<BandChoice> choose_wanted(const ArrayImage& image,
                                        const std::vector<std::string>& wanted) {
  if (wanted.size() != 1 && wanted.size() != 3) return std::nullopt;
  BandChoice choice;
  for (const std::string& name : wanted) {
    const auto found = std::find_if(image.bands.begin(), image.bands.end(),
                                    [&](const BandImage& band) { return band.name == name; });
    if (found == image.bands.end()) return std::nullopt;
    choice.bands.push_back(static_cast<std::size_t>(found - image.bands.begin()));
  }
  if (wanted.size() == 3) {
    choice.look = is_natural(image, choice.bands) ? Look::natural_colour : Look::false_colour;
  } else if (image.bands[choice.bands[0]].centre_um > thermal_from_um) {
    choice.look = Look::temperature;
  }
  return choice;
}

std::vector<BandChoice> choose_freely(const ArrayImage& image) {
  Bands all, reflective;
  for (std::size_t b = 0; b < image.bands.size(); ++b) {
    all.push_back(b);
    if (image.bands[b].centre_um <= thermal_from_um) reflective.push_back(b);
  }
  if (reflective.empty()) {
    return {{Look::temperature, {nearest(image, all, clearest_thermal_um)}}};
  }
  if (reflective.size() < 3) {
    std::vector<BandChoice> greys;
    for (const std::size_t band : reflective) greys.push_back({Look::grey, {band}});
    return greys;
  }
  Bands rgb;
  for (const double target_um : natural_um) rgb.push_back(nearest(image, reflective, target_um));
  if (is_natural(image, rgb)) return {{Look::natural_colour, rgb}};
  std::sort(reflective.begin(), reflective.end(), [&](std::size_t a, std::size_t b) {
    return image.bands[a].centre_um > image.bands[b].centre_um;
  });
  return {{Look::false_colour,
           {reflective.front(), reflective[reflective.size() / 2], reflective.back()}}};
}

}  // namespace

std::vector<BandChoice> choices_of(const ArrayImage& image,
                                   const std::vector<std::string>& wanted) {
  if (const auto choice = choose_wanted(image, wanted)) return {*choice};
  std::vector<BandChoice> choices = choose_freely(image);
  for (BandChoice& choice : choices) choice.as_wanted = wanted.empty();
  return choices;
}

BandChoice choose_bands(const ArrayImage& image, const std::vector<std::string>& wanted) {
  const std::vector<BandChoice> choices = choices_of(image, wanted);
  if (choices.size() == 1) return choices.front();  // spares the contrast
  return *std::max_element(choices.begin(), choices.end(), [&](const auto& a, const auto& b) {
    return contrast(image.bands[a.bands[0]]) < contrast(image.bands[b.bands[0]]);
  });
}

}  // namespace nadir::sim
