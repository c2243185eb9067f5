#pragma once

#include <optional>
#include <vector>

#include "atmosphere/atmosphere.hpp"
#include "sim/plan/light_envelope.hpp"
#include "sim/plan/scene_facts.hpp"
#include "sim/run/load_air.hpp"

namespace nadir::sim {

/// A body as the air sees it. Its irradiance at the wavelength in question is given beside it.
struct BodyHeight {
  Angle elevation;
  double cos_scattering = 1.0;  ///< greatest, of the lines of sight: from its light to the camera
};

/// Irradiance outside the air at wavelengths of a band, W m^-2 um^-1.
struct BandIrradiance {
  std::vector<double> wavelengths_um;
  std::vector<double> sun, moon;  ///< one a wavelength
};

/// What the bounds of the air's light need besides the air.
struct AirSurroundings {
  BodyHeight sun, moon;
  double air_mass = 1.0;  ///< of the longest line of sight
  double warmest_ground_k = 0.0;
  bool peaks_count = false;  ///< surfaces are glossy or the sky is seen: its brightest part counts
};

/// Fills what the air adds and takes away. Uniform air: from its curves. Air in layers: closed
/// forms (light_envelope.hpp) with its own particles and pressure; its gases, and a table from
/// elsewhere, may take away and emit all there is: infinity where a table's light is asked for.
/// @param task  of air that is still to be solved; null: none
void add_air_light(const atmosphere::Atmosphere& air, const AirTask* task,
                   const BandIrradiance& light, const AirSurroundings& about, BandFacts& band);

}  // namespace nadir::sim
