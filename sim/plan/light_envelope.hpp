#pragma once

#include "core/quantity.hpp"

// Upper bounds of light that need no file: closed forms with a margin, each held against the
// shipped data or the solved air in tests/sim/gather_facts_test.cpp.

namespace nadir::sim {

/// Of the sun's irradiance outside the air, normal to its direction, at one astronomical unit:
///
///     1.3 pi sin^2(r) B(lambda, 6000 K),  r = 0.26656 deg
///
/// The disc's brightness temperature reaches 6100 K at 0.45 um and 6400 K at 1.6 um (opacity
/// minimum of H-); 1.3 covers that and Fraunhofer structure sampled at 1 nm.
/// Domain: 0.3 to 14 um.
[[nodiscard]] double sun_envelope(Micrometres wavelength) noexcept;

/// Of the moon's, from its phase angle: sunlight by a disc of reflectance 0.5 10^(-0.4 0.016 g/deg)
/// (ROLO's disc reflectance stays below 0.45 up to 2.4 um, and falls off faster: 0.026 mag a
/// degree, Allen, Astrophysical Quantities), and its own emission as a black body at 400 K (the
/// subsolar point's 395 K). Perigee: a solid angle of 7.2e-5 sr.
/// @param phase  0: full moon
[[nodiscard]] double moon_envelope(Micrometres wavelength, Angle phase) noexcept;

/// What share of its scattered light at the horizon a body still sends from below it. Clear-sky
/// illuminance falls from some 700 lx at 0 to 3.4 lx at -6 deg, 0.008 lx at -12 deg and 6e-4 lx at
/// -18 deg (AMS Glossary of Meteorology; Seidelmann, Explanatory Supplement); ten times that, log-
/// linear between, for other wavelengths than the eye's. 1 above the horizon, 0 below -18 deg.
[[nodiscard]] double twilight_share(Angle elevation) noexcept;

/// Vertical optical depth of Rayleigh scattering by all air above a surface pressure:
///
///     0.008569 l^-4 (1 + 0.0113 l^-2 + 0.00013 l^-4) p / 1013.25,  l in um
///
/// Source: Hansen & Travis, Space Sci. Rev. 16, 527 (1974), eq. 2.29.
[[nodiscard]] double rayleigh_depth(Micrometres wavelength, double pressure_hpa) noexcept;

/// Air as the bounds of its scattering see it, at one wavelength.
struct ScatteringAir {
  double depth = 0.0;               ///< vertical, of scattering
  double ground_reflectance = 0.0;  ///< of what is about the scene, at most
};

/// Upper bound of diffuse irradiance on level ground per irradiance E0 of a body outside the air.
/// What the direct beam loses, plus what the ground sends up and the air back down:
///
///     mu (1 - exp(-tau / mu) + s rho) / (1 - s rho),  s = min(1, 2 tau)
///
/// mu the sine of the elevation, but at least 0.1: near the horizon the air is a shell, not a
/// plate. Energy is kept and absorption left out, so no slab of air gives more. Below the horizon
/// times twilight_share.
[[nodiscard]] double scattered_share(const ScatteringAir& air, Angle elevation) noexcept;

/// The same on a surface of any slope: one that faces the body gets all that its beam loses,
/// however low it stands, and of the rest no more than twice what level ground gets.
///
///     1 - exp(-tau / mu) + 2 scattered_share
[[nodiscard]] double scattered_share_on_slopes(const ScatteringAir& air, Angle elevation) noexcept;

/// A line of sight through the air.
struct SightLine {
  double air_mass = 1.0;        ///< of the longest
  double cos_scattering = 1.0;  ///< greatest cosine of the angle by which its light was turned
};
/// Upper bound of the radiance that the air scatters into a line of sight, per E0:
///
///     (1 - exp(-tau m)) (3 p(Theta) / (4 pi) + 2 F / pi)
///
/// p the phase function of Henyey and Greenstein with g = 0.85 plus 1.5 (Rayleigh's largest), three
/// times for what real particles have more; F the diffuse and ground-reflected light per E0, twice
/// because it is not even.
[[nodiscard]] double path_share(const ScatteringAir& air, const SightLine& sight,
                                Angle elevation) noexcept;

}  // namespace nadir::sim
