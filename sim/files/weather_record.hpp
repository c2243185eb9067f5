#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <vector>

// What a file of weather says, as plain data: every reader of such a file ends here.

namespace nadir::sim {

enum class WeatherQuantity {
  air_temperature_k,
  dew_point_k,
  relative_humidity_percent,
  vapour_pressure_hpa,
  pressure_hpa,
  wind_speed_m_s,
  direct_normal_w_m2,
  diffuse_horizontal_w_m2,
  global_horizontal_w_m2,
  sky_long_wave_w_m2,
  cloud_fraction
};
inline constexpr std::size_t weather_quantities = 11;
inline constexpr double no_weather_value = std::numeric_limits<double>::quiet_NaN();

/// Where the weather was measured, as far as the file says.
struct WeatherStation {
  std::string name;
  std::optional<double> latitude_deg, longitude_deg, height_m;
};

/// What was measured at one time. Radiation may be the mean of the time before.
struct WeatherRow {
  std::size_t file = 0;  ///< index into WeatherRecord::files
  int line = 0;
  double utc_s = 0.0;  ///< since 1970-01-01T00:00Z, all days of 86,400 s
  std::array<double, weather_quantities> values = all_missing();  ///< NaN: missing

  [[nodiscard]] double operator[](WeatherQuantity q) const {
    return values[static_cast<std::size_t>(q)];
  }
  [[nodiscard]] double& operator[](WeatherQuantity q) {
    return values[static_cast<std::size_t>(q)];
  }

 private:
  static std::array<double, weather_quantities> all_missing() {
    std::array<double, weather_quantities> none{};
    none.fill(no_weather_value);
    return none;
  }
};

struct WeatherRecord {
  std::vector<std::filesystem::path> files;  ///< the first is the one that was asked for
  WeatherStation station;
  double utc_offset_s = 0.0;      ///< of the clock that the file goes by
  double radiation_mean_s = 0.0;  ///< radiation is the mean of so long before the time; 0: of it
  bool typical_year = false;      ///< put together from several years: the year means nothing
  std::vector<WeatherRow> rows;   ///< ascending; of a typical year, with its year left out
};

}  // namespace nadir::sim
