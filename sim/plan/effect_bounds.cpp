#include "sim/plan/effect_bounds.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace nadir::sim {
namespace {

using radiometry::Effect;
using radiometry::EffectSet;

constexpr double unknown = std::numeric_limits<double>::infinity();

/// 0 times infinity is 0: nothing of what nobody knows is nothing.
double product(double a, double b) { return a == 0.0 || b == 0.0 ? 0.0 : a * b; }

/// What light that has left a surface once comes to after all further reflections.
double after_reflections(double once, const BoundContext& c) {
  if (once == 0.0 || c.scene.one_convex_surface) return once;
  const double rho = c.band.greatest_reflectance;
  return rho < 1.0 ? once / (1.0 - rho) : unknown;
}

/// Relative to a pixel that sees a surface: it shows at least what that emits. What the path takes
/// away it takes from both, what it adds makes the share smaller.
double of_surface(double radiance, const BoundContext& c) {
  return product(radiance, 1.0 / std::max(c.floor, c.least_emission));
}
/// Relative to any pixel.
double of_pixel(double radiance, const BoundContext& c) { return product(radiance, 1.0 / c.floor); }

double directly_reflected(double irradiance, const BoundContext& c) {
  return product(irradiance, c.band.greatest_reflectance * c.scene.gloss / std::numbers::pi);
}

double body(double irradiance, const BoundContext& c) {
  if (irradiance == 0.0) return 0.0;
  // The disc itself, and what smoke makes of it, have no bound worth having.
  if (c.scene.body_in_view || c.scene.has_volumes) return unknown;
  return of_surface(after_reflections(directly_reflected(irradiance, c), c), c);
}

double lamp_light(const BoundContext& c) {
  return c.band.lamp_radiance + directly_reflected(c.band.lamp_irradiance, c);
}

/// Of a sky that is nowhere brighter. In smoke it shows as it is.
double sky(double radiance, const BoundContext& c) {
  const double first = product(radiance, c.band.greatest_reflectance);
  const double reflected = of_surface(after_reflections(first, c), c);
  return c.scene.sky_in_view || c.scene.has_volumes ? reflected + of_pixel(radiance, c) : reflected;
}

/// Nothing in the scene is brighter, but the discs of sun and moon.
double brightest(const BoundContext& c) {
  const BandFacts& b = c.band;
  const double direct = directly_reflected(b.sun_irradiance + b.moon_irradiance, c);
  const double diffuse = product(b.greatest_reflectance, b.sky_scattering + b.sky_emission);
  const double own = product(b.greatest_emissivity, b.warmest_emission);
  return after_reflections(direct + lamp_light(c) + diffuse + own, c);
}

/// The greatest radiance that a surface reflects, whatever it emits.
double brightest_reflection(const BoundContext& c) {
  const BandFacts& b = c.band;
  const double direct = directly_reflected(b.sun_irradiance + b.moon_irradiance, c);
  const double about = b.sky_scattering + b.sky_emission + b.lamp_radiance +
                       product(b.greatest_emissivity, b.warmest_emission);
  return after_reflections(
      direct + directly_reflected(b.lamp_irradiance, c) + product(b.greatest_reflectance, about),
      c);
}

/// Light reflected twice and more: what one surface reflects, reflected by another.
double interreflection(const BoundContext& c) {
  if (c.scene.one_convex_surface) return 0.0;
  // Smoke and flames shine on surfaces, too, and nothing is known of how bright they are.
  if (c.scene.has_volumes) return c.band.greatest_reflectance > 0.0 ? unknown : 0.0;
  return of_surface(product(c.band.greatest_reflectance, brightest_reflection(c)), c);
}

double leaf_transmission(const BoundContext& c) {
  const BandFacts& b = c.band;
  if (!c.scene.has_leaves || b.greatest_transmittance == 0.0) return 0.0;
  if (c.scene.has_volumes) return unknown;
  const double direct = product(b.sun_irradiance + b.moon_irradiance + b.lamp_irradiance,
                                c.scene.gloss / std::numbers::pi);
  const double incident = direct + b.sky_scattering + b.sky_emission + brightest(c);
  return of_surface(after_reflections(product(b.greatest_transmittance, incident), c), c);
}

double shadows(const BoundContext& c) {
  if (c.scene.one_convex_surface) return 0.0;
  const double direct =
      directly_reflected(c.band.sun_irradiance + c.band.moon_irradiance, c) + lamp_light(c);
  return direct > 0.0 && c.scene.has_volumes ? unknown
                                             : of_surface(after_reflections(direct, c), c);
}

/// The greatest difference between two pixels: what is next to a pixel may be mixed into it.
double greatest_contrast(const BoundContext& c) {
  if (c.scene.body_in_view || c.scene.has_volumes) return unknown;
  const BandFacts& b = c.band;
  return of_pixel(brightest(c) + b.path_scattering + b.path_emission +
                      (c.scene.sky_in_view ? b.sky_scattering + b.sky_emission : 0.0),
                  c);
}

double eclipse(const BoundContext& c) {
  const BandFacts& b = c.band;
  const double lit = body(b.sun_irradiance, c) + body(b.moon_irradiance, c) +
                     sky(b.sky_scattering, c) + of_pixel(b.path_scattering, c);
  return product(c.scene.eclipsed_share, lit);
}

/// Without it what it takes away is there: (1 - tau) L beside tau L.
double path_transmittance(const BoundContext& c) {
  return c.band.path_loss < 1.0 ? c.band.path_loss / (1.0 - c.band.path_loss) : unknown;
}

using Bound = double (*)(const BoundContext&);

/// In the order of the enumeration.
constexpr std::array<Bound, radiometry::effect_count> bounds{
    [](const BoundContext& c) { return body(c.band.sun_irradiance, c); },
    [](const BoundContext& c) { return body(c.band.moon_irradiance, c); },
    [](const BoundContext& c) {
      const double light = lamp_light(c);
      if (light > 0.0 && c.scene.has_volumes) return unknown;
      return of_surface(after_reflections(light, c), c);
    },
    [](const BoundContext& c) { return sky(c.band.sky_scattering, c); },
    [](const BoundContext& c) {
      return of_surface(
          after_reflections(product(c.band.greatest_emissivity, c.band.warmest_emission), c), c);
    },
    [](const BoundContext& c) { return sky(c.band.sky_emission, c); },
    [](const BoundContext& c) { return of_pixel(c.band.path_scattering, c); },
    [](const BoundContext& c) { return of_pixel(c.band.path_emission, c); }, path_transmittance,
    interreflection, leaf_transmission,
    [](const BoundContext& c) { return c.scene.has_volumes ? unknown : 0.0; }, shadows,
    // Displacements by (x, y) pixels change a pixel by at most (|x| + |y|) times the contrast.
    [](const BoundContext& c) {
      return product(std::numbers::sqrt2 * c.array.refraction_pixels, greatest_contrast(c));
    },
    eclipse,
    [](const BoundContext& c) {
      return product(std::numbers::sqrt2 * c.array.smear_pixels, greatest_contrast(c));
    },
    [](const BoundContext& c) {
      return product(std::numbers::sqrt2 * c.array.spread_pixels, greatest_contrast(c));
    },
    [](const BoundContext& c) { return of_pixel(c.band.noise_radiance, c); },
    [](const BoundContext& c) {
      return of_surface(
          after_reflections(product(c.band.greatest_emissivity, c.band.warmest_solved_emission), c),
          c);
    }};

std::string below_horizon(const char* name, double elevation_deg, bool is_there) {
  if (is_there) return fmt::format("the {} gives no light", name);
  if (elevation_deg > 0.0) return fmt::format("the scenario has no {}", name);
  return fmt::format("the {} is {:.0f} deg below the horizon", name, -elevation_deg);
}

}  // namespace

double floor_radiance(const BandFacts& band, const AccuracyInput& accuracy) {
  // A vertical wall of reflectance 0.2 beside a place in shade sends it a tenth of 0.2 of the
  // direct light; 0.02 is also what the darkest ordinary surfaces (water, wet asphalt) reflect.
  constexpr double dark = 0.02, of_surroundings = 0.02;
  if (accuracy.floor_radiance) return *accuracy.floor_radiance;
  if (band.noise_radiance > 0.0) {
    return accuracy.noise_fraction * band.noise_radiance / accuracy.relative;
  }
  const double direct = band.level_irradiance;
  const double about =
      std::max(band.least_sky_scattering,
               std::isfinite(direct) ? of_surroundings * direct / std::numbers::pi : 0.0);
  const double floor = band.least_emissivity * band.coldest_emission +
                       std::max(band.least_reflectance, dark) * about;
  // of an image that is dark everywhere, so that bounds can be told at all
  return std::max(floor, static_cast<double>(std::numeric_limits<float>::min()));
}

double effect_bound(Effect effect, const BoundContext& context) {
  return bounds[radiometry::index_of(effect)](context);
}

BandFacts facts_without(BandFacts b, EffectSet left_out) {
  const auto none_of = [&](Effect effect, auto&... figures) {
    if (left_out.has(effect)) ((figures = 0.0), ...);
  };
  none_of(Effect::solar_reflection, b.sun_irradiance);
  none_of(Effect::lunar_reflection, b.moon_irradiance);
  if (left_out.has(Effect::solar_reflection) && left_out.has(Effect::lunar_reflection)) {
    b.level_irradiance = 0.0;
  }
  none_of(Effect::lamps, b.lamp_irradiance, b.lamp_radiance);
  none_of(Effect::sky_scattering, b.sky_scattering, b.least_sky_scattering);
  none_of(Effect::surface_emission, b.coldest_emission, b.warmest_emission,
          b.warmest_solved_emission);
  none_of(Effect::sky_emission, b.sky_emission);
  none_of(Effect::path_scattering, b.path_scattering);
  none_of(Effect::path_emission, b.path_emission);
  none_of(Effect::path_transmittance, b.path_loss);
  none_of(Effect::leaf_transmission, b.greatest_transmittance);
  none_of(Effect::detector_noise, b.noise_radiance);
  none_of(Effect::thermal_solve, b.warmest_solved_emission);
  return b;
}

SceneFacts scene_without(SceneFacts scene, EffectSet left_out) {
  if (left_out.has(Effect::volumes)) scene.has_volumes = false;
  return scene;
}

std::string why_absent(Effect effect, const SceneFacts& facts) {
  switch (effect) {
    case Effect::solar_reflection:
      return below_horizon("sun", facts.sun_elevation_deg, facts.has_sun);
    case Effect::lunar_reflection:
      if (facts.moon_drowned) return "the sun is up: the moon has less than 1e-4 of its light";
      return below_horizon("moon", facts.moon_elevation_deg, facts.has_moon);
    case Effect::lamps:
      return facts.has_lamps ? "the lamps give no light" : "the scenario has no lamps";
    case Effect::sky_scattering:
    case Effect::path_scattering:
      return facts.has_air ? "there is no light for the air to scatter" : "the scenario has no air";
    case Effect::sky_emission:
    case Effect::path_emission:
      return facts.has_air ? "the air emits nothing" : "the scenario has no air";
    case Effect::path_transmittance:
      return facts.has_air ? "the air takes nothing away" : "the scenario has no air";
    case Effect::surface_emission:
      return "all surfaces are at 0 K or black bodies' radiance is 0 here";
    case Effect::interreflection:
      return facts.one_convex_surface ? "no surface sees another one" : "no surface has light";
    case Effect::leaf_transmission:
      return "nothing lets light through";
    case Effect::volumes:
      return "the scenario has no volumes";
    case Effect::shadows:
      return facts.one_convex_surface ? "nothing can throw a shadow"
                                      : "no sun, moon or lamp throws shadows";
    case Effect::refraction:
      return facts.has_refraction ? "lines of sight bend by less than can be told"
                                  : "the scenario's air does not refract";
    case Effect::eclipse:
      return "no eclipse";
    case Effect::motion_blur:
      return "neither the sensor nor its line of sight moves during an exposure";
    case Effect::psf:
      return "the optics have no spread";
    case Effect::detector_noise:
      return "the camera has no detector";
    case Effect::thermal_solve:
      return facts.has_solved_temperatures ? "no band sees what surfaces emit"
                                           : "no temperature is to be solved";
  }
  return {};
}

}  // namespace nadir::sim
