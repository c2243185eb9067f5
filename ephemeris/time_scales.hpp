#pragma once

namespace nadir::ephemeris {

/// A date in one time scale as ERFA keeps it: the sum of the parts is the Julian date. `day` is
/// that of a midnight (it ends in .5), `fraction` the part of the day: together good to 1e-11 s.
/// Dates of different scales are different types, so that none stands in for another unnoticed.
template <class Scale>
struct JulianDate {
  double day = 0.0;
  double fraction = 0.0;

  [[nodiscard]] constexpr double value() const { return day + fraction; }
};

/// Coordinated universal time. A day that ends in a leap second counts as one day (the
/// quasi-Julian date of ERFA).
using UtcDate = JulianDate<struct UtcTag>;
using TaiDate = JulianDate<struct TaiTag>;  ///< international atomic time
using TtDate = JulianDate<struct TtTag>;    ///< terrestrial time, TAI + 32.184 s
using Ut1Date = JulianDate<struct Ut1Tag>;  ///< the rotation of the earth

}  // namespace nadir::ephemeris
