#include "sim/products/tone_map.hpp"

#include <algorithm>
#include <cmath>

#include "core/quantity.hpp"
#include "sim/products/colour_map.hpp"
#include "sim/products/percentile.hpp"
#include "spectral/planck.hpp"

namespace nadir::sim {
namespace {

constexpr double dark_fraction = 0.005, white_fraction = 0.995;
constexpr double dark_share = 0.9;  // the darkest thing of a scene is seldom black
constexpr double most_dark = 0.7;   // of the white point; see the header
constexpr double middle_grey = 0.18;
constexpr double most_sky = 0.5;             // of the middle grey's say
constexpr double most_exposure = 16.0;       // four stops: more would show mainly noise
constexpr double natural_saturation = 1.25;  // restores about what the shoulder takes from grass
constexpr std::array luminance_weight{0.2126, 0.7152, 0.0722};  // IEC 61966-2-1

/// The band behind each of the three channels; a grey picture has the same in all.
std::array<const BandImage*, 3> channels_of(const ArrayImage& image, const BandChoice& choice) {
  std::array<const BandImage*, 3> channels{};
  for (std::size_t c = 0; c < 3; ++c) {
    channels[c] = &image.bands.at(choice.bands.at(choice.bands.size() == 3 ? c : 0));
  }
  return channels;
}

bool is_valid(const std::array<const BandImage*, 3>& channels, std::size_t pixel) {
  return std::all_of(channels.begin(), channels.end(),
                     [&](const BandImage* band) { return std::isfinite(band->radiance[pixel]); });
}

/// The sun's radiance at a wavelength, relative to green.
double sun_colour(double wavelength_um) {
  using namespace nadir::literals;
  constexpr Kelvin sun = 5772.0_K;
  return spectral::planck(Micrometres{wavelength_um}, sun) / spectral::planck(0.56_um, sun);
}

double srgb_encoded(double linear) {
  return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1.0 / 2.4) - 0.055;
}

/// Pixels with a value in all channels, by what they see.
struct SeenPixels {
  std::vector<std::size_t> surface, sky;

  [[nodiscard]] double sky_share() const {
    return static_cast<double>(sky.size()) / static_cast<double>(surface.size() + sky.size());
  }
};

SeenPixels seen_pixels(const ArrayImage& image, const std::array<const BandImage*, 3>& channels) {
  const std::vector<bool> surface = surface_pixels(image);
  SeenPixels seen;
  for (std::size_t i = 0; i < surface.size(); ++i) {
    if (is_valid(channels, i)) (surface[i] ? seen.surface : seen.sky).push_back(i);
  }
  return seen;
}

struct Limits {
  double dark = 0.0, white = 0.0;
};

Limits limits_of(const BandImage& band, const SeenPixels& seen) {
  std::vector<float> values;
  values.reserve(seen.surface.size() + seen.sky.size());
  for (const std::size_t i : seen.surface) values.push_back(band.radiance[i]);
  const double surface_white = std::max(0.0, percentile(values, white_fraction));
  const double dark = std::clamp(percentile(values, dark_fraction), 0.0, most_dark * surface_white);
  for (const std::size_t i : seen.sky) values.push_back(band.radiance[i]);
  return {dark_share * dark, std::max(surface_white, percentile(values, white_fraction))};
}

double median_luminance(const ToneCurve& curve, const std::array<const BandImage*, 3>& channels,
                        const std::vector<std::size_t>& pixels) {
  std::vector<float> luminance;
  luminance.reserve(pixels.size());
  for (const std::size_t i : pixels) {
    double sum = 0.0;
    for (std::size_t c = 0; c < 3; ++c) {
      const double value = curve.gain[c] * (channels[c]->radiance[i] - curve.dark[c]);
      sum += luminance_weight[c] * std::max(0.0, value);
    }
    luminance.push_back(static_cast<float>(sum));
  }
  return percentile(luminance, 0.5);
}

/// What comes to middle grey: the geometric mean of ground and sky, by their shares of the picture.
double middle_luminance(const ToneCurve& curve, const std::array<const BandImage*, 3>& channels,
                        const SeenPixels& seen) {
  const double ground = median_luminance(curve, channels, seen.surface);
  const double share = std::min(most_sky, seen.sky_share());
  if (share == 0.0 || !(ground > 0.0)) return ground;
  const double sky = std::max(ground, median_luminance(curve, channels, seen.sky));
  return std::pow(ground, 1.0 - share) * std::pow(sky, share);
}

}  // namespace

std::array<double, 3> ToneCurve::display(const std::array<double, 3>& radiance) const {
  const double white = std::max(1.0, exposure);
  std::array<double, 3> light{};
  double luminance = 0.0;
  for (std::size_t c = 0; c < 3; ++c) {
    const double v = exposure * std::max(0.0, gain[c] * (radiance[c] - dark[c]));
    light[c] = std::min(1.0, v * (1.0 + v / (white * white)) / (1.0 + v));
    luminance += luminance_weight[c] * light[c];
  }
  for (double& x : light) x = std::clamp(luminance + saturation * (x - luminance), 0.0, 1.0);
  return light;
}

ToneCurve fit_tone_curve(const ArrayImage& image, const BandChoice& choice) {
  const auto channels = channels_of(image, choice);
  const SeenPixels seen = seen_pixels(image, channels);
  ToneCurve curve;
  if (seen.surface.empty()) return curve;
  if (choice.look == Look::natural_colour) curve.saturation = natural_saturation;

  std::array<double, 3> white{};
  for (std::size_t c = 0; c < 3; ++c) {
    const Limits limits = limits_of(*channels[c], seen);
    const double sun =
        choice.look == Look::natural_colour ? sun_colour(channels[c]->centre_um) : 1.0;
    curve.dark[c] = limits.dark;
    curve.gain[c] = 1.0 / sun;
    white[c] = (limits.white - limits.dark) / sun;
  }
  const double common = *std::max_element(white.begin(), white.end());
  for (std::size_t c = 0; c < 3; ++c) {
    const double own = choice.look == Look::natural_colour ? common : white[c];
    if (own > 0.0) curve.gain[c] /= own;
  }
  const double middle = middle_luminance(curve, channels, seen);
  // Above 0 and below the white point; a picture whose median is black is shown as it is.
  if (middle > 0.0) curve.exposure = std::clamp(middle_grey / middle, 1.0, most_exposure);
  return curve;
}

Picture tone_map(const ArrayImage& image, const BandChoice& choice) {
  return tone_map(image, choice, fit_tone_curve(image, choice));
}

Picture tone_map(const ArrayImage& image, const BandChoice& choice, const ToneCurve& curve) {
  const auto channels = channels_of(image, choice);
  Picture picture;
  picture.pixels.assign(image.pixels(), invalid_colour);
  for (std::size_t i = 0; i < picture.pixels.size(); ++i) {
    if (!is_valid(channels, i)) {
      ++picture.invalid_pixels;
      continue;
    }
    const auto light = curve.display(
        {channels[0]->radiance[i], channels[1]->radiance[i], channels[2]->radiance[i]});
    for (std::size_t c = 0; c < 3; ++c) {
      const double code = 255.0 * srgb_encoded(light[c]);
      picture.pixels[i][c] = static_cast<std::uint8_t>(std::lround(code));
    }
  }
  return picture;
}

std::vector<bool> surface_pixels(const ArrayImage& image) {
  std::vector<bool> surface(image.pixels(), true);
  const auto& material = image.truth.material;
  if (material.size() != surface.size()) return surface;
  const auto seen =
      std::count_if(material.begin(), material.end(), [](std::uint32_t id) { return id != 0; });
  if (static_cast<std::size_t>(seen) * 100 < surface.size()) return surface;
  for (std::size_t i = 0; i < surface.size(); ++i) surface[i] = material[i] != 0;
  return surface;
}

}  // namespace nadir::sim
