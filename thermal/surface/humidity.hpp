#pragma once

namespace nadir::thermal {

// Water vapour over plane surfaces by Magnus' formula with the coefficients that the World
// Meteorological Organization recommends (Guide to Instruments and Methods of Observation, WMO-No.
// 8, annex 4.B; after Sonntag, Z. Meteorol. 70, 340, 1990):
//
//     e(T) = 6.112 hPa exp(a t / (b + t)),  t = T - 273.15 K
//     a = 17.62, b = 243.12 K over water;  a = 22.46, b = 272.62 K over ice
//
// One exponential, and its inverse is as short: a heat balance asks for it at every iteration.
// Differs from Murphy & Koop (2005, doi:10.1256/qj.04.94) by less than 0.6 % from 233 to 333 K over
// water and by less than 0.05 % from 223 to 273 K over ice. The air's enhancement factor (0.4 %) is
// left out.

/// A vapour pressure and how it grows with temperature.
struct SaturationPressure {
  double hpa = 0.0;
  double per_k = 0.0;  ///< derivative, hPa K^-1
};

/// Over liquid water, also below freezing; 0 below 73 K, where the formula ends, and held above
/// 373.15 K at its value there, 1038 hPa: hotter water boils, and what leaves it is no longer a
/// matter of vapour pressure.
[[nodiscard]] double saturation_over_water_hpa(double temperature_k) noexcept;
/// Over a wet surface: over ice below 273.15 K, over water above. Same limits; rises everywhere or
/// stands still.
[[nodiscard]] SaturationPressure saturation_at_surface(double temperature_k) noexcept;

/// Vapour pressure of air. Weather services count relative humidity and dew points over water at
/// all temperatures.
/// @param relative_humidity  0 to 1
[[nodiscard]] double vapour_pressure_of_humidity_hpa(double air_k,
                                                     double relative_humidity) noexcept;
[[nodiscard]] double vapour_pressure_of_dew_point_hpa(double dew_point_k) noexcept;
/// The temperature at which air with this vapour is saturated over water.
/// @param vapour_pressure_hpa  > 0, up to 1038
[[nodiscard]] double dew_point_k(double vapour_pressure_hpa) noexcept;

/// gamma = cp p / (0.622 L) = 0.000665 K^-1 p, hPa K^-1: what vapour pressure a kelvin of air is
/// worth (FAO Irrigation and Drainage Paper 56, eq. 8; L of water at 20 degrees Celsius).
[[nodiscard]] constexpr double psychrometric_constant_hpa_k(double pressure_hpa) noexcept {
  return 0.000665 * pressure_hpa;
}

}  // namespace nadir::thermal
