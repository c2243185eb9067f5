#include "spectral/luminous_efficiency.hpp"

#include <algorithm>
#include <array>
#include <vector>

namespace nadir::spectral {
namespace {

constexpr double first_nm = 380.0, step_nm = 5.0;  // in air
/// Refractive index of standard air; 1.000275 to 1.000284 over the visible (Ciddor, Appl. Opt. 35,
/// 1566 (1996)), so that wavelengths are off by 5e-6 at most.
constexpr double air_index = 1.000278;

constexpr std::array<double, 81> table{
    0.000039, 0.000064, 0.000120, 0.000217, 0.000396, 0.000640, 0.001210, 0.002180, 0.004000,
    0.007300, 0.011600, 0.016840, 0.023000, 0.029800, 0.038000, 0.048000, 0.060000, 0.073900,
    0.090980, 0.112600, 0.139020, 0.169300, 0.208020, 0.258600, 0.323000, 0.407300, 0.503000,
    0.608200, 0.710000, 0.793200, 0.862000, 0.914850, 0.954000, 0.980300, 0.994950, 1.000000,
    0.995000, 0.978600, 0.952000, 0.915400, 0.870000, 0.816300, 0.757000, 0.694900, 0.631000,
    0.566800, 0.503000, 0.441200, 0.381000, 0.321000, 0.265000, 0.217000, 0.175000, 0.138200,
    0.107000, 0.081600, 0.061000, 0.044580, 0.032000, 0.023200, 0.017000, 0.011920, 0.008210,
    0.005723, 0.004102, 0.002929, 0.002091, 0.001484, 0.001047, 0.000740, 0.000520, 0.000361,
    0.000249, 0.000172, 0.000120, 0.000085, 0.000060, 0.000042, 0.000030, 0.000021, 0.000015};

constexpr double knot_um(std::size_t i) {
  return (first_nm + step_nm * static_cast<double>(i)) * 1e-3 * air_index;
}

}  // namespace

double luminous_efficiency(Micrometres wavelength) noexcept {
  const double place = (wavelength.value * 1e3 / air_index - first_nm) / step_nm;
  constexpr double end = static_cast<double>(table.size() - 1);
  if (!(place >= -1e-9 && place <= end + 1e-9)) return 0.0;  // the end knots belong to it
  const double inside = std::clamp(place, 0.0, end);
  const auto i = std::min(static_cast<std::size_t>(inside), table.size() - 2);
  const double t = inside - static_cast<double>(i);
  return table[i] * (1.0 - t) + table[i + 1] * t;
}

double luminous(const Curve& curve) {
  const double lo = knot_um(0), hi = knot_um(table.size() - 1);
  std::vector<double> knots;
  for (std::size_t i = 0; i < table.size(); ++i) knots.push_back(knot_um(i));
  for (const double w : curve.wavelengths_um()) {
    if (w > lo && w < hi) knots.push_back(w);
  }
  std::sort(knots.begin(), knots.end());
  const auto product = [&](double w) {
    return luminous_efficiency(Micrometres{w}) * curve.at(Micrometres{w});
  };
  double sum = 0.0;  // Simpson's rule is exact for the product of two lines
  for (std::size_t i = 1; i < knots.size(); ++i) {
    const double a = knots[i - 1], b = knots[i];
    sum += (b - a) / 6.0 * (product(a) + 4.0 * product(0.5 * (a + b)) + product(b));
  }
  return luminous_efficacy_lm_per_w * sum;
}

}  // namespace nadir::spectral
