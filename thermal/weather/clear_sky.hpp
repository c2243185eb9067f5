#pragma once

#include <vector>

#include "thermal/weather/weather.hpp"

namespace nadir::thermal {

/// A clear day's air at the ground: what a stated diurnal cycle needs.
struct DayOfAir {
  double low_k = 288.15;   ///< at sunrise
  double high_k = 300.15;  ///< in the afternoon
  double dew_point_k = 285.15;
  double wind_m_s = 2.0;
  double pressure_hpa = 1013.25;
};

/// Light of a clear sky on level ground by the sun's height, from a model of the air.
struct ClearSkyLight {
  std::vector<double> cos_zenith;               ///< ascending, from the horizon (0) up to 1
  std::vector<double> direct_normal_w_m2;       ///< at 1 au
  std::vector<double> diffuse_horizontal_w_m2;  ///< at 1 au
  double sky_long_wave_w_m2 = 300.0;            ///< with the air at `profile_k` near the ground
  double profile_k = 288.15;
};

/// Where the sun stood.
struct SunMoment {
  double time_s = 0.0;
  double cos_zenith = 0.0;
  double distance_au = 1.0;
};

/// Weather made of a clear sky's light and a day's air: sine from sunrise to the afternoon's high
/// and on to sunset, then an exponential fall to the next sunrise (Parton & Logan, Agric. Meteorol.
/// 23, 205, 1981). Long-wave radiation of the sky follows the air's temperature to the fourth
/// power.
/// @param sun  ascending times, dense enough (10 min) that sunrise and sunset lie between two
[[nodiscard]] Weather clear_sky_weather(const DayOfAir& day, const ClearSkyLight& light,
                                        const std::vector<SunMoment>& sun);

}  // namespace nadir::thermal
