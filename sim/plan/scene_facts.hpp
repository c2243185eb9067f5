#pragma once

#include <limits>
#include <string>
#include <vector>

namespace nadir::sim {

/// What the planner knows of a scene at one band: cheap figures, each an upper or a lower bound;
/// infinity where nothing is known. Radiance in W m^-2 sr^-1 um^-1, irradiance in W m^-2 um^-1,
/// relative to nothing unless stated.
struct BandFacts {
  std::string name;
  double centre_um = 0.0;
  double lo_um = 0.0, hi_um = 0.0;      ///< of the response
  double least_reflectance = 0.0;       ///< of any surface and wavelength of the band
  double greatest_reflectance = 1.0;    ///< reflected and transmitted together
  double greatest_transmittance = 0.0;  ///< of leaves and sheets
  double least_emissivity = 0.0, greatest_emissivity = 1.0;
  double coldest_emission = 0.0;         ///< black body at the coldest surface's temperature
  double warmest_emission = 0.0;         ///< and at the warmest
  double warmest_solved_emission = 0.0;  ///< of surfaces whose temperature would be solved
  double sun_irradiance = 0.0;   ///< normal to its direction, outside the air, uneclipsed; 0: set
  double moon_irradiance = 0.0;  ///< likewise
  /// Of both on level ground, outside the air, as an eclipse leaves it: for the floor.
  double level_irradiance = 0.0;
  double lamp_irradiance = 0.0;  ///< mean over a pixel's ground at the most; infinity: not known
  double lamp_radiance = 0.0;    ///< of area lamps seen directly, likewise
  double sky_scattering = 0.0;   ///< greatest sky radiance by scattered light, as surfaces see it:
                                 ///< diffuse irradiance over pi
  double least_sky_scattering = 0.0;  ///< of the sky's mean, for the floor; an estimate
  double sky_emission = 0.0;          ///< greatest sky radiance by emission
  double path_scattering = 0.0;  ///< greatest that comes into a line of sight, the sky included
  double path_emission = 0.0;
  double path_loss = 0.0;       ///< greatest 1 - transmittance of a line of sight
  double noise_radiance = 0.0;  ///< sensor's noise at a dark pixel; 0: no detector
};

/// One detector array's.
struct ArrayFacts {
  std::string name;
  std::vector<BandFacts> bands;
  double smear_pixels = 0.0;   ///< way of the image during the exposure, and jitter
  double spread_pixels = 0.0;  ///< rms of the optics' spread; infinity: there is one
  bool has_detector = false;
  double refraction_pixels = 0.0;  ///< shift of the lines of sight where the air refracts
};

/// What the planner knows of a scenario.
struct SceneFacts {
  std::vector<ArrayFacts> arrays;
  bool has_sun = false, has_moon = false;  ///< a body with any part above the horizon
  bool has_lamps = false, has_volumes = false, has_leaves = false;
  bool has_air = false, has_solved_temperatures = false, has_refraction = false;
  double eclipsed_share = 0.0;  ///< of the sun's or the moon's light; 0: no eclipse
  /// How much brighter than a diffuse white surface of the same reflectance some surface may look
  /// under the sun or the moon; 1: all are diffuse.
  double gloss = 1.0;
  bool body_in_view = false;        ///< a line of sight may meet the sun's or the moon's disc
  bool sky_in_view = false;         ///< a line of sight may miss all surfaces
  bool one_convex_surface = false;  ///< no surface sees another one, or itself
  bool wants_temperatures = false;  ///< a product shows them, whatever bands see
  bool moon_drowned = false;        ///< by a sun higher than 5 degrees: it is not modelled
  double sun_elevation_deg = 90.0, moon_elevation_deg = 90.0;
};

}  // namespace nadir::sim
