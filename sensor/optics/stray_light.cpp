#include "sensor/optics/stray_light.hpp"

#include <math.h>  // j1 of POSIX

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
  const double k = 2.0 * std::numbers::pi * frequency_per_m;
  if (k == 0.0) return 1.0;
  double sum = 0.0, inner = 0.0, inner_term = 0.0;
  for (int i = 1; i <= rings; ++i) {
    // The mean of J0(k r) over a ring: int J0(k r) r dr = r J1(k r) / k.
    const double outer = stray_distance(stray, static_cast<double>(i) / rings);
    const double outer_term = outer * ::j1(k * outer);
    sum += 2.0 * (outer_term - inner_term) / (k * (outer - inner) * (outer + inner));
    inner = outer;
    inner_term = outer_term;
  }
  return sum / rings;
}

}  // namespace nadir::sensor
