#pragma once

#include <vector>

#include "core/diagnostics.hpp"
#include "ephemeris/site.hpp"
#include "sim/files/weather_record.hpp"
#include "sim/run/file_weather_rows.hpp"

// Weather that cannot be, or hardly at the scene.

namespace nadir::sim {

/// Relative humidity over water above 110 %, by the row's temperature: sensors in fog, and dew
/// points rounded to a degree, come up to that.
/// @throws InputError at the first such row
void check_humidity(const WeatherRecord& record, const std::vector<WeatherRow>& rows);

/// Degrees Celsius.
struct AirLimits {
  double lowest_c = 0.0, highest_c = 0.0;
};
/// What air near the ground is never seen to leave at a latitude and time of the year, with some
/// degrees to spare; docs/weather.md has the formula and the records that it holds.
[[nodiscard]] AirLimits air_limits(const ephemeris::Site& site, double utc_s);

/// Tells of air outside those limits within `needed`: of another season, place or unit.
void check_air_temperature(const WeatherRecord& record, const std::vector<WeatherRow>& rows,
                           const ephemeris::Site& site, const UtcSpan& needed,
                           Diagnostics& diagnostics);

}  // namespace nadir::sim
