#include "thermal/weather/sky_long_wave.hpp"

#include <algorithm>
#include <cmath>

#include "core/constants.hpp"

namespace nadir::thermal {
namespace {

double clear_sky_emissivity(ClearSkyFormula formula, const StationAir& air) noexcept {
  const double t = air.temperature_k;
  const double e = std::max(0.0, air.vapour_pressure_hpa);
  switch (formula) {
    case ClearSkyFormula::brutsaert:
      return 1.24 * std::pow(e / t, 1.0 / 7.0);
    case ClearSkyFormula::swinbank:
      return 5.31e-13 / si::stefan_boltzmann * t * t;
    case ClearSkyFormula::idso:
      return 0.70 + 5.95e-5 * e * std::exp(1500.0 / t);
    case ClearSkyFormula::prata: {
      const double w = 46.5 * e / t;  // precipitable water, g cm^-2
      return 1.0 - (1.0 + w) * std::exp(-std::sqrt(1.2 + 3.0 * w));
    }
  }
  return 1.0;  // no such formula
}

}  // namespace

double sky_emissivity(const SkyFormula& formula, const StationAir& air) noexcept {
  const double clear = std::min(1.0, clear_sky_emissivity(formula.clear, air));
  const double c = std::clamp(air.cloud_fraction, 0.0, 1.0);
  if (formula.clouds == CloudFormula::unsworth_monteith) return (1.0 - 0.84 * c) * clear + 0.84 * c;
  return std::min(1.0, (1.0 + 0.0496 * std::pow(c, 2.45)) * clear);
}

double sky_long_wave_w_m2(const SkyFormula& formula, const StationAir& air) noexcept {
  const double t2 = air.temperature_k * air.temperature_k;
  return sky_emissivity(formula, air) * si::stefan_boltzmann * t2 * t2;
}

}  // namespace nadir::thermal
