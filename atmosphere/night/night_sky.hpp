#pragma once

#include "spectral/curve.hpp"

namespace nadir::atmosphere {

/// Light of the moonless night from outside the lower air, and a town's glow: spectral radiance in
/// the zenith, W m^-2 sr^-1 um^-1.
struct NightSky {
  spectral::Curve airglow;     ///< brightens towards the horizon, see van_rhijn
  spectral::Curve starlight;   ///< stars and zodiacal light: even
  spectral::Curve urban_glow;  ///< scattered from a town's lamps, as seen in the zenith from the
                               ///< ground; see urban_glow_shape
};

/// Brightness of a thin shell of light at height h over that in the zenith:
///     1 / sqrt(1 - (R / (R + h))^2 sin^2 z),  (R / (R + h))^2 = 0.96, that of a shell 130 km up
/// 0.96 is the value in use for the whole airglow; 0.97 is that of the OH layer, 90 km up. It is 5
/// at the horizon.
/// @param cos_zenith  cosine of the zenith angle at the ground, 0 to 1
/// Source: van Rhijn, Publ. Astron. Lab. Groningen 31, 1 (1921); 0.96: Krisciunas & Schaefer, PASP
/// 103, 1033 (1991), eq. 3.
[[nodiscard]] double van_rhijn(double cos_zenith) noexcept;

/// How much brighter a town's glow is at a zenith angle than in the zenith. Inside an evenly lit
/// region much wider than the air is high, lamps light all of the air alike, so that its source
/// function is constant and
///     L(z) / L(0) = (1 - exp(-t / cos z)) / (1 - exp(-t)),  t = 0.4,
/// the optical depth of clear air with rural haze of 23 km visibility at 0.55 um (0.42). 1.7 at 60
/// degrees, 3.0 at the horizon. Even in azimuth: a town beside the scene is not this.
/// @param cos_zenith  0 to 1; smaller ones count as the horizon
/// Source: Chandrasekhar, "Radiative Transfer" (1950), section 7, for a constant source function.
[[nodiscard]] double urban_glow_shape(double cos_zenith) noexcept;

}  // namespace nadir::atmosphere
