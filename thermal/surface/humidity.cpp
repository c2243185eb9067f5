#include "thermal/surface/humidity.hpp"

#include <algorithm>
#include <cmath>

#include "core/constants.hpp"

namespace nadir::thermal {
namespace {

/// e = e0 exp(a t / (b + t)).
struct Magnus {
  double a, b_k;
};
constexpr double magnus_hpa = 6.112;
constexpr Magnus over_water{17.62, 243.12};
constexpr Magnus over_ice{22.46, 272.62};

// The exponent has a pole at -b; 200 K below freezing e is 1e-36 hPa over water, 1e-26 over ice.
constexpr double lowest_c = -200.0;
constexpr double highest_c = 100.0;

SaturationPressure magnus(const Magnus& phase, double celsius) noexcept {
  if (celsius < lowest_c) return {};
  const double t = std::min(celsius, highest_c);
  const double inverse = 1.0 / (phase.b_k + t);
  const double hpa = magnus_hpa * std::exp(phase.a * t * inverse);
  return {hpa, celsius < highest_c ? hpa * phase.a * phase.b_k * inverse * inverse : 0.0};
}

}  // namespace

double saturation_over_water_hpa(double temperature_k) noexcept {
  return magnus(over_water, temperature_k - si::zero_celsius).hpa;
}

SaturationPressure saturation_at_surface(double temperature_k) noexcept {
  const double celsius = temperature_k - si::zero_celsius;
  return magnus(celsius < 0.0 ? over_ice : over_water, celsius);
}

double vapour_pressure_of_humidity_hpa(double air_k, double relative_humidity) noexcept {
  return relative_humidity * saturation_over_water_hpa(air_k);
}

double vapour_pressure_of_dew_point_hpa(double dew_point_k) noexcept {
  return saturation_over_water_hpa(dew_point_k);
}

double dew_point_k(double vapour_pressure_hpa) noexcept {
  const double x = std::log(vapour_pressure_hpa / magnus_hpa);
  return si::zero_celsius + over_water.b_k * x / (over_water.a - x);
}

}  // namespace nadir::thermal
