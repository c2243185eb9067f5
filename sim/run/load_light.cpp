#include "sim/run/load_light.hpp"

#include "ephemeris/bodies.hpp"
#include "sim/run/error_list.hpp"
#include "sim/run/read_curves.hpp"

namespace nadir::sim {
namespace {

using spectral::Outside;

ephemeris::Illumination light_from(const ComputedSky& sky, const Scenario& scenario,
                                   InputFiles& files, Diagnostics& diagnostics) {
  const ephemeris::Site site{scenario.origin.latitude_deg, scenario.origin.longitude_deg,
                             scenario.origin.height_m};
  if (const auto caution = scenario.time.caution()) diagnostics.warn(*caution);
  const auto positions = ephemeris::sun_and_moon(scenario.time, site);
  const auto irradiance = [&](const SpectralInput& input) {
    return curve_of(input, SpectrumQuantity::irradiance, Outside::reject, files);
  };
  ephemeris::Illumination bodies;
  if (sky.solar_irradiance) {
    bodies.push_back(ephemeris::sun_light(positions.sun, irradiance(*sky.solar_irradiance)));
  }
  if (sky.lunar_irradiance) {
    bodies.push_back(ephemeris::moon_light(positions.moon, irradiance(*sky.lunar_irradiance)));
  }
  return bodies;
}

ephemeris::Illumination light_from(const FixedSky& sky, const Scenario& /*scenario*/,
                                   InputFiles& files, Diagnostics& /*diagnostics*/) {
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
  return atmosphere::Uniform{curve(air.sky_radiance, SpectrumQuantity::radiance),
                             Kelvin{air.sky_temperature_k},
                             curve(air.solar_transmittance, SpectrumQuantity::transmittance),
                             curve(air.transmittance, SpectrumQuantity::transmittance),
                             curve(air.path_radiance, SpectrumQuantity::radiance),
                             Kelvin{air.air_temperature_k}};
}

}  // namespace

ephemeris::Illumination load_illumination(const Scenario& scenario, InputFiles& files,
                                          Diagnostics& diagnostics) {
  return std::visit([&](const auto& sky) { return light_from(sky, scenario, files, diagnostics); },
                    scenario.illumination);
}

atmosphere::Atmosphere load_atmosphere(const Scenario& scenario, InputFiles& files) {
  return std::visit([&](const auto& air) { return air_from(air, files); }, scenario.air);
}

}  // namespace nadir::sim
