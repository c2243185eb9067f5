#pragma once

#include "core/quantity.hpp"
#include "spectral/lanes.hpp"

namespace nadir::spectral {

// All of these are pure and thread-safe, and give NaN outside the stated domain. Their rounding
// errors grow with the exponent x = c2 / (lambda T); the bounds below hold for 0.2 .. 20 um and
// 3 .. 6000 K, wherever the result is above 1e-290, and are tested against long double.

/// Spectral radiance of a black body in vacuum, per unit wavelength.
///
///     B(lambda, T) = c1 / (lambda^5 (exp(c2 / (lambda T)) - 1)),  c1 = 2 h c^2,  c2 = h c / k
///
/// @param wavelength   vacuum wavelength, > 0                        [um]
/// @param temperature  thermodynamic temperature, >= 0; 0 K gives 0   [K]
/// @return             spectral radiance; 0 where exp overflows       [W m^-2 sr^-1 um^-1]
///
/// Accuracy: relative error below 1e-15 + 4e-16 x.
/// Source: SI Brochure, 9th ed. (2019), exact h, c, k.
[[nodiscard]] SpectralRadiance planck(Micrometres wavelength, Kelvin temperature) noexcept;

/// Planck radiance at every lane, rounded to float; 0 below the smallest normal float, 1.2e-38.
[[nodiscard]] Spectrum planck(const Lanes& lanes, Kelvin temperature) noexcept;

/// dB/dT in W m^-2 sr^-1 um^-1 K^-1; 0 at 0 K. Accuracy as of `planck`.
[[nodiscard]] double planck_derivative(Micrometres wavelength, Kelvin temperature) noexcept;

/// Radiance of a black body between two wavelengths, 0 <= lo <= hi (hi may be infinite).
/// Accuracy: relative error below 4e-15 + 4e-16 x, x at `hi`, however narrow the band.
[[nodiscard]] Radiance planck_band(Micrometres lo, Micrometres hi, Kelvin temperature) noexcept;

/// Brightness temperature: the T for which B(wavelength, T) is the given radiance; 0 K for
/// radiance 0, NaN for negative radiance. Accuracy: relative error below 1e-15.
[[nodiscard]] Kelvin brightness_temperature(Micrometres wavelength,
                                            SpectralRadiance radiance) noexcept;

}  // namespace nadir::spectral
