#pragma once

#include "core/quantity.hpp"
#include "ephemeris/sun_moon.hpp"

namespace nadir::ephemeris {

/// Two discs in the sky.
struct DiscPair {
  Angle radius;      ///< of the disc that is covered
  Angle cover;       ///< radius of the disc in front of it
  Angle separation;  ///< of the centres
};

/// How much of a disc another one leaves free: of its area, and of its area weighted by the cosine
/// of the emission angle, sqrt(1 - r^2), 1 in the middle and 0 at the limb.
struct VisibleShare {
  double area = 1.0;
  double by_cosine = 1.0;
};

/// Error below 1e-9 (closed form) and 1e-6 (midpoint rule, 64 points).
[[nodiscard]] VisibleShare visible_share(const DiscPair& discs) noexcept;

/// How much of the sun's limb is missing: brightness 1 - u (1 - mu) over the disc, mu the cosine of
/// the emission angle.
///
///     u = beta / (1 + beta),  beta = 3 h c 2^(1/4) / (8 k lambda T),  T = 5740 K
///
/// Source: P. Koepke, J. Reuder, J. Schween, Spectral variation of the solar radiation during an
/// eclipse, Meteorol. Z. 10, 179 (2001), after Waldmeier (1941): a grey atmosphere.
/// @return  0 (far infrared) to 1 (far ultraviolet)
[[nodiscard]] double limb_darkening(Micrometres wavelength) noexcept;

/// An eclipse as what it leaves of a body's irradiance.
struct Eclipse {
  VisibleShare sunlight;   ///< of the sun's disc; for the moon, the mean over its disc
  double in_umbra = 0.0;   ///< share of the moon's disc; 0 for the sun
  double magnitude = 0.0;  ///< share of the diameter covered; of the moon's in the umbra. 0: none

  /// 1 - share of the irradiance taken away. 0 in the sun's totality.
  [[nodiscard]] double factor(Micrometres wavelength) const noexcept;
  [[nodiscard]] bool any() const noexcept { return sunlight.area < 1.0; }
};

/// The moon before the sun, as seen from the site; both discs without refraction and without the
/// profile of the lunar limb.
/// Accuracy: the moon's place, 10 arcsec: 0.005 of the magnitude.
[[nodiscard]] Eclipse solar_eclipse(const SunAndMoon& seen) noexcept;

/// The moon in the earth's shadow, the mean over its disc (taken as evenly bright, as near full
/// moon it is).
///
/// The shadow is that of the earth with Danjon's enlargement, 1.01 times its mean radius of
/// 0.99834 (F. Espenak, J. Meeus, Five Millennium Canon of Lunar Eclipses, NASA/TP-2009-214172,
/// section 1.5); the penumbra is the overlap of the earth's disc and the limb-darkened sun as seen
/// from the moon.
[[nodiscard]] Eclipse lunar_eclipse(const ShadowGeometry& shadow) noexcept;

/// Light that the earth's air bends into the umbra, as a share of full sunlight.
///
///     8e-5 exp(1 - (0.55 um / lambda)^4.08)
///
/// 8e-5 at 0.55 um is 10.2 magnitudes, the middle of the two total eclipses that N. Hernitschek, E.
/// Schmidt and M. Vollmer (Appl. Opt. 47, H62, 2008) measured, -3.3 and -1.7 mag, for a full moon
/// of -12.7; after large volcanic eruptions it is 100 times darker. The colour is Rayleigh
/// scattering's along rays that graze the air 15 km high, optical depth 1 at 0.55 um. A rough
/// figure: the umbra's middle is darker than its rim by 10 times.
[[nodiscard]] double umbral_light(Micrometres wavelength) noexcept;

}  // namespace nadir::ephemeris
