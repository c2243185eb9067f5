#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/quantity.hpp"
#include "ephemeris/lunar_geometry.hpp"
#include "spectral/curve.hpp"

namespace nadir::ephemeris {

/// One band of the disc reflectance model; names as in the paper's equation 10.
struct LunarBand {
  Micrometres wavelength;
  std::array<double, 4> a;  ///< powers of the phase angle, rad^-i
  std::array<double, 3> b;  ///< odd powers of the sun's longitude, rad^-(2 j - 1)
  std::array<double, 3> d;  ///< the opposition's peak and a residual wave
  double smoothing = 1.0;   ///< takes the band to the smooth spectrum of Apollo samples
};

/// The ROLO model of the moon's brightness, version 311g: its bands, and what all bands share.
struct LunarModel {
  std::vector<LunarBand> bands;  ///< wavelengths strictly ascending, at least two

  /// Libration: deg^-1, deg^-1, rad^-1 deg^-1, rad^-1 deg^-1.
  static constexpr std::array<double, 4> c{0.00034115, -0.0013425, 0.00095906, 0.00066229};
  static constexpr std::array<double, 4> p_deg{4.06054, 12.8802, -30.5858, 16.7498};
  static constexpr double solid_angle_sr = 6.4177e-5;       ///< of the moon at the mean distance
  static constexpr double mean_distance_m = 384'400'000.0;  ///< moon to observer
};

/// The model itself.
/// @throws InputError for fewer than two bands or wavelengths out of order
[[nodiscard]] LunarModel checked(LunarModel model);

/// The phase angles for which the model was fitted.
inline constexpr double rolo_first_phase_deg = 1.55, rolo_last_phase_deg = 97.0;

/// Disc-equivalent reflectance of one band, without its smoothing.
///
///     ln A = sum_i a_i g^i + sum_j b_j Phi^(2j-1) + c1 theta + c2 phi + c3 Phi theta + c4 Phi phi
///            + d1 exp(-g / p1) + d2 exp(-g / p2) + d3 cos((g - p3) / p4)
///
/// g is the phase angle (rad in the polynomial, degrees in the d terms), Phi the sun's
/// selenographic longitude (rad), theta and phi the observer's latitude and longitude (deg).
///
/// Source: H. H. Kieffer and T. C. Stone, The Spectral Irradiance of the Moon, AJ 129, 2887 (2005),
/// doi:10.1086/430185, eq. 10, table 4. Accuracy: 1 % relative, 5 to 10 % absolute (theirs).
/// Continued, without a step: below 1.55 degrees the value there; above 97 degrees the value there
/// (the sun's longitude shortened in the same ratio) times `crescent` below.
[[nodiscard]] double disc_reflectance(const LunarBand& band,
                                      const LunarGeometry& geometry) noexcept;

/// How the moon's light falls off beyond the model's last phase angle: 1 there, 0 at 180 degrees.
///
/// To 150 degrees the law of K. Krisciunas and B. Schaefer, PASP 103, 1033 (1991), eq. 9:
/// magnitude 0.026 g + 4e-9 g^4; beyond, the integral phase function of a Lommel-Seeliger sphere,
/// 1 - sin(g/2) tan(g/2) ln cot(g/4) (Seeliger 1887), joined to it. The earthshine on the dark
/// side, some 1e-4 of the full moon, is not in it.
/// @param phase  97 degrees to pi
[[nodiscard]] double crescent(Angle phase) noexcept;

/// Disc-equivalent reflectance over wavelength: the bands times their smoothing, linear between.
/// Beyond the last band (2.38 um) constant. Below the first (0.35 um) linear to `ultraviolet_share`
/// of it at 0.25 um, constant below.
/// Source of the ultraviolet: geometric albedo from 0.044 at 0.25 to 0.083 at 0.40 um (S. J. Janz
/// et al., Geophys. Res. Lett. 23, 1996, doi:10.1029/96GL01122), hence 0.070 at 0.35 um.
[[nodiscard]] spectral::Curve disc_reflectance(const LunarModel& model,
                                               const LunarGeometry& geometry);
inline constexpr double ultraviolet_end_um = 0.25, ultraviolet_share = 0.63;

struct LunarIrradiance {
  spectral::Curve irradiance;      ///< on a plane normal to the moon's direction, W m^-2 um^-1
  std::vector<std::string> notes;  ///< where the model was continued, in words
};

/// The moon's irradiance outside the air.
///
///     E = A Omega / pi E_sun(1 au) (1 au / d_sun)^2 (384400 km / d_observer)^2     (their eq. 7)
///
/// Heat that the moon itself emits is not in it: below 1e-3 W m^-2 um^-1 at 10 um.
/// @param solar_1au  solar irradiance at 1 au, W m^-2 um^-1
[[nodiscard]] LunarIrradiance lunar_irradiance(const LunarModel& model,
                                               const LunarGeometry& geometry,
                                               const spectral::Curve& solar_1au);

}  // namespace nadir::ephemeris
