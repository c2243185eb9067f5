#pragma once

#include <vector>

namespace nadir::thermal {

// Times of the heat balance are seconds after the moment of the picture: negative before it.

/// A quantity given at some times; between them it runs linearly.
struct TimeSeries {
  std::vector<double> time_s;  ///< strictly ascending; at least one
  std::vector<double> value;   ///< as many

  /// Outside its times the series keeps its first and last value.
  [[nodiscard]] double at(double moment_s) const noexcept;
};

/// What the air about a surface does at one moment.
struct WeatherState {
  double air_temperature_k = 288.15;
  double vapour_pressure_hpa = 10.0;     ///< of water, partial
  double pressure_hpa = 1013.25;         ///< of the air
  double wind_speed_m_s = 0.0;           ///< at the height of the station
  double direct_normal_w_m2 = 0.0;       ///< of the sun on a plane normal to its direction
  double diffuse_horizontal_w_m2 = 0.0;  ///< of the sky on a level plane, sunlight only
  double sky_long_wave_w_m2 = 300.0;     ///< emitted by the sky, on a level plane
};

/// The weather through the hours that matter for a picture.
struct Weather {
  TimeSeries air_temperature_k;
  TimeSeries vapour_pressure_hpa;
  TimeSeries pressure_hpa;
  TimeSeries wind_speed_m_s;
  TimeSeries direct_normal_w_m2;
  TimeSeries diffuse_horizontal_w_m2;
  TimeSeries sky_long_wave_w_m2;

  [[nodiscard]] WeatherState at(double time_s) const noexcept;
  /// The span that all series cover: infinite where they have one value each. A series of a single
  /// value covers all times.
  [[nodiscard]] double first_s() const noexcept;
  [[nodiscard]] double last_s() const noexcept;
};

/// Ascending times, as many values as times, all finite and within what the earth's weather can be:
/// air 150 to 350 K, wind 0 to 120 m/s, pressure 200 to 1200 hPa, vapour 0 to saturation at 350 K,
/// direct 0 to 1500 W m^-2, diffuse 0 to 1000, long-wave 1 to 800.
/// @throws InputError that names the quantity and the time
void check(const Weather& weather);

}  // namespace nadir::thermal
