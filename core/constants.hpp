#pragma once

#include <numbers>

namespace nadir::si {

// Exact by definition: SI Brochure, 9th edition (2019), sections 2.2 and 2.3.
inline constexpr double speed_of_light = 299'792'458.0;  ///< c, m s^-1
inline constexpr double planck = 6.626'070'15e-34;       ///< h, J s
inline constexpr double boltzmann = 1.380'649e-23;       ///< k, J K^-1
inline constexpr double zero_celsius = 273.15;           ///< 0 degrees Celsius, K

/// First radiation constant for radiance, 2 h c^2, in W m^-2 sr^-1 um^4: divided by a wavelength
/// in um to the fifth power it is per um. W m^2 sr^-1 = 1e24 W m^-2 sr^-1 um^4.
inline constexpr double radiation_c1 = 2.0 * planck * speed_of_light * speed_of_light * 1e24;

/// Second radiation constant, h c / k, in um K.
inline constexpr double radiation_c2 = planck * speed_of_light / boltzmann * 1e6;

/// Stefan-Boltzmann constant, 2 pi^5 k^4 / (15 h^3 c^2), in W m^-2 K^-4.
inline constexpr double stefan_boltzmann =
    2.0 * std::numbers::pi * std::numbers::pi * std::numbers::pi * std::numbers::pi *
    std::numbers::pi * boltzmann * boltzmann * boltzmann * boltzmann /
    (15.0 * planck * planck * planck * speed_of_light * speed_of_light);

}  // namespace nadir::si

namespace nadir::astro {

/// IAU 2012 Resolution B2, exact.
inline constexpr double astronomical_unit_m = 149'597'870'700.0;
/// Nominal solar radius, IAU 2015 Resolution B3.
inline constexpr double solar_radius_m = 695'700'000.0;
/// Mean lunar radius, IAU WGCCRE 2015 (Archinal et al. 2018, doi:10.1007/s10569-017-9805-5).
inline constexpr double lunar_radius_m = 1'737'400.0;

}  // namespace nadir::astro
