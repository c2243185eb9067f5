#include "ephemeris/refraction.hpp"

#include <algorithm>
#include <cmath>

namespace nadir::ephemeris {

Angle refraction_at_apparent(Angle apparent_elevation, const AirAtSite& air) noexcept {
  const double h = to_degrees(apparent_elevation);
  const double argument = degrees(h + 4.2206 / (h + 15.1115 / (h + 5.9431))).value;
  // In the zenith the argument is a hair over 90 degrees.
  constexpr double amplitude_arcsec = 1.00253 * 3600.0 / 62.8093;
  const double standard_arcsec = std::max(0.0, amplitude_arcsec / std::tan(argument));
  const double e = 1.0 / (1.47 + h * (0.55 + h * 0.172));
  const double pressure = std::pow(air.pressure_hpa / 1013.25, 1.0 + 0.095 * e);
  const double temperature = std::pow(288.15 / (273.15 + air.temperature_c), 1.0 + e);
  return degrees(standard_arcsec / 3600.0 * pressure * temperature);
}

Angle refraction(Angle elevation, const AirAtSite& air) noexcept {
  const Angle full_above = degrees(-1.0), zero_below = degrees(-2.0);
  if (elevation <= zero_below) return Angle{0.0};
  const Angle start = std::max(elevation, full_above);
  // R falls by at most 0.4 of a step in apparent elevation (cold air, the horizon): 20 rounds leave
  // 1e-8 of it.
  Angle lift{0.0};
  for (int round = 0; round < 20; ++round) lift = refraction_at_apparent(start + lift, air);
  return lift * std::min(1.0, (elevation - zero_below) / (full_above - zero_below));
}

}  // namespace nadir::ephemeris
