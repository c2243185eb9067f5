#include "sim/run/file_weather_check.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstddef>
#include <numbers>

#include "core/constants.hpp"
#include "sim/run/file_weather_derive.hpp"
#include "thermal/surface/humidity.hpp"

namespace nadir::sim {
namespace {

using Q = WeatherQuantity;

/// `, here and in 24 more rows,`.
std::string rows_text(std::size_t count) {
  return count == 1 ? std::string{} : fmt::format(", here and in {} more rows,", count - 1);
}

/// What the row says of its vapour.
std::string vapour_text(const WeatherRow& row) {
  if (!std::isnan(row[Q::vapour_pressure_hpa])) {
    return fmt::format("vapour pressure of {:.1f} hPa", row[Q::vapour_pressure_hpa]);
  }
  return fmt::format("dew point of {:.1f} C", row[Q::dew_point_k] - si::zero_celsius);
}

}  // namespace

void check_humidity(const WeatherRecord& record, const std::vector<WeatherRow>& rows) {
  constexpr double highest_percent = 110.0;
  const WeatherRow* first = nullptr;
  double first_percent = 0.0;
  std::size_t count = 0;
  for (const WeatherRow& row : rows) {
    const double air_k = row[Q::air_temperature_k];
    const double percent =
        100.0 * vapour_pressure_hpa(row) / thermal::saturation_over_water_hpa(air_k);
    if (!(percent > highest_percent)) continue;  // nor where either is missing
    if (count++ > 0) continue;
    first = &row;
    first_percent = percent;
  }
  if (first == nullptr) return;
  throw InputError{row_issue(
      record, *first,
      fmt::format("{} in air of {:.1f} C{} is a relative humidity of {:.0f} %: expected at most "
                  "{:.0f} %",
                  vapour_text(*first), (*first)[Q::air_temperature_k] - si::zero_celsius,
                  rows_text(count), first_percent, highest_percent))};
}

AirLimits air_limits(const ephemeris::Site& site, double utc_s) {
  constexpr double hottest_day = 195.0;  // 15 July, from 1 January 1970
  constexpr double days_a_year = 365.2425;
  constexpr double colder_k_m = 0.010;  // the adiabatic lapse is 9.8 K/km
  const double sine = std::sin(site.latitude_deg * std::numbers::pi / 180.0);
  const double season =
      sine * std::cos(2.0 * std::numbers::pi * (utc_s / 86400.0 - hottest_day) / days_a_year);
  const double to_the_pole = 0.5 * (3.0 * sine * sine - 1.0);  // the second Legendre polynomial
  return {-31.5 - 28.0 * to_the_pole + 25.5 * season - colder_k_m * std::fmax(0.0, site.height_m),
          57.0 - 28.0 * to_the_pole + 15.5 * season};
}

void check_air_temperature(const WeatherRecord& record, const std::vector<WeatherRow>& rows,
                           const ephemeris::Site& site, const UtcSpan& needed,
                           Diagnostics& diagnostics) {
  const WeatherRow* first = nullptr;
  std::size_t count = 0;
  for (const WeatherRow& row : rows) {
    if (row.utc_s < needed.from_s || row.utc_s > needed.to_s) continue;
    const double air_c = row[Q::air_temperature_k] - si::zero_celsius;
    const AirLimits limits = air_limits(site, row.utc_s);
    if (!(air_c < limits.lowest_c || air_c > limits.highest_c)) continue;
    if (count++ == 0) first = &row;
  }
  if (first == nullptr) return;
  const AirLimits limits = air_limits(site, first->utc_s);
  warn_at_row(record, *first,
              fmt::format("air of {:.1f} C{} at latitude {:.1f} at this time of the year: nothing "
                          "outside {:.0f} to {:.0f} C is known; is it the weather of another place "
                          "or season?",
                          (*first)[Q::air_temperature_k] - si::zero_celsius, rows_text(count),
                          site.latitude_deg, limits.lowest_c, limits.highest_c),
              diagnostics);
}

}  // namespace nadir::sim
