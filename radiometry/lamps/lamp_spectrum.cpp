#include "radiometry/lamps/lamp_spectrum.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "core/constants.hpp"
#include "spectral/luminous_efficiency.hpp"
#include "spectral/planck.hpp"

namespace nadir::radiometry {

spectral::Curve flux_of_one_lumen(Kelvin temperature) {
  constexpr double first_um = 0.2, last_um = 20.0;
  std::vector<double> wavelength_um, value;
  for (double w = first_um; w < last_um;) {
    wavelength_um.push_back(w);
    value.push_back(spectral::planck(Micrometres{w}, temperature).value);
    // A line over a relative step h misses B by h^2 / 8 of lambda^2 B'' / B, which is x^2 in Wien's
    // tail, x = c2 / (lambda T), and at most 20 in Rayleigh's and Jeans'.
    const double x = si::radiation_c2 / (w * temperature.value);
    w *= 1.0 + std::min(0.005, 0.025 / x);
  }
  wavelength_um.push_back(last_um);
  value.push_back(spectral::planck(Micrometres{last_um}, temperature).value);
  const double lumens =
      spectral::luminous(spectral::Curve{wavelength_um, value, spectral::Outside::reject});
  for (double& v : value) v /= lumens;
  return {std::move(wavelength_um), std::move(value), spectral::Outside::reject};
}

}  // namespace nadir::radiometry
