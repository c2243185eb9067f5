#include "sim/run/clear_sky_weather.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

#include "atmosphere/broadband/broadband_fluxes.hpp"
#include "core/constants.hpp"
#include "ephemeris/sun_moon.hpp"
#include "sim/files/data_directory.hpp"
#include "sim/run/load_air.hpp"
#include "sim/run/read_curves.hpp"
#include "spectral/planck.hpp"
#include "thermal/weather/clear_sky.hpp"

namespace nadir::sim {
namespace {

using spectral::Curve;
using std::numbers::pi;
using thermal::ClearSkyLight;

constexpr double moment_step_s = 600.0;
constexpr double whole_day_s = 86400.0;
constexpr Micrometres solar_from{0.28}, solar_to{4.0};  // as atmosphere/broadband
constexpr double default_ground_reflectance = 0.2;
/// The least that thermal::check takes for the earth's sky; of no weight beside what warm surfaces
/// emit.
constexpr double cold_sky_w_m2 = 1.0;

/// Light, and what of the air comes with it.
struct ClearAirLight {
  ClearSkyLight light;
  double pressure_hpa = 1013.25;
  bool sky_follows_air = true;
};

/// Standard atmosphere's troposphere (ICAO, Doc 7488).
double standard_pressure(double height_m) {
  return 1013.25 * std::pow(std::max(0.1, 1.0 - 2.25577e-5 * height_m), 5.25588);
}

bool is_zero(const Curve& curve) { return curve.min_value() == 0.0 && curve.max_value() == 0.0; }

/// The sun outside the air at 1 au: the scenario's where it knows all sunlight, else the library's.
Curve sun_outside(const ComputedSky& sky, const ClearSkyInput& input, InputFiles& files,
                  Diagnostics& diagnostics) {
  const auto read = [&](const SpectralInput& from) {
    return curve_of(from, SpectrumQuantity::irradiance, spectral::Outside::reject, files);
  };
  if (sky.solar_irradiance) {
    Curve own = read(*sky.solar_irradiance);
    if (is_zero(own) || (!own.is_constant() && own.covers(solar_from, solar_to))) return own;
    warn_at(
        input.where,
        "the scenario's solar irradiance does not tell all sunlight from 0.28 to 4 um: the heat "
        "balance has the library's sun",
        diagnostics);
  }
  return read({data_directory() / "library" / "illumination" / "solar.csv", {}});
}

std::vector<thermal::SunMoment> sun_moments(const Scenario& scenario, double from_s, double to_s) {
  const ephemeris::Site site{scenario.origin.latitude_deg, scenario.origin.longitude_deg,
                             scenario.origin.height_m};
  std::vector<thermal::SunMoment> moments;
  std::optional<ephemeris::CelestialPole> pole;
  double pole_s = 0.0;
  const int count = static_cast<int>(std::lround((to_s - from_s) / moment_step_s));
  for (int i = 0; i <= count; ++i) {
    const double time_s = from_s + i * moment_step_s;
    const ephemeris::Instant moment = scenario.time + Seconds{time_s};
    if (!pole || time_s - pole_s >= whole_day_s) {
      pole = ephemeris::celestial_pole(moment.tt());
      pole_s = time_s;
    }
    const auto sun = ephemeris::sun_and_moon(moment, site, {}, *pole).sun;
    moments.push_back(
        {time_s, sun.direction_enu.z, sun.distance.value / astro::astronomical_unit_m});
  }
  return moments;
}

// ---- light of each kind of air ------------------------------------------------------------------

ClearAirLight layered_light(const Scenario& scenario, const Curve& sun, InputFiles& files,
                            Diagnostics& diagnostics) {
  const auto task = load_air_task(scenario, files, diagnostics);
  return at_element(task->where, [&] {
    const atmosphere::Layered& air = task->layered->air;
    atmosphere::BroadbandSettings settings;
    settings.ground_reflectance =
        scenario.heat ? scenario.heat->ground_reflectance.value_or(default_ground_reflectance)
                      : default_ground_reflectance;
    auto fluxes = atmosphere::broadband_fluxes(air, settings, sun);
    ClearAirLight made;
    made.light = {std::move(fluxes.cos_zenith), std::move(fluxes.direct_normal_w_m2),
                  std::move(fluxes.diffuse_horizontal_w_m2), fluxes.sky_long_wave_w_m2,
                  fluxes.air_k};
    made.pressure_hpa = atmosphere::level_at(air.profile, air.ground_height_m).pressure_hpa;
    return made;
  });
}

/// Integral of a product of curves over the wavelengths of sunlight at which `other` is known.
struct CoveredSunlight {
  double sun = 0.0;    ///< of the sun alone, where the other is known
  double share = 0.0;  ///< of `other`, times the sun or by itself
};

template <class Value>
CoveredSunlight over_sunlight(const Curve& sun, const Curve& other, const Value& value) {
  constexpr double step_um = 0.005;
  CoveredSunlight sum;
  const int count = static_cast<int>(std::lround((solar_to - solar_from).value / step_um));
  for (int i = 0; i < count; ++i) {
    const Micrometres at{solar_from.value + (i + 0.5) * step_um};
    if (!other.covers(at, at)) continue;
    sum.sun += sun.at(at) * step_um;
    sum.share += value(sun.at(at), other.at(at)) * step_um;
  }
  return sum;
}

/// Long-wave irradiance of a sky whose radiance is tabulated. Where the table ends the air is taken
/// to be opaque, as it nearly is on both sides of the window.
double tabulated_long_wave(const Curve& radiance, Kelvin air) {
  const Micrometres lo{std::max(solar_to.value, radiance.first().value)}, hi = radiance.last();
  const double black = si::stefan_boltzmann * std::pow(air.value, 4);
  if (!(hi > lo)) return black;
  const double known = radiance.mean(lo, hi) * (hi - lo).value;
  return black + pi * (known - spectral::planck_band(lo, hi, air).value);
}

/// The same at all heights of the sun, W m^-2.
struct EvenLight {
  double direct = 0.0, diffuse = 0.0, long_wave = 0.0;
};

ClearSkyLight even_light(const EvenLight& even) {
  ClearSkyLight light;
  light.cos_zenith = {0.0, 1.0};
  light.direct_normal_w_m2 = {even.direct, even.direct};
  light.diffuse_horizontal_w_m2 = {even.diffuse, even.diffuse};
  light.sky_long_wave_w_m2 = std::max(cold_sky_w_m2, even.long_wave);
  return light;
}

ClearAirLight uniform_light(const UniformAir& air, const ClearSkyInput& input, const Curve& sun,
                            InputFiles& files, Diagnostics& diagnostics) {
  const auto read = [&](const SpectralInput& from, SpectrumQuantity quantity) {
    return curve_of(from, quantity, spectral::Outside::reject, files);
  };
  const Curve passed = read(air.solar_transmittance, SpectrumQuantity::transmittance);
  const Curve sky = read(air.sky_radiance, SpectrumQuantity::radiance);
  const double outside = over_sunlight(sun, sun, [](double, double) { return 0.0; }).sun;
  const auto direct = over_sunlight(sun, passed, [](double e, double t) { return e * t; });
  const auto diffuse = over_sunlight(sun, sky, [](double, double l) { return pi * l; });
  // What is not tabulated is as the rest.
  const auto whole = [&](const CoveredSunlight& known) {
    return known.sun > 0.0 ? outside * known.share / known.sun : 0.0;
  };
  double long_wave = si::stefan_boltzmann * std::pow(air.sky_temperature_k, 4);
  if (!sky.is_constant() && sky.last() > solar_to && air.sky_temperature_k <= 0.0) {
    long_wave = tabulated_long_wave(sky, Kelvin{0.5 * (input.air_low_k + input.air_high_k)});
  }
  warn_at(input.where,
          "uniform air is given for one height of the sun: the heat balance has the same direct "
          "sunlight and sky from sunrise to sunset (hint: air in layers knows better)",
          diagnostics);
  ClearAirLight made;
  made.light = even_light({whole(direct), whole(diffuse), long_wave});
  made.sky_follows_air = false;
  return made;
}

/// Figures of sunlight for the scenario's air.
class LightOfAir {
 public:
  LightOfAir(const Scenario& scenario, const ClearSkyInput& input, const Curve& sun,
             InputFiles& files, Diagnostics& diagnostics)
      : scenario_{scenario}, input_{input}, sun_{sun}, files_{files}, diagnostics_{diagnostics} {}

  [[nodiscard]] ClearAirLight operator()(const NoAir& /*air*/) const {
    ClearAirLight made;
    const double outside = sun_.mean(solar_from, solar_to) * (solar_to - solar_from).value;
    made.light = even_light({outside, 0.0, cold_sky_w_m2});
    made.pressure_hpa = standard_pressure(scenario_.origin.height_m);
    made.sky_follows_air = false;
    return made;
  }
  [[nodiscard]] ClearAirLight operator()(const UniformAir& air) const {
    ClearAirLight made = uniform_light(air, input_, sun_, files_, diagnostics_);
    made.pressure_hpa = standard_pressure(scenario_.origin.height_m);
    return made;
  }
  [[nodiscard]] ClearAirLight operator()(const LayeredAir& /*air*/) const {
    return layered_light(scenario_, sun_, files_, diagnostics_);
  }
  [[nodiscard]] ClearAirLight operator()(const TableAir& air) const {
    warn_at(air.where,
            "a table of the air knows the light of its own wavelengths alone: the heat balance's "
            "clear sky is that of the US standard atmosphere with rural haze of 23 km",
            diagnostics_);
    Scenario stand_in;
    stand_in.origin = scenario_.origin;
    stand_in.heat = scenario_.heat;
    LayeredAir layers;
    layers.where = air.where;
    stand_in.air = std::move(layers);
    return layered_light(stand_in, sun_, files_, diagnostics_);
  }

 private:
  const Scenario& scenario_;
  const ClearSkyInput& input_;
  const Curve& sun_;
  InputFiles& files_;
  Diagnostics& diagnostics_;
};

void cut(thermal::TimeSeries& series, double from_s, double to_s) {
  thermal::TimeSeries kept;
  for (std::size_t i = 0; i < series.time_s.size(); ++i) {
    if (series.time_s[i] < from_s || series.time_s[i] > to_s) continue;
    kept.time_s.push_back(series.time_s[i]);
    kept.value.push_back(series.value[i]);
  }
  series = std::move(kept);
}

}  // namespace

thermal::Weather clear_sky_weather_of(const Scenario& scenario, const ClearSkyInput& input,
                                      double history_s, InputFiles& files,
                                      Diagnostics& diagnostics) {
  const auto* sky = std::get_if<ComputedSky>(&scenario.illumination);
  if (sky == nullptr) {
    throw InputError{InputIssue{
        input.where,
        "clear-sky weather needs the sun's way through the day, but the scenario's bodies stand at "
        "fixed angles",
        "use <ephemeris/>, or give the weather as a file",
        {}}};
  }
  const Curve sun = sun_outside(*sky, input, files, diagnostics);
  const ClearAirLight air =
      std::visit(LightOfAir{scenario, input, sun, files, diagnostics}, scenario.air);
  const double from_s = -moment_step_s * std::ceil(history_s / moment_step_s);
  return at_element(input.where, [&] {
    // A day more on both sides, so that every sunrise and sunset is known.
    auto weather = thermal::clear_sky_weather(
        {input.air_low_k, input.air_high_k, input.dew_point_k, input.wind_m_s, air.pressure_hpa},
        air.light, sun_moments(scenario, from_s - whole_day_s, whole_day_s));
    for (auto series :
         {&thermal::Weather::air_temperature_k, &thermal::Weather::vapour_pressure_hpa,
          &thermal::Weather::pressure_hpa, &thermal::Weather::wind_speed_m_s,
          &thermal::Weather::direct_normal_w_m2, &thermal::Weather::diffuse_horizontal_w_m2,
          &thermal::Weather::sky_long_wave_w_m2}) {
      cut(weather.*series, from_s, 0.0);
    }
    if (!air.sky_follows_air) {
      auto& values = weather.sky_long_wave_w_m2.value;
      std::fill(values.begin(), values.end(), air.light.sky_long_wave_w_m2);
    }
    thermal::check(weather);
    return weather;
  });
}

}  // namespace nadir::sim
