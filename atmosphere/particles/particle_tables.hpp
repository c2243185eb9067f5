#pragma once

#include <map>
#include <string>
#include <vector>

namespace nadir::atmosphere {

/// Optics of one kind of particles at the tables' wavelengths.
struct ParticleOptics {
  std::vector<double> extinction;  ///< over that at 0.55 um
  std::vector<double> absorption;  ///< over the extinction at 0.55 um
  std::vector<double> asymmetry;   ///< mean cosine of the scattering angle
  /// Which phase function at each of `phase_wavelength_um`, counted from 0; none: Henyey &
  /// Greenstein's with the asymmetry.
  std::vector<int> phase;
};

/// Figures of haze and clouds, as read from the project's data: plain data, legal after reading.
struct ParticleTables {
  std::vector<double> wavelength_um;  ///< ascending
  /// By name. Haze that takes up water ends in its relative humidity, per cent: `rural_70`.
  std::map<std::string, ParticleOptics> kinds;

  std::vector<double> height_km;  ///< ascending, above the ground (see Particles)
  /// Extinction at 0.55 um by height, km^-1; 0 outside the region. By name: `boundary_23` (its
  /// visibility in km), `tropospheric_spring_summer_23`, `stratospheric_autumn_winter_high`,
  /// `upper_background`.
  std::map<std::string, std::vector<double>> haze;

  std::vector<double> phase_wavelength_um;           ///< ascending
  std::vector<double> phase_angle_rad;               ///< 0 to pi
  std::vector<std::vector<double>> phase_functions;  ///< sr^-1 by angle
};

/// Names that Particles looks up; a reader checks that they are there.
[[nodiscard]] std::vector<std::string> required_kinds();
[[nodiscard]] std::vector<std::string> required_haze();
/// The types that a cloud may have: all kinds of the tables that are not haze.
[[nodiscard]] std::vector<std::string> cloud_types();

}  // namespace nadir::atmosphere
