#include "sim/run/file_weather_derive.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/constants.hpp"
#include "thermal/surface/humidity.hpp"
#include "thermal/weather/split_sunlight.hpp"

namespace nadir::sim {
namespace {

using Q = WeatherQuantity;

bool is_known(double value) { return !std::isnan(value); }

/// A little above saturation, as sensors in fog and rounded dew points show, is saturated air.
double vapour_in_air_hpa(const WeatherRow& row) {
  const double vapour = vapour_pressure_hpa(row), air_k = row[Q::air_temperature_k];
  return is_known(air_k) ? std::min(vapour, thermal::saturation_over_water_hpa(air_k)) : vapour;
}

/// International standard atmosphere (ISO 2533), below 11 km.
double standard_pressure_hpa(double height_m) {
  return 1013.25 * std::pow(1.0 - 2.25577e-5 * height_m, 5.25588);
}

/// Direct and diffuse sunlight from whatever two of three quantities, or the whole alone.
thermal::SplitSunlight sunlight(const WeatherRow& row, const thermal::SunOverStation& sun) {
  // Below 3 degrees a quotient by the cosine says nothing; split_sunlight has the same limit.
  constexpr double lowest_cosine = 0.052;
  const double global = row[Q::global_horizontal_w_m2], direct = row[Q::direct_normal_w_m2],
               diffuse = row[Q::diffuse_horizontal_w_m2];
  if (is_known(direct) && is_known(diffuse)) return {direct, diffuse};
  if (is_known(global) && is_known(diffuse)) {
    const double beam = (global - diffuse) / std::max(sun.cos_zenith, lowest_cosine);
    const bool low = sun.cos_zenith < lowest_cosine;
    if (low || beam > sun.extraterrestrial_w_m2) return {0.0, std::max(global, diffuse)};
    return {std::max(0.0, beam), diffuse};
  }
  if (is_known(global) && is_known(direct)) {
    return {direct, std::max(0.0, global - direct * std::max(0.0, sun.cos_zenith))};
  }
  if (is_known(global)) return thermal::split_sunlight(global, sun);
  return {no_weather_value, no_weather_value};
}

/// E = eps sigma T^4 with clouds counted; a sky that the file does not describe is clear.
double made_long_wave_w_m2(const WeatherMoment& moment, const SkyChoice& sky) {
  if (!is_known(moment.state.air_temperature_k) || !is_known(moment.state.vapour_pressure_hpa)) {
    return no_weather_value;
  }
  const double cloud = (*moment.row)[Q::cloud_fraction];
  const thermal::StationAir air{moment.state.air_temperature_k, moment.state.vapour_pressure_hpa,
                                is_known(cloud) ? cloud : 0.0};
  if (sky.clear == nullptr) {
    return thermal::sky_long_wave_w_m2({sky.formula, thermal::CloudFormula::unsworth_monteith},
                                       air);
  }
  const auto black = [](double t) { return si::stefan_boltzmann * t * t * t * t; };
  const thermal::WeatherState clear = sky.clear->at(moment.time_s);
  const double emissivity = clear.sky_long_wave_w_m2 / black(clear.air_temperature_k);
  // Unsworth & Monteith (1975), as in thermal/weather/sky_long_wave.hpp.
  const double whole = (1.0 - 0.84 * air.cloud_fraction) * emissivity + 0.84 * air.cloud_fraction;
  return whole * black(air.temperature_k);
}

/// Tells where the sky's long-wave is not the file's own.
void tell_of_sky(const WeatherRecord& record, const std::vector<WeatherRow>& rows,
                 Diagnostics& diagnostics) {
  std::size_t without_sky = 0, without_clouds = 0;
  for (const WeatherRow& row : rows) {
    if (is_known(row[Q::sky_long_wave_w_m2])) continue;
    ++without_sky;
    if (!is_known(row[Q::cloud_fraction])) ++without_clouds;
  }
  const std::string file = record.files.front().string() + ": ";
  if (without_sky > 0 && without_sky < rows.size()) {
    diagnostics.warn(file + fmt::format("{} of {} rows have no long-wave radiation of the sky: a "
                                        "formula gives theirs",
                                        without_sky, rows.size()));
  }
  if (without_clouds > 0) {
    diagnostics.warn(file + fmt::format("{} of {} rows have neither long-wave radiation of the sky "
                                        "nor clouds: the sky is taken for clear",
                                        without_clouds, rows.size()));
  }
}

class Deriver {
 public:
  Deriver(const WeatherRecord& record, const WeatherView& view)
      : record_{record},
        view_{view},
        pressure_hpa_{standard_pressure_hpa(record.station.height_m.value_or(view.height_m))} {}

  [[nodiscard]] WeatherMoment derive(const WeatherRow& row, double previous_s) const {
    WeatherMoment moment{&row, row.utc_s - view_.moment_utc_s, 0.0, {}};
    moment.light_from_s = std::max(moment.time_s - record_.radiation_mean_s, previous_s);
    const thermal::SplitSunlight light = sunlight(row, sun_over(moment));
    const double pressure = row[Q::pressure_hpa];
    thermal::WeatherState& state = moment.state;
    state = {row[Q::air_temperature_k],
             vapour_in_air_hpa(row),
             is_known(pressure) ? pressure : pressure_hpa_,
             row[Q::wind_speed_m_s],
             light.direct_normal_w_m2,
             light.diffuse_horizontal_w_m2,
             row[Q::sky_long_wave_w_m2]};
    if (!is_known(state.sky_long_wave_w_m2)) {
      const double made = made_long_wave_w_m2(moment, view_.sky);
      // Brutsaert's sky goes out in air without any vapour.
      state.sky_long_wave_w_m2 = is_known(made) ? std::max(made, 1.0) : made;
    }
    return moment;
  }

 private:
  [[nodiscard]] thermal::SunOverStation sun_over(const WeatherMoment& moment) const {
    const SunHeights& sun = *view_.sun;
    const double cosine = moment.light_from_s < moment.time_s
                              ? sun.mean_cos_zenith(moment.light_from_s, moment.time_s)
                              : sun.cos_zenith(moment.time_s);
    return {cosine, sun.extraterrestrial_w_m2(moment.time_s)};
  }

  const WeatherRecord& record_;
  const WeatherView& view_;
  double pressure_hpa_;
};

}  // namespace

double vapour_pressure_hpa(const WeatherRow& row) {
  if (is_known(row[Q::vapour_pressure_hpa])) return row[Q::vapour_pressure_hpa];
  if (is_known(row[Q::dew_point_k])) {
    return thermal::vapour_pressure_of_dew_point_hpa(row[Q::dew_point_k]);
  }
  // NaN where either is missing.
  return thermal::vapour_pressure_of_humidity_hpa(row[Q::air_temperature_k],
                                                  0.01 * row[Q::relative_humidity_percent]);
}

std::vector<WeatherMoment> derive(const WeatherRecord& record, const std::vector<WeatherRow>& rows,
                                  const WeatherView& view, Diagnostics& diagnostics) {
  tell_of_sky(record, rows, diagnostics);
  const Deriver deriver{record, view};
  std::vector<WeatherMoment> moments;
  double previous_s = -1e300;
  for (const WeatherRow& row : rows) {
    moments.push_back(deriver.derive(row, previous_s));
    previous_s = moments.back().time_s;
  }
  return moments;
}

}  // namespace nadir::sim
