#include "sim/products/temperature_map.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sim/products/colour_map.hpp"
#include "sim/products/percentile.hpp"
#include "spectral/planck.hpp"

namespace nadir::sim {
namespace {

constexpr double least_span_k = 2.0;

/// Three steps a decade: 1, 2, 5.
double round_step(double least) {
  const double decade = std::pow(10.0, std::floor(std::log10(least)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * decade >= least) return factor * decade;
  }
  return 10.0 * decade;
}

}  // namespace

std::vector<float> temperatures_of(const BandImage& band) {
  const bool known = band.brightness_temperature.size() == band.radiance.size();
  std::vector<float> temperature_k(band.radiance.size());
  for (std::size_t i = 0; i < temperature_k.size(); ++i) {
    const float radiance = band.radiance[i];
    if (!std::isfinite(radiance) || radiance < 0.0F) {
      temperature_k[i] = std::numeric_limits<float>::quiet_NaN();
    } else if (known) {
      temperature_k[i] = band.brightness_temperature[i];
    } else {
      const auto kelvin =
          spectral::brightness_temperature(Micrometres{band.centre_um}, SpectralRadiance{radiance});
      temperature_k[i] = static_cast<float>(kelvin.value);
    }
  }
  return temperature_k;
}

TemperatureRange temperature_range(const ArrayImage& image,
                                   const std::vector<float>& temperature_k) {
  const std::vector<bool> surface = surface_pixels(image);
  std::vector<float> values;
  for (std::size_t i = 0; i < temperature_k.size(); ++i) {
    if (surface[i] && std::isfinite(temperature_k[i])) values.push_back(temperature_k[i]);
  }
  if (values.empty()) return {0.0, least_span_k};
  const double lo_k = percentile(values, 0.005), hi_k = percentile(values, 0.995);
  const double margin_k = std::max(0.0, 0.5 * (least_span_k - (hi_k - lo_k)));
  const double from_k = std::max(0.0, lo_k - margin_k);
  return {from_k, std::max(hi_k + margin_k, from_k + least_span_k)};
}

Picture temperature_map(const std::vector<float>& temperature_k, TemperatureRange range) {
  Picture picture;
  picture.pixels.reserve(temperature_k.size());
  for (const float kelvin : temperature_k) {
    const bool valid = std::isfinite(kelvin);
    if (!valid) ++picture.invalid_pixels;
    const double fraction = (kelvin - range.lo_k) / (range.hi_k - range.lo_k);
    picture.pixels.push_back(valid ? inferno(fraction) : invalid_colour);
  }
  return picture;
}

std::vector<double> round_ticks(double lo, double hi, int most) {
  const double step = round_step((hi - lo) / std::max(1, most));
  std::vector<double> ticks;
  // A hair of slack keeps a tick that rounding puts just outside; + 0.0 turns -0 into 0.
  const double slack = 1e-9 * (hi - lo);
  for (double n = std::ceil((lo - slack) / step); n * step <= hi + slack; n += 1.0) {
    ticks.push_back(n * step + 0.0);
  }
  return ticks;
}

}  // namespace nadir::sim
