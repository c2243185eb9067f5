#pragma once
// What the tests of effects share: rendering with a set of them, and scenes that have them all.

#include <array>
#include <string>
#include <vector>

#include "radiometry/lamp_helpers.hpp"
#include "radiometry/small_scene.hpp"

namespace nadir::radiometry::test {

/// By the solver that the scene names.
inline Measured measure_effects(const SceneDescription& scene, const spectral::Lanes& lanes,
                                const geometry::Ray& ray, EffectSet effects, int replicates = 8,
                                int samples = 8) {
  Diagnostics diagnostics;
  const LitScene lit{scene, lanes, diagnostics, effects};
  if (scene.method == Method::path) {
    return measure_with(PathSolver{lit}, lit, ray, replicates, samples, 1);
  }
  return measure_with(GenericSolver{lit}, lit, ray, replicates, samples, 1);
}

/// Effects that bring light, each on its own; the others change light that is there.
inline constexpr std::array sources{
    Effect::solar_reflection, Effect::lunar_reflection, Effect::lamps,
    Effect::sky_scattering,   Effect::sky_emission,     Effect::surface_emission,
    Effect::path_scattering,  Effect::path_emission};

[[nodiscard]] inline EffectSet alone(Effect source) {
  EffectSet effects = EffectSet::all();
  for (const Effect other : sources) {
    if (other != source) effects = effects.without(other);
  }
  return effects;
}
[[nodiscard]] inline EffectSet without_sources() {
  EffectSet effects = EffectSet::all();
  for (const Effect source : sources) effects = effects.without(source);
  return effects;
}

/// Air with every term that it can have.
inline atmosphere::Uniform full_air() {
  const auto curve = [](double value) { return spectral::Curve::constant(value); };
  return {curve(0.6), Kelvin{260.0}, curve(0.85), curve(0.7), curve(0.4), Kelvin{285.0}};
}

inline ephemeris::LightSource body(const std::string& name, double elevation_deg, double irradiance,
                                   double radius_deg = 1e-4) {
  return {name, direction_enu(degrees(150.0).value, degrees(elevation_deg).value),
          degrees(radius_deg), spectral::Curve::constant(irradiance)};
}

inline materials::Material leaf(double reflectance, double transmittance) {
  materials::Material material = grey(reflectance);
  material.name = "leaf";
  material.transmittance = spectral::Curve::constant(transmittance);
  material.scattering = materials::Leaf{};
  return material;
}

inline bool agree(const Estimate& found, double expected, double rounding = 2e-5) {
  const double noise = std::isfinite(found.standard_error) ? found.standard_error : 0.0;
  return std::abs(found.mean - expected) <= 4.5 * noise + rounding * std::abs(expected);
}

}  // namespace nadir::radiometry::test
