#include "sim/run/air_facts.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "atmosphere/make/levels.hpp"
#include "sim/run/surface_facts.hpp"

namespace nadir::sim {
namespace {

constexpr double not_known = std::numeric_limits<double>::infinity();

double or_unknown(double value) { return std::isfinite(value) ? std::max(value, 0.0) : not_known; }

void add_light_of(const atmosphere::None& /*none*/, const AirSurroundings& /*about*/,
                  BandFacts& /*band*/) {}

void add_light_of(const atmosphere::Uniform& air, const AirSurroundings& /*about*/,
                  BandFacts& band) {
  constexpr double overcast_zenith = 9.0 / 7.0;  // 3/7 (1 + 2 cos z) at its greatest
  const BandEnds ends{band.lo_um, band.hi_um};
  const CurveRange sky = range_within(air.sky_radiance, ends);
  const bool even = air.sky_shape == atmosphere::SkyShape::even;
  band.sky_scattering = or_unknown(sky.greatest * (even ? 1.0 : overcast_zenith));
  band.least_sky_scattering = std::isfinite(sky.least) ? sky.least : 0.0;
  band.sky_emission = greatest_planck(ends, air.sky_temperature.value);
  band.path_scattering = or_unknown(range_within(air.path_radiance, ends).greatest);
  const double least = range_within(air.transmittance, ends).least;
  band.path_loss = std::isfinite(least) ? std::clamp(1.0 - least, 0.0, 1.0) : 1.0;
  band.path_emission = band.path_loss * greatest_planck(ends, air.air_temperature.value);
}

/// Nobody knows how it was made: a night's table may shine.
void add_light_of(const atmosphere::Tabulated& /*air*/, const AirSurroundings& /*about*/,
                  BandFacts& band) {
  band.sky_scattering = band.sky_emission = not_known;
  band.path_scattering = band.path_emission = not_known;
  band.path_loss = 1.0;
}

/// Vertical optical depth of scattering by haze and clouds.
class ParticleDepth {
 public:
  explicit ParticleDepth(const atmosphere::Layered& air)
      : particles_{air.particles, air.aerosol, air.clouds,
                   atmosphere::column_levels_m(air.profile, air.aerosol, air.clouds,
                                               air.ground_height_m)} {}

  [[nodiscard]] double at(Micrometres wavelength) const {
    double depth = 0.0;
    for (int kind = 0; kind < particles_.kinds(); ++kind) {
      double of_kind = 0.0;
      for (const double layer : particles_.depth_550(kind)) of_kind += layer;
      depth += of_kind * particles_.scattering(kind, wavelength);
    }
    return depth;
  }

 private:
  atmosphere::Particles particles_;
};

/// Of the air up to some 80 km: above, where the thermosphere may have 1000 K, is a
/// hundred-thousandth of it, too thin to be seen to emit at 0.3 to 14 um.
double warmest_air_k(const atmosphere::Layered& air) {
  constexpr double thinnest_hpa = 0.01;
  double warmest = 0.0;
  for (const atmosphere::Level& level : air.profile.levels) {
    if (level.pressure_hpa < thinnest_hpa) continue;
    warmest = std::max(warmest, level.temperature_k);
  }
  return warmest;
}

double greatest_of(const spectral::Curve& curve, BandEnds ends) {
  const double greatest = range_within(curve, ends).greatest;
  return std::isfinite(greatest) ? std::max(greatest, 0.0) : 0.0;
}

/// Light of the moonless sky: airglow and a town's glow are brighter towards the horizon; half as
/// much again for what the air and the ground make of it.
struct NightLight {
  double greatest = 0.0, least = 0.0;
};
NightLight night_light(const atmosphere::NightSky& night, BandEnds ends) {
  constexpr double van_rhijn_horizon = 5.0, town_horizon = 3.1, scattered = 1.5;
  const double airglow = greatest_of(night.airglow, ends),
               stars = greatest_of(night.starlight, ends);
  const double town = greatest_of(night.urban_glow, ends);
  const auto least_of = [&](const spectral::Curve& curve) {
    const double least = range_within(curve, ends).least;
    return std::isfinite(least) ? std::max(least, 0.0) : 0.0;
  };
  return {scattered * (van_rhijn_horizon * airglow + stars + town_horizon * town),
          least_of(night.airglow) + least_of(night.starlight) + least_of(night.urban_glow)};
}

/// A clear sky without haze, half of what it scatters going up, half of that lost to gases: no
/// bound, but what a shaded place may count on.
double plain_sky(double depth, Angle elevation) {
  constexpr double down_and_left = 0.25;
  const double sine = std::max(std::sin(elevation.value), 0.05);
  return down_and_left * sine * (1.0 - std::exp(-depth / sine)) * twilight_share(elevation) /
         std::numbers::pi;
}

double ground_reflectance(const AirTask& task, const BandFacts& band) {
  if (!task.ground.reflectance) return band.greatest_reflectance;
  const double stated = range_within(*task.ground.reflectance, {band.lo_um, band.hi_um}).greatest;
  return std::isfinite(stated) ? stated : 1.0;
}

void add_scattering(const AirTask& task, const BandIrradiance& light, const AirSurroundings& about,
                    BandFacts& band) {
  const atmosphere::Layered& layers = task.layered->air;
  const ParticleDepth particles{layers};
  const double pressure_hpa =
      atmosphere::level_at(layers.profile, layers.ground_height_m).pressure_hpa;
  // Straight towards a body at the horizon.
  constexpr SightLine beside_body{.air_mass = 40.0, .cos_scattering = 1.0};
  double least = not_known;
  for (std::size_t i = 0; i < light.wavelengths_um.size(); ++i) {
    const Micrometres wavelength{light.wavelengths_um[i]};
    const double rayleigh = rayleigh_depth(wavelength, pressure_hpa);
    const ScatteringAir air{rayleigh + particles.at(wavelength), ground_reflectance(task, band)};
    double sky = 0.0, path = 0.0, plain = 0.0;
    const auto add = [&](double irradiance, const BodyHeight& body) {
      if (!(irradiance > 0.0)) return;
      sky += irradiance * scattered_share_on_slopes(air, body.elevation) / std::numbers::pi;
      if (about.peaks_count) sky += irradiance * path_share(air, beside_body, body.elevation);
      path += irradiance * path_share(air, {about.air_mass, body.cos_scattering}, body.elevation);
      plain += std::isfinite(irradiance) ? irradiance * plain_sky(rayleigh, body.elevation) : 0.0;
    };
    add(light.sun[i], about.sun);
    add(light.moon[i], about.moon);
    band.sky_scattering = std::max(band.sky_scattering, sky);
    band.path_scattering = std::max(band.path_scattering, path);
    least = std::min(least, plain);
  }
  band.least_sky_scattering = std::isfinite(least) ? least : 0.0;
}

void add_layered(const AirTask& task, const BandIrradiance& light, const AirSurroundings& about,
                 BandFacts& band) {
  const BandEnds ends{band.lo_um, band.hi_um};
  add_scattering(task, light, about, band);
  const NightLight night = night_light(task.layered->air.night, ends);
  band.sky_scattering += night.greatest;
  band.path_scattering += night.greatest;
  band.least_sky_scattering += night.least;
  const double ground_k =
      task.ground.temperature ? task.ground.temperature->value : about.warmest_ground_k;
  const double emission =
      greatest_planck(ends, std::max(warmest_air_k(task.layered->air), ground_k));
  band.sky_emission = emission;
  band.path_emission = emission;
  band.path_loss = 1.0;  // somewhere in the band, perhaps: of gases nothing is looked up
}

}  // namespace

void add_air_light(const atmosphere::Atmosphere& air, const AirTask* task,
                   const BandIrradiance& light, const AirSurroundings& about, BandFacts& band) {
  if (task != nullptr && task->layered) {
    add_layered(*task, light, about, band);
  } else {
    std::visit([&](const auto& known) { add_light_of(known, about, band); }, air);
  }
}

}  // namespace nadir::sim
