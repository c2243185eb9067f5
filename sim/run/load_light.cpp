#include "sim/run/load_light.hpp"

#include <cmath>
#include <optional>

#include "ephemeris/bodies.hpp"
#include "sim/run/error_list.hpp"
#include "sim/run/read_curves.hpp"

namespace nadir::sim {
namespace {

using spectral::Outside;

ephemeris::Illumination light_from(const ComputedSky& sky, const Scenario& scenario,
                                   InputFiles& files) {
  const ephemeris::Site site{scenario.origin.latitude_deg, scenario.origin.longitude_deg,
                             scenario.origin.height_m};
  const auto positions = ephemeris::sun_and_moon(scenario.time, site);
  const auto irradiance = [&](const SpectralInput& input) {
    return curve_of(input, SpectrumQuantity::irradiance, Outside::reject, files);
  };
  // A sun without irradiance is dark, but the truth planes still tell where it stands.
  const auto solar =
      sky.solar_irradiance ? irradiance(*sky.solar_irradiance) : spectral::Curve::constant(0.0);
  std::optional<spectral::Curve> lunar;
  if (sky.lunar_irradiance) lunar = irradiance(*sky.lunar_irradiance);
  return ephemeris::illumination(positions, solar, lunar);
}

ephemeris::Illumination light_from(const FixedSky& sky, const Scenario& /*scenario*/,
                                   InputFiles& files) {
  ephemeris::Illumination bodies;
  ErrorList errors;
  for (const FixedBody& body : sky.bodies) {
    errors.attempt([&] {
      bodies.push_back(ephemeris::fixed_light(
          {body.name, degrees(body.azimuth_deg), degrees(body.elevation_deg),
           degrees(body.angular_radius_deg)},
          curve_of(body.irradiance, SpectrumQuantity::irradiance, Outside::reject, files)));
    });
  }
  errors.throw_if_any();
  return bodies;
}

atmosphere::Atmosphere air_from(const NoAir& /*none*/, InputFiles& /*files*/) {
  return atmosphere::None{};
}

atmosphere::Atmosphere air_from(const UniformAir& air, InputFiles& files) {
  const auto curve = [&](const SpectralInput& input, SpectrumQuantity quantity) {
    return curve_of(input, quantity, Outside::reject, files);
  };
  return atmosphere::Uniform{
      curve(air.sky_radiance, SpectrumQuantity::radiance),
      Kelvin{air.sky_temperature_k},
      curve(air.solar_transmittance, SpectrumQuantity::transmittance),
      curve(air.transmittance, SpectrumQuantity::transmittance),
      curve(air.path_radiance, SpectrumQuantity::radiance),
      Kelvin{air.air_temperature_k},
      air.overcast ? atmosphere::SkyShape::overcast : atmosphere::SkyShape::even};
}

}  // namespace

void warn_of_bright_night(const Scenario& scenario, const ephemeris::Illumination& bodies,
                          const atmosphere::Atmosphere& air, Diagnostics& diagnostics) {
  const auto* uniform = std::get_if<atmosphere::Uniform>(&air);
  if (uniform == nullptr || !std::holds_alternative<ComputedSky>(scenario.illumination)) return;
  // Skies that the moon or a city brightens are below 1e-3. Twilight is more from 6 degrees below
  // the horizon on: 2 to 3.5 lx there (AMS Glossary of Meteorology, "civil twilight") is some 0.01
  // where the 15,000 lx of a clear day's sky are 75.
  constexpr double brightest_night = 0.01;  // W m^-2 sr^-1 um^-1
  const Micrometres green{0.55};
  const auto bright = [&](const spectral::Curve& curve) {
    return curve.covers(green, green) && curve.at(green) > brightest_night;
  };
  const auto& sun = bodies.front();
  if (sun.direction_enu.z > -std::sin(sun.angular_radius.value)) return;
  if (!bright(uniform->sky_radiance) && !bright(uniform->path_radiance)) return;
  diagnostics.warn(
      "the sun is below the horizon, but the uniform atmosphere's sky or path is as bright in the "
      "visible as its figures say");
}

ephemeris::Illumination load_illumination(const Scenario& scenario, InputFiles& files) {
  return std::visit([&](const auto& sky) { return light_from(sky, scenario, files); },
                    scenario.illumination);
}

atmosphere::Atmosphere load_atmosphere(const Scenario& scenario, InputFiles& files) {
  return std::visit([&](const auto& air) { return air_from(air, files); }, scenario.air);
}

}  // namespace nadir::sim
