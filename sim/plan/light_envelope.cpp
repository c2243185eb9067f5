#include "sim/plan/light_envelope.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "spectral/planck.hpp"

namespace nadir::sim {
namespace {

constexpr double pi = std::numbers::pi;

double henyey_greenstein_phase(double g, double cosine) noexcept {
  return (1.0 - g * g) / std::pow(1.0 + g * g - 2.0 * g * cosine, 1.5);
}

/// Sine of the elevation, as a shell of air has it near the horizon.
double shell_sine(Angle elevation) noexcept {
  constexpr double of_shell = 0.1;
  return std::max(std::sin(elevation.value), of_shell);
}

}  // namespace

double sun_envelope(Micrometres wavelength) noexcept {
  constexpr double margin = 1.3;
  const double sine = std::sin(degrees(0.26656).value);
  return margin * pi * sine * sine * spectral::planck(wavelength, Kelvin{6000.0}).value;
}

double moon_envelope(Micrometres wavelength, Angle phase) noexcept {
  constexpr double solid_angle = 7.2e-5, full = 0.5, magnitudes_a_degree = 0.016;
  constexpr double nearest_sun_au = 0.983;
  const double phase_deg = std::abs(phase.value) * 180.0 / pi;
  const double reflectance = full * std::pow(10.0, -0.4 * magnitudes_a_degree * phase_deg);
  const double reflected =
      sun_envelope(wavelength) / (nearest_sun_au * nearest_sun_au) * reflectance / pi;
  return solid_angle * (reflected + spectral::planck(wavelength, Kelvin{400.0}).value);
}

double twilight_share(Angle elevation) noexcept {
  // degrees of the elevation, log10 of the share
  constexpr auto known = std::to_array<std::array<double, 2>>(
      {{0.0, 0.0}, {-6.0, -1.3}, {-12.0, -4.0}, {-18.0, -5.0}});
  const double deg = elevation.value * 180.0 / pi;
  if (deg >= 0.0) return 1.0;
  for (std::size_t i = 1; i < known.size(); ++i) {
    if (deg < known[i][0]) continue;
    const double share = (known[i - 1][0] - deg) / (known[i - 1][0] - known[i][0]);
    return std::pow(10.0, known[i - 1][1] + share * (known[i][1] - known[i - 1][1]));
  }
  return 0.0;
}

double rayleigh_depth(Micrometres wavelength, double pressure_hpa) noexcept {
  constexpr double standard_hpa = 1013.25;
  const double square = 1.0 / (wavelength.value * wavelength.value);
  const double fourth = square * square;
  return 0.008569 * fourth * (1.0 + 0.0113 * square + 0.00013 * fourth) * pressure_hpa /
         standard_hpa;
}

double scattered_share(const ScatteringAir& air, Angle elevation) noexcept {
  // 1 - 2 E3(tau) < 2 tau: what a plate that only scatters turns back of diffuse light
  const double back = std::min(1.0, 2.0 * air.depth) * std::min(air.ground_reflectance, 0.99);
  const double sine = shell_sine(elevation);
  return sine * (1.0 - std::exp(-air.depth / sine) + back) / (1.0 - back) *
         twilight_share(elevation);
}

double scattered_share_on_slopes(const ScatteringAir& air, Angle elevation) noexcept {
  const double lost = 1.0 - std::exp(-air.depth / shell_sine(elevation));
  return lost * twilight_share(elevation) + 2.0 * scattered_share(air, elevation);
}

double path_share(const ScatteringAir& air, const SightLine& sight, Angle elevation) noexcept {
  constexpr double forward = 0.85, rayleigh = 1.5, real_particles = 3.0, uneven = 2.0;
  const double once = real_particles *
                      (henyey_greenstein_phase(forward, sight.cos_scattering) + rayleigh) /
                      (4.0 * pi);
  const double direct = std::max(0.0, std::sin(elevation.value));
  const double diffuse = scattered_share(air, elevation);
  const double about = diffuse + air.ground_reflectance * (direct + diffuse);
  return (1.0 - std::exp(-air.depth * sight.air_mass)) *
         (once * twilight_share(elevation) + uneven * about / pi);
}

}  // namespace nadir::sim
