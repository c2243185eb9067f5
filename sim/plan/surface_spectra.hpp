#pragma once

#include <vector>

#include "materials/material.hpp"
#include "sim/plan/wavelength_choice.hpp"

namespace nadir::sim {

/// What a surface does to light over wavelength, whatever the direction.
struct SurfaceSpectra {
  SpectralFunction scatters;  ///< reflectance, or transmittance, or a coefficient of its model
  SpectralFunction emits;     ///< emissivity
  /// Scattered many times between surfaces alike: s w / (1 - 0.8 w) with w all that is scattered,
  /// at most 0.98: steeper over wavelength than s itself.
  SpectralFunction scatters_often;
};

/// The spectra of a material: one for each curve that its scattering is made of (all parts of a
/// mixture). Light from it is a sum of products with them, so that what integrates each of them
/// well integrates their sum. Curves are held at their ends.
/// @param material  kept by reference
/// @param knots_um  gets the wavelengths of the tables
[[nodiscard]] std::vector<SurfaceSpectra> surface_spectra(const materials::Material& material,
                                                          std::vector<double>& knots_um);

/// A curve as a function, held at its ends; 0 where it is negative.
/// @param curve  kept by reference
[[nodiscard]] SpectralFunction function_of(const spectral::Curve& curve,
                                           std::vector<double>& knots_um);

}  // namespace nadir::sim
