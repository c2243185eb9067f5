#include "sim/run/brightness.hpp"

namespace nadir::sim {

Estimate brightness_temperature(const spectral::BandQuadrature& quadrature,
                                const Estimate& radiance) {
  const auto temperature_of = [&](double value) {
    return spectral::band_brightness_temperature(quadrature, SpectralRadiance{value}).value;
  };
  const double kelvin = temperature_of(radiance.mean);
  const double step = 1e-4 * radiance.mean;  // a difference that stays in the first order
  const double slope = (temperature_of(radiance.mean + step) - kelvin) / step;
  return {kelvin, slope * radiance.standard_error};
}

}  // namespace nadir::sim
