#include "ephemeris/refraction.hpp"

#include <algorithm>
#include <cmath>

namespace nadir::ephemeris {

Angle refraction(Angle elevation, const AirAtSite& air) noexcept {
  constexpr double full_above_deg = -1.0, zero_below_deg = -2.0;
  const double h_deg = to_degrees(elevation);
  if (h_deg <= zero_below_deg) return Angle{0.0};
  const double formula_deg = std::max(h_deg, full_above_deg);
  const double argument = degrees(formula_deg + 10.3 / (formula_deg + 5.11)).value;
  // Meeus' constant 0.0019279' cancels the -0.0019279' that the formula gives in the zenith.
  const double arcminutes = std::max(0.0, 1.02 / std::tan(argument) + 0.0019279);
  const double density = air.pressure_hpa / 1010.0 * 283.0 / (273.0 + air.temperature_c);
  const double fade = std::min(1.0, (h_deg - zero_below_deg) / (full_above_deg - zero_below_deg));
  return degrees(arcminutes / 60.0 * density * fade);
}

}  // namespace nadir::ephemeris
