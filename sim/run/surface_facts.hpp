#pragma once

#include <map>
#include <vector>

#include "materials/material.hpp"
#include "sim/plan/scene_facts.hpp"
#include "sim/scenario/scenario.hpp"

namespace nadir::sim {

/// How warm surfaces are, before anything is solved. K.
struct SurfaceWarmth {
  double coldest = 0.0;         ///< of all surfaces
  double warmest = 0.0;         ///< of all surfaces
  double warmest_solved = 0.0;  ///< of those that the heat balance or the weather decides; 0: none
};

/// From what the scenario states. Surfaces whose temperature a raster or a table gives, which are
/// not read for this, may have any from 0 to 6000 K; those to be solved, what docs/effects.md says.
/// @param hottest_vertex_k  by material, of those that take it from their meshes
/// @param night             the sun has been below -6 degrees: clear-sky weather bounds the warmest
[[nodiscard]] SurfaceWarmth surface_warmth(const Scenario& scenario,
                                           const std::map<std::uint32_t, double>& hottest_vertex_k,
                                           bool night);

/// Greatest black-body radiance of a band, W m^-2 sr^-1 um^-1. @param lo_um, hi_um  its ends
struct BandEnds {
  double lo_um = 0.0, hi_um = 0.0;
};
[[nodiscard]] double greatest_planck(BandEnds band, double kelvin);
[[nodiscard]] double least_planck(BandEnds band, double kelvin);

/// Least and greatest value of a curve within a band; not a number where it does not reach.
struct CurveRange {
  double least = 0.0, greatest = 0.0;
};
[[nodiscard]] CurveRange range_within(const spectral::Curve& curve, BandEnds band);

/// Fills the band's reflectances, transmittance and emissivities. Diffuse surfaces have those of
/// their curves; models that bring spectra or directions of their own are asked at eight
/// wavelengths and four angles, with a margin of a tenth. What cannot be bound may be anything.
void add_surface_spectra(const std::vector<materials::Material>& materials, BandFacts& band);

/// How much brighter under the sun or the moon the material may look than a diffuse surface of the
/// band's greatest reflectance: 1 for diffuse ones; 1.5 times the greatest of some 250 pairs of
/// directions for rough ones (Oren-Nayar, Minnaert, Hapke and the like); for all others pi over the
/// disc's solid angle, which no reflection can exceed.
[[nodiscard]] double greatest_gloss(const materials::Material& material, const BandFacts& band);

/// Whether light crosses a surface of that material: a leaf or a sheet.
[[nodiscard]] bool lets_through(const materials::Material& material);

}  // namespace nadir::sim
