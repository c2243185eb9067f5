#pragma once

namespace nadir::atmosphere {

/// How far along a path something lies, in a measure that follows the air: metres of air as dense
/// as at sea level, for air that falls off with H = 8 km,
///
///     m = int exp(-w / H) ds,   w = (r^2 - R^2) / (2 R) = z (1 + z / 2 R)
///
/// along the straight line between two heights z that are `length_m` apart (these three fix the
/// line: the earth's radius is R). w is a quadratic in the way s, so that the integral has a closed
/// form, grows with every step along any line and adds up over pieces of a line. Tables over a path
/// run over the share m / m(whole way). Both who fills a table and who looks it up use this very
/// function.
///
/// @param length_m  >= |height_to_m - height_from_m|; 0 gives 0
/// @return          m, >= 0; alike for both directions of travel
/// Accuracy: relative 3e-12 of the integral (tested by quadrature).
inline constexpr double measure_scale_m = 8000.0;
[[nodiscard]] double air_measure_m(double height_from_m, double height_to_m,
                                   double length_m) noexcept;

}  // namespace nadir::atmosphere
