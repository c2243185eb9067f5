#pragma once

#include "core/quantity.hpp"

namespace nadir::ephemeris {

/// Delta T = TT - UT1 from the polynomials of Espenak and Meeus, for the years before UTC.
///
/// @param year  decimal year, 1900 <= year < 1961
/// @return      seconds; NaN outside these years
///
/// Accuracy: about 0.5 s against the tabulated values of the same source (0.3 arcsec of the moon).
/// Source: F. Espenak, J. Meeus, Five Millennium Canon of Solar Eclipses, NASA/TP-2006-214141,
/// section 2.6. They step y by the month; here it runs on.
[[nodiscard]] Seconds delta_t(double year) noexcept;

}  // namespace nadir::ephemeris
