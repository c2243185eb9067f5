#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "atmosphere/atmosphere.hpp"
#include "atmosphere/layered.hpp"
#include "ephemeris/illumination.hpp"
#include "sim/plan/wavelength_choice.hpp"

namespace nadir::sim {

/// A quantity of the air, and whether the simulation takes its mean over the interval that a node
/// stands for, or its value at the node.
struct AirFunction {
  SpectralFunction at;
  bool over_interval = false;
};

/// A product of several, with a factor.
struct AirLight {
  std::vector<AirFunction> factors;
  double scale = 1.0;
};

/// What air does to light over wavelength, roughly: what it lets through with all the structure
/// that its gases have, what it adds by simple laws for single scattering and emission. Good enough
/// to find out how many wavelengths are needed, not to compute an image.
struct AirSpectra {
  std::vector<AirFunction> view;          ///< from surface to sensor: factors
  std::vector<AirLight> bodies;           ///< on level ground, over pi, by body, view included
  std::vector<AirLight> sky_scattering;   ///< what a white surface shows of the sky, likewise
  std::vector<AirLight> sky_emission;     ///< the same
  std::vector<AirLight> path_scattering;  ///< added to the line of sight
  std::vector<AirLight> path_emission;
};

/// Where the sensor is and how it looks.
struct AirView {
  double observer_height_m = 0.0;  ///< above sea level
  double secant = 1.0;             ///< of the angle to the vertical, 1 .. 6
};

/// @param band      the part of the spectrum that is asked for
/// @param knots_um  gets the wavelengths where functions bend
/// Everything is kept by reference.
[[nodiscard]] AirSpectra air_spectra(const atmosphere::Atmosphere& air,
                                     const ephemeris::Illumination& bodies, const AirView& view,
                                     std::vector<double>& knots_um);
/// The same for air in layers that is still to be solved.
[[nodiscard]] AirSpectra air_spectra(const atmosphere::Layered& air,
                                     const ephemeris::Illumination& bodies, const AirView& view,
                                     const spectral::Support& band, std::vector<double>& knots_um);

}  // namespace nadir::sim
