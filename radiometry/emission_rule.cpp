#include "radiometry/emission_rule.hpp"

#include <numbers>

#include "spectral/planck.hpp"

namespace nadir::radiometry {

double faintest_emission(SpectralIrradiance irradiance) noexcept {
  constexpr double of_lit = 1e-6, of_night = 1e-10;
  return of_night + of_lit * irradiance.value / std::numbers::pi;
}

bool emission_counts(Kelvin temperature, Micrometres wavelength, SpectralIrradiance irradiance) {
  return spectral::planck(wavelength, temperature).value > faintest_emission(irradiance);
}

}  // namespace nadir::radiometry
