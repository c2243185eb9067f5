#include "thermal/surface/surface_balance.hpp"

#include <bit>
#include <cassert>
#include <cmath>
#include <cstdint>

#include "core/constants.hpp"
#include "thermal/surface/humidity.hpp"

namespace nadir::thermal {
namespace {

/// What the air does to a surface of a temperature: its film and, where the surface is wet, what
/// vapour takes.
struct AirAtSurface {
  double air_k;
  double vapour_pressure_hpa;
  double wetness_per_gamma_k_hpa;
  const Film& film;
};

/// x^(1/3) for x > 0 by two steps of Halley's rule from a third of the exponent (Kahan's start, off
/// by 5 % at most). Relative error below 1e-14, in half the time of std::cbrt, which would be most
/// of what a balance costs.
double quick_cbrt(double x) noexcept {
  auto y = std::bit_cast<double>(std::bit_cast<std::uint64_t>(x) / 3 + 0x2A9F7893782DA1CEULL);
  for (int step = 0; step < 2; ++step) {
    const double cube = y * y * y;
    y *= (cube + 2.0 * x) / (2.0 * cube + x);
  }
  return y;
}

/// |dT|^(1/3), 0 where nothing depends on it.
double cube_root(const AirAtSurface& air, double warmer_k) noexcept {
  const double natural =
      warmer_k > 0.0 ? air.film.natural_warm_w_m2_k43 : air.film.natural_cold_w_m2_k43;
  const double apart_k = std::abs(warmer_k);
  constexpr double nothing_k = 1e-100;  // far above where the start's cube underflows
  return natural == 0.0 || apart_k < nothing_k ? 0.0 : quick_cbrt(apart_k);
}

/// h (T_air - T) = -(forced dT + natural dT |dT|^(1/3)).
SurfaceFlux convected(const AirAtSurface& air, double warmer_k, double root) noexcept {
  const double natural =
      root * (warmer_k > 0.0 ? air.film.natural_warm_w_m2_k43 : air.film.natural_cold_w_m2_k43);
  return {-(air.film.forced_w_m2_k + natural) * warmer_k,
          -(air.film.forced_w_m2_k + (4.0 / 3.0) * natural)};
}

/// w h_v / gamma (e_air - e_s). With dT on the side that makes the flow stronger natural convection
/// grows as |dT|^(1/3) from 1 K on: the derivative has a term of its own for it.
SurfaceFlux evaporated(const AirAtSurface& air, double warmer_k, double root) noexcept {
  if (air.wetness_per_gamma_k_hpa == 0.0) return {};
  const SaturationPressure saturated = saturation_at_surface(air.air_k + warmer_k);
  const double drier_hpa = air.vapour_pressure_hpa - saturated.hpa;
  const double side = drier_hpa < 0.0 ? 1.0 : -1.0;  // evaporation, dew
  const double natural =
      drier_hpa < 0.0 ? air.film.natural_warm_w_m2_k43 : air.film.natural_cold_w_m2_k43;
  const bool driven = side * warmer_k > 1.0 && natural > 0.0;
  const double film = air.film.forced_w_m2_k + natural * (driven ? root : 1.0);
  const double film_per_k = driven ? natural * root / (3.0 * warmer_k) : 0.0;
  return {air.wetness_per_gamma_k_hpa * film * drier_hpa,
          air.wetness_per_gamma_k_hpa * (film_per_k * drier_hpa - film * saturated.per_k)};
}

double wetness_per_gamma(const SurfaceProperties& surface, const SurfaceLoad& load) noexcept {
  if (surface.wetness == 0.0) return 0.0;
  return surface.wetness / psychrometric_constant_hpa_k(load.pressure_hpa);
}

double absorbed(const SurfaceProperties& surface, const SurfaceLoad& load) noexcept {
  return surface.solar_absorptance * (load.direct_w_m2 + load.diffuse_w_m2 + load.reflected_w_m2) +
         surface.emissivity * (load.sky_long_wave_w_m2 + load.surroundings_long_wave_w_m2);
}

}  // namespace

BalanceTerms balance(const SurfaceProperties& surface, const SurfaceLoad& load,
                     double temperature_k) noexcept {
  const AirAtSurface air{load.air_k, load.vapour_pressure_hpa, wetness_per_gamma(surface, load),
                         load.film};
  const double warmer_k = temperature_k - load.air_k;
  const double root = cube_root(air, warmer_k);
  const double t2 = temperature_k * temperature_k;
  return {.direct = surface.solar_absorptance * load.direct_w_m2,
          .diffuse = surface.solar_absorptance * load.diffuse_w_m2,
          .reflected = surface.solar_absorptance * load.reflected_w_m2,
          .sky_long_wave = surface.emissivity * load.sky_long_wave_w_m2,
          .surroundings_long_wave = surface.emissivity * load.surroundings_long_wave_w_m2,
          .emitted = -surface.emissivity * si::stefan_boltzmann * t2 * t2,
          .convected = convected(air, warmer_k, root).w_m2,
          .evaporated = evaporated(air, warmer_k, root).w_m2};
}

BalanceAt::BalanceAt(const SurfaceProperties& surface, const SurfaceLoad& load) noexcept
    : absorbed_w_m2_{absorbed(surface, load)},
      emission_w_m2_k4_{surface.emissivity * si::stefan_boltzmann},
      air_k_{load.air_k},
      vapour_pressure_hpa_{load.vapour_pressure_hpa},
      wetness_per_gamma_k_hpa_{wetness_per_gamma(surface, load)},
      film_{load.film} {}

BalanceAt::BalanceAt(const SurfaceProperties& surface, const SurfaceLoad& front,
                     const SurfaceLoad& back) noexcept
    : BalanceAt{surface, front} {
  assert(front.air_k == back.air_k && front.vapour_pressure_hpa == back.vapour_pressure_hpa);
  absorbed_w_m2_ += absorbed(surface, back);
  emission_w_m2_k4_ *= 2.0;
  film_.forced_w_m2_k += back.film.forced_w_m2_k;
  film_.natural_warm_w_m2_k43 += back.film.natural_warm_w_m2_k43;
  film_.natural_cold_w_m2_k43 += back.film.natural_cold_w_m2_k43;
}

SurfaceFlux BalanceAt::operator()(double temperature_k) const noexcept {
  const AirAtSurface air{air_k_, vapour_pressure_hpa_, wetness_per_gamma_k_hpa_, film_};
  const double warmer_k = temperature_k - air_k_;
  const double root = cube_root(air, warmer_k);
  const SurfaceFlux heat = convected(air, warmer_k, root);
  const SurfaceFlux vapour = evaporated(air, warmer_k, root);
  const double t3 = temperature_k * temperature_k * temperature_k;
  return {absorbed_w_m2_ - emission_w_m2_k4_ * t3 * temperature_k + heat.w_m2 + vapour.w_m2,
          -4.0 * emission_w_m2_k4_ * t3 + heat.per_k_w_m2_k + vapour.per_k_w_m2_k};
}

}  // namespace nadir::thermal
