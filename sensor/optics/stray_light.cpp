#include "sensor/optics/stray_light.hpp"

#include <math.h>  // j0 of POSIX

#include <cmath>
#include <numbers>

namespace nadir::sensor {

double stray_distance(const StraySpread& stray, double share) noexcept {
  const double power = 1.0 - stray.slope;
  const double edge = 1.0 + (stray.reach_m / stray.core_m) * (stray.reach_m / stray.core_m);
  double inner = 0.0;
  if (std::abs(power) < 1e-9) {
    inner = std::pow(edge, share);
  } else {
    inner = std::pow(1.0 + share * (std::pow(edge, power) - 1.0), 1.0 / power);
  }
  return stray.core_m * std::sqrt(std::fmax(0.0, inner - 1.0));
}

double stray_mtf(const StraySpread& stray, double frequency_per_m) {
  constexpr int rings = 2000;
  double sum = 0.0;
  for (int i = 0; i < rings; ++i) {
    const double r = stray_distance(stray, (i + 0.5) / rings);
    sum += ::j0(2.0 * std::numbers::pi * frequency_per_m * r);
  }
  return sum / rings;
}

}  // namespace nadir::sensor
