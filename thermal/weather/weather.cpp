#include "thermal/weather/weather.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <utility>

#include "core/error.hpp"
#include "core/text.hpp"

namespace nadir::thermal {
namespace {

/// A quantity of the weather and what it can be on earth.
struct Bounds {
  const char* name;
  const char* unit;
  TimeSeries Weather::*series;
  double least, most;
};

// Beyond the records of the WMO's archive of extremes (air 184 to 330 K, wind 113 m/s), wide enough
// for any station. Vapour: saturation at 350 K, 416.8 hPa (IAPWS-95). Sunlight: the solar constant,
// 1361 W m^-2, and what clouds add for minutes.
constexpr std::array<Bounds, 7> all_bounds{{
    {"air temperature", "K", &Weather::air_temperature_k, 150.0, 350.0},
    {"vapour pressure", "hPa", &Weather::vapour_pressure_hpa, 0.0, 416.8},
    {"air pressure", "hPa", &Weather::pressure_hpa, 200.0, 1200.0},
    {"wind speed", "m/s", &Weather::wind_speed_m_s, 0.0, 120.0},
    {"direct sunlight", "W/m2", &Weather::direct_normal_w_m2, 0.0, 1500.0},
    {"diffuse sunlight", "W/m2", &Weather::diffuse_horizontal_w_m2, 0.0, 1000.0},
    {"long-wave radiation of the sky", "W/m2", &Weather::sky_long_wave_w_m2, 1.0, 800.0},
}};

std::string weather_quantity(const Bounds& bounds) {
  return std::string{"weather: "} + bounds.name;
}

/// What is wrong with the series as such.
std::optional<std::string> wrong_times(const TimeSeries& series) {
  if (series.time_s.empty()) return " has no values";
  if (series.time_s.size() != series.value.size())
    return " has " + std::to_string(series.time_s.size()) + " times, but " +
           std::to_string(series.value.size()) + " values";
  for (std::size_t i = 0; i < series.time_s.size(); ++i) {
    if (!std::isfinite(series.time_s[i]))
      return ": time " + std::to_string(i + 1) + " is not a finite number";
    if (i > 0 && !(series.time_s[i] > series.time_s[i - 1]))
      return ": the time " + number_text(series.time_s[i]) + " s follows " +
             number_text(series.time_s[i - 1]) + " s, expected ascending times";
  }
  return std::nullopt;
}

/// The first value out of range.
std::optional<std::string> wrong_value(const TimeSeries& series, const Bounds& bounds) {
  for (std::size_t i = 0; i < series.value.size(); ++i) {
    const double value = series.value[i];
    if (value >= bounds.least && value <= bounds.most) continue;  // a NaN does not
    const std::string unit = std::string{" "} + bounds.unit;
    return " is " + number_text(value) + unit + " at " + number_text(series.time_s[i]) +
           " s from the picture, allowed range is [" + number_text(bounds.least) + ", " +
           number_text(bounds.most) + "]" + unit;
  }
  return std::nullopt;
}

}  // namespace

double TimeSeries::at(double moment_s) const noexcept {
  assert(!time_s.empty() && time_s.size() == value.size());
  const auto after = std::upper_bound(time_s.begin(), time_s.end(), moment_s);
  if (after == time_s.begin()) return value.front();
  if (after == time_s.end()) return value.back();
  const auto i = static_cast<std::size_t>(after - time_s.begin());
  const double share = (moment_s - time_s[i - 1]) / (time_s[i] - time_s[i - 1]);
  return value[i - 1] + share * (value[i] - value[i - 1]);
}

WeatherState Weather::at(double time_s) const noexcept {
  return {.air_temperature_k = air_temperature_k.at(time_s),
          .vapour_pressure_hpa = vapour_pressure_hpa.at(time_s),
          .pressure_hpa = pressure_hpa.at(time_s),
          .wind_speed_m_s = wind_speed_m_s.at(time_s),
          .direct_normal_w_m2 = direct_normal_w_m2.at(time_s),
          .diffuse_horizontal_w_m2 = diffuse_horizontal_w_m2.at(time_s),
          .sky_long_wave_w_m2 = sky_long_wave_w_m2.at(time_s)};
}

double Weather::first_s() const noexcept {
  double latest = -std::numeric_limits<double>::infinity();
  for (const Bounds& bounds : all_bounds) {
    const TimeSeries& series = this->*bounds.series;
    if (series.time_s.size() > 1) latest = std::max(latest, series.time_s.front());
  }
  return latest;
}

double Weather::last_s() const noexcept {
  double earliest = std::numeric_limits<double>::infinity();
  for (const Bounds& bounds : all_bounds) {
    const TimeSeries& series = this->*bounds.series;
    if (series.time_s.size() > 1) earliest = std::min(earliest, series.time_s.back());
  }
  return earliest;
}

void check(const Weather& weather) {
  std::vector<InputIssue> issues;
  for (const Bounds& bounds : all_bounds) {
    const TimeSeries& series = weather.*bounds.series;
    std::optional<std::string> wrong = wrong_times(series);
    if (!wrong) wrong = wrong_value(series, bounds);
    if (!wrong) continue;
    InputIssue issue;
    issue.message = weather_quantity(bounds) + *wrong;
    issues.push_back(std::move(issue));
  }
  if (!issues.empty()) throw InputError(std::move(issues));
}

}  // namespace nadir::thermal
