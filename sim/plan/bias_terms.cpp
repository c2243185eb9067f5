#include "sim/plan/bias_terms.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "radiometry/sample_allocation.hpp"
#include "radiometry/thresholds.hpp"

namespace nadir::sim {
namespace {

using radiometry::Effect;
using radiometry::EffectSet;

/// Q(k, x) for whole k: the chance that a Poisson variate of mean x is below k.
double upper_gamma(int k, double x) noexcept {
  if (x <= 0.0) return 1.0;
  double term = std::exp(-x), sum = term;  // x is at most 24: no underflow
  for (int j = 1; j < k; ++j) {
    term *= x / j;
    sum += term;
  }
  return std::min(sum, 1.0);
}

/// What lights a band with the effects that are on.
LightBound light_bound(const BandFacts& band, EffectSet on, double gloss) noexcept {
  LightBound light;
  if (on.has(Effect::solar_reflection)) light.irradiance += gloss * band.sun_irradiance;
  if (on.has(Effect::lunar_reflection)) light.irradiance += gloss * band.moon_irradiance;
  if (on.has(Effect::lamps)) {
    light.irradiance += band.lamp_irradiance;
    light.radiance += band.lamp_radiance;
  }
  if (on.has(Effect::sky_scattering)) light.radiance += band.sky_scattering;
  double warm = 0.0;
  if (on.has(Effect::surface_emission)) warm = band.warmest_emission;
  if (on.has(Effect::sky_emission)) warm = std::max(warm, band.sky_emission);
  light.radiance += warm;
  return light;
}

/// max(least radiance of a surface, floor): what errors before the air count against.
double glow_or_floor(const BandFacts& band, EffectSet on, double floor) noexcept {
  const double glow =
      on.has(Effect::surface_emission) ? band.least_emissivity * band.coldest_emission : 0.0;
  return std::max(glow, floor);
}

/// No error of missing light exceeds the light itself.
double relative_to(double missing, double radiance) noexcept {
  if (!(missing > 0.0)) return 0.0;
  return radiance > 0.0 ? std::min(missing / radiance, 1.0) : 1.0;
}

/// The number of reflections from which on light is missing; none: nothing is.
int reflections_from(const SolverChoice& solver, const SceneFacts& facts, EffectSet on) noexcept {
  if (solver.method == radiometry::Method::path) {
    return solver.path_max_bounces > 0 ? solver.path_max_bounces + 1 : 0;
  }
  const int bodies = (facts.has_sun && on.has(Effect::solar_reflection) ? 1 : 0) +
                     (facts.has_moon && on.has(Effect::lunar_reflection) ? 1 : 0);
  return effective_bounces(solver.settings, bodies, facts.has_lamps && on.has(Effect::lamps)) + 2;
}

double thresholds_of(const BandFacts& band, int bounces, const LightBound& light) noexcept {
  const double rho = band.greatest_reflectance;
  const double known = band.greatest_transmittance > 0.0 ? 0.5 * rho : rho;
  const double lost = threshold_loss(std::min(rho, 1.0), known, bounces);
  return lost > 0.0 ? lost * light_beyond(0, rho, light) : 0.0;
}

double air_share(const BandFacts& band, EffectSet on, double floor) noexcept {
  double air = 0.0;
  if (on.has(Effect::sky_scattering)) air += band.greatest_reflectance * band.sky_scattering;
  if (on.has(Effect::sky_emission)) air += band.greatest_reflectance * band.sky_emission;
  if (on.has(Effect::path_scattering)) air += band.path_scattering;
  if (on.has(Effect::path_emission)) air += band.path_emission;
  const double passed = std::max(1.0 - band.path_loss, 0.0);
  return relative_to(air, std::max(passed * glow_or_floor(band, on, 0.0), floor));
}

double at_or_zero(const ByBand& values, std::size_t array, std::size_t band) {
  return array < values.size() && band < values[array].size() ? values[array][band] : 0.0;
}

}  // namespace

int effective_bounces(const materials::SolverSettings& settings, int lights, bool lamps) noexcept {
  for (int g = 0; g < settings.max_bounces; ++g) {
    const int all =
        radiometry::full_sample_count(settings.initial_sample_count, settings.sample_decay_rate, g);
    constexpr int samples_per_draw = 4, most_draws = 8;  // of lamps, as the solver has them
    const int draws = lamps ? std::clamp(all / samples_per_draw, 1, most_draws) : 0;
    if (all <= lights + draws) return g;
  }
  return settings.max_bounces;
}

double light_beyond(int n, double rho, const LightBound& light) noexcept {
  if (rho <= 0.0 && n > 0) return 0.0;
  double field = light.radiance;
  if (light.irradiance > 0.0) {
    field += rho < 1.0 ? light.irradiance * std::numbers::inv_pi / (1.0 - rho)
                       : std::numeric_limits<double>::infinity();
  }
  return std::pow(rho, n) * field;
}

double threshold_loss(double rho, double r, int bounces) noexcept {
  if (!(rho > 0.0 && r > 0.0)) return 0.0;
  double lost = 0.0, before = 0.0, light = rho;
  for (int k = 1; k <= bounces && before < 1.0; ++k) {
    light *= rho;
    const double chance = upper_gamma(
        k, 2.0 * (k * std::log(r) - std::log(radiometry::thresholds::full_background_weight)));
    lost += light * (chance - before);
    before = chance;
  }
  return lost;
}

BiasByBand bias_terms(const SceneFacts& facts, const EffectPlan& effects,
                      const SolverChoice& solver, const ByBand& wavelength_error,
                      double air_table_error) {
  BiasByBand all(facts.arrays.size());
  for (std::size_t a = 0; a < facts.arrays.size(); ++a) {
    const EffectSet on = effects.by_array.at(a);
    const bool between = on.has(Effect::interreflection) && !facts.one_convex_surface;
    const int n = between ? reflections_from(solver, facts, on) : 0;
    for (std::size_t b = 0; b < facts.arrays[a].bands.size(); ++b) {
      const BandFacts& band = facts.arrays[a].bands[b];
      const double floor = at_or_zero(effects.floor_radiance, a, b);
      const double radiance = glow_or_floor(band, on, floor);
      const LightBound light = light_bound(band, on, facts.gloss);
      BiasTerms& terms = all[a].emplace_back();
      terms.dropped_effects = at_or_zero(effects.dropped, a, b);
      terms.wavelengths = at_or_zero(wavelength_error, a, b);
      if (n > 0) {
        terms.bounce_limit =
            relative_to(light_beyond(n, band.greatest_reflectance, light), radiance);
      }
      if (n > 0 && solver.method == radiometry::Method::generic) {
        terms.thresholds = relative_to(thresholds_of(band, n - 2, light), radiance);
      }
      if (air_table_error > 0.0) {
        terms.air_table = (air_table_error + air_solver_rms) * air_share(band, on, floor);
      }
    }
  }
  return all;
}

}  // namespace nadir::sim
