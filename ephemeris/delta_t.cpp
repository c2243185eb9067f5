#include "ephemeris/delta_t.hpp"

#include <limits>

namespace nadir::ephemeris {

Seconds delta_t(double year) noexcept {
  if (year >= 1900.0 && year < 1920.0) {
    const double t = year - 1900.0;
    return Seconds{-2.79 + t * (1.494119 + t * (-0.0598939 + t * (0.0061966 + t * -0.000197)))};
  }
  if (year >= 1920.0 && year < 1941.0) {
    const double t = year - 1920.0;
    return Seconds{21.20 + t * (0.84493 + t * (-0.076100 + t * 0.0020936))};
  }
  if (year >= 1941.0 && year < 1961.0) {
    const double t = year - 1950.0;
    return Seconds{29.07 + t * (0.407 + t * (-1.0 / 233.0 + t / 2547.0))};
  }
  return Seconds{std::numeric_limits<double>::quiet_NaN()};
}

}  // namespace nadir::ephemeris
