#include "sim/run/drop_effects.hpp"

#include <algorithm>
#include <array>
#include <string_view>
#include <variant>

#include "radiometry/air_effects.hpp"

namespace nadir::sim {
namespace {

using radiometry::Effect;
using radiometry::EffectSet;

bool scatters(EffectSet any) {
  return any.has(Effect::sky_scattering) || any.has(Effect::path_scattering);
}

/// Whether the air's light is made from that of sun and moon.
bool air_needs_bodies(const Scenario& scenario, EffectSet any) {
  const bool from_bodies = std::holds_alternative<LayeredAir>(scenario.air) ||
                           std::holds_alternative<TableAir>(scenario.air);
  return from_bodies && scatters(any);
}

void drop_bodies(Scenario& scenario, EffectSet any) {
  const bool by_air = air_needs_bodies(scenario, any);
  const bool sun = by_air || any.has(Effect::solar_reflection);
  const bool moon = by_air || any.has(Effect::lunar_reflection);
  if (auto* computed = std::get_if<ComputedSky>(&scenario.illumination)) {
    computed->sun_shines = sun;
    computed->moon_shines = moon;
    computed->eclipses = any.has(Effect::eclipse);
    return;
  }
  for (FixedBody& body : std::get<FixedSky>(scenario.illumination).bodies) {
    const bool shines = body.name == "moon" ? moon : sun;
    if (!shines) body.irradiance = {0.0, {}};
  }
}

bool is_unsolved(const TemperatureInput& temperature) {
  return std::holds_alternative<HeatBalanceInput>(temperature) ||
         std::holds_alternative<AirTemperatureInput>(temperature);
}

/// Whether weather must be made from the air.
bool makes_weather(const Scenario& scenario, EffectSet any) {
  const bool clear_sky =
      !scenario.heat || std::holds_alternative<ClearSkyInput>(scenario.heat->weather);
  const bool solves = any.has(Effect::thermal_solve) || scenario.products.truth_temperature;
  return clear_sky && solves &&
         std::any_of(scenario.materials.begin(), scenario.materials.end(),
                     [](const MaterialInput& m) { return is_unsolved(m.temperature); });
}

void drop_air(Scenario& scenario, EffectSet any) {
  const bool stated_off =
      scenario.effects.of(Effect::refraction) == EffectState::off && !any.has(Effect::refraction);
  if (auto* layers = std::get_if<LayeredAir>(&scenario.air)) {
    if (stated_off) layers->refraction = false;
    if (!scatters(any)) {
      layers->night_sky = false;
      layers->urban_glow.reset();
    }
  }
  if (!radiometry::needs_air(any) && !makes_weather(scenario, any)) scenario.air = NoAir{};
}

void drop_heat(Scenario& scenario, EffectSet any) {
  const bool stated_off = scenario.effects.of(Effect::thermal_solve) == EffectState::off;
  if (any.has(Effect::thermal_solve)) return;
  // Where nobody sees what surfaces emit their temperature stays unknown, in the truth as well.
  if (!stated_off && !any.has(Effect::surface_emission)) return;
  const double air_k = air_temperature_k(scenario);
  for (MaterialInput& material : scenario.materials) {
    if (!is_unsolved(material.temperature)) continue;
    const auto* follows = std::get_if<AirTemperatureInput>(&material.temperature);
    const double offset_k = follows == nullptr ? 0.0 : follows->offset_k;
    material.temperature = ConstantTemperatureInput{std::max(0.0, air_k + offset_k)};
  }
}

void drop_camera(Scenario& scenario, EffectSet any) {
  if (!any.has(Effect::psf)) {
    for (ArrayInput& array : scenario.camera.arrays) array.blur = {};
  }
  if (!any.has(Effect::motion_blur) && scenario.platform.jitter) {
    scenario.platform.jitter->white_urad = {};
    if (!scenario.platform.jitter->spectrum) scenario.platform.jitter.reset();
  }
}

/// Temperature at the ground, K, of the standard profiles. Source: Anderson et al., AFGL
/// Atmospheric Constituent Profiles, AFGL-TR-86-0110 (1986), table 1.
struct GroundAir {
  std::string_view profile;
  double kelvin;
};
constexpr auto ground_air = std::to_array<GroundAir>({{"tropical", 299.7},
                                                      {"midlatitude_summer", 294.2},
                                                      {"midlatitude_winter", 272.2},
                                                      {"subarctic_summer", 287.2},
                                                      {"subarctic_winter", 257.2},
                                                      {"us_standard_1976", 288.2}});

void quieten(sensor::Detector& detector) {
  detector.noisy = false;
  detector.dead_share = 0.0;
  if (auto* photons = std::get_if<sensor::PhotonDetector>(&detector.element)) {
    photons->prnu = 0.0;
    photons->dsnu_e = 0.0;
  }
}

}  // namespace

double air_temperature_k(const Scenario& scenario) {
  constexpr double standard_k = 288.15;
  if (scenario.heat) {
    if (const auto* clear = std::get_if<ClearSkyInput>(&scenario.heat->weather)) {
      return 0.5 * (clear->air_low_k + clear->air_high_k);
    }
  }
  if (const auto* layers = std::get_if<LayeredAir>(&scenario.air)) {
    const auto* known =
        std::find_if(ground_air.begin(), ground_air.end(),
                     [&](const GroundAir& air) { return air.profile == layers->profile; });
    return known != ground_air.end() ? known->kelvin : standard_k;
  }
  const auto* uniform = std::get_if<UniformAir>(&scenario.air);
  return uniform != nullptr && uniform->air_temperature_k > 0.0 ? uniform->air_temperature_k
                                                                : standard_k;
}

void drop_effects(Scenario& scenario, EffectSet any) {
  if (!any.has(Effect::lamps)) scenario.lamps.clear();
  if (!any.has(Effect::volumes)) scenario.volumes.clear();
  drop_bodies(scenario, any);
  drop_heat(scenario, any);  // before the air, whose temperature it takes
  drop_air(scenario, any);
  drop_camera(scenario, any);
}

void drop_effects(Camera& camera, const std::vector<EffectSet>& by_array) {
  for (std::size_t i = 0; i < std::min(by_array.size(), camera.arrays.size()); ++i) {
    sensor::DetectorArray& array = camera.arrays[i];
    if (!by_array[i].has(Effect::psf)) array.spread.reset();
    array.timing.still = !by_array[i].has(Effect::motion_blur);
    if (by_array[i].has(Effect::detector_noise) || i >= camera.electronics.size()) continue;
    for (BandElectronics& band : camera.electronics[i]) {
      if (band.detector) quieten(*band.detector);
    }
  }
}

}  // namespace nadir::sim
