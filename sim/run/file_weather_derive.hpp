#pragma once

#include <vector>

#include "core/diagnostics.hpp"
#include "sim/files/weather_record.hpp"
#include "sim/run/file_weather_rows.hpp"
#include "sim/run/file_weather_sun.hpp"
#include "thermal/weather/sky_long_wave.hpp"
#include "thermal/weather/weather.hpp"

namespace nadir::sim {

/// A row turned into what a heat balance needs; NaN where the row does not say it.
struct WeatherMoment {
  const WeatherRow* row = nullptr;
  double time_s = 0.0;        ///< after the picture
  double light_from_s = 0.0;  ///< radiation is the mean from here to time_s, or of time_s
  thermal::WeatherState state;
};

/// How the sky's long-wave is made where the file does not have it.
struct SkyChoice {
  thermal::ClearSkyFormula formula = thermal::ClearSkyFormula::brutsaert;
  const thermal::Weather* clear = nullptr;  ///< if not null: emissivity of its sky instead
};

/// Where and when the rows are seen from.
struct WeatherView {
  double moment_utc_s = 0.0;
  double height_m = 0.0;  ///< of the site, where the station's is not known
  const SunHeights* sun = nullptr;
  SkyChoice sky;
};

/// Of the row's vapour pressure, dew point or relative humidity, the first that is there; NaN where
/// there is none.
[[nodiscard]] double vapour_pressure_hpa(const WeatherRow& row);

/// Humidity as vapour pressure, at most saturated; sunlight as direct and diffuse, long-wave and
/// pressure made where missing. Tells of a sky taken for clear because the file has no clouds.
[[nodiscard]] std::vector<WeatherMoment> derive(const WeatherRecord& record,
                                                const std::vector<WeatherRow>& rows,
                                                const WeatherView& view, Diagnostics& diagnostics);

/// The moments as series over time that reach over all of `needed`: where the file covers its ends
/// by its intervals alone, the first and the last value hold. Values missing for up to three hours
/// are bridged and told.
/// @param heat_step_s  rows closer than this are averaged over it
/// @throws InputError where something is missing altogether or for longer within `needed`
[[nodiscard]] thermal::Weather weather_of(const WeatherRecord& record,
                                          const std::vector<WeatherMoment>& moments,
                                          const UtcSpan& needed, double heat_step_s,
                                          Diagnostics& diagnostics);

}  // namespace nadir::sim
