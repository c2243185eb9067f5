#pragma once

#include <cmath>
#include <cstdio>
#include <numbers>
#include <string>
#include <vector>

// A slab of air whose light has a closed form, written as other programs would: along a way of
// optical depth t every source J, the same everywhere, gives J (1 - exp(-t)).

namespace nadir::sim::support {

inline constexpr double degree = std::numbers::pi / 180.0;

struct Slab {
  // By wavelength, W m^-2 sr^-1 um^-1.
  std::vector<double> nu{1000.0, 2000.0, 10000.0};  ///< wavenumber, cm^-1
  std::vector<double> depth{0.4, 1.1, 0.25};        ///< vertical
  std::vector<double> emission{8.0, 1.5, 0.0};      ///< source
  std::vector<double> scattering{0.01, 0.3, 40.0};  ///< source at azimuth 0
  std::vector<double> sun{0.5, 9.0, 700.0};         ///< outside, W m^-2 um^-1
  double sun_mu = 0.8;

  [[nodiscard]] double transmittance(std::size_t i, double mu) const {
    return std::exp(-depth[i] / std::abs(mu));
  }
  [[nodiscard]] double emitted(std::size_t i, double mu) const {
    return emission[i] * (1.0 - transmittance(i, mu));
  }
  /// Weaker away from the sun: a closed form in azimuth as well.
  [[nodiscard]] double source(std::size_t i, double azimuth_deg) const {
    return scattering[i] * (1.0 - azimuth_deg / 360.0);
  }
  [[nodiscard]] double scattered(std::size_t i, double mu, double azimuth_deg) const {
    return source(i, azimuth_deg) * (1.0 - transmittance(i, mu));
  }
};

template <class... Numbers>
std::string printed(const char* format, Numbers... numbers) {
  char text[512];
  std::snprintf(text, sizeof text, format, numbers...);
  return text;
}

/// W m^-2 um^-1 as W cm^-2 per cm^-1.
inline double per_cm(double per_um, double nu) { return per_um / (nu * nu); }

}  // namespace nadir::sim::support
