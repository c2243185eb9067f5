#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "atmosphere/air_parts.hpp"
#include "atmosphere/gases/band_tables.hpp"
#include "atmosphere/night/night_sky.hpp"
#include "atmosphere/particles/particles.hpp"
#include "atmosphere/profile.hpp"
#include "atmosphere/table/air_table.hpp"
#include "core/diagnostics.hpp"
#include "ephemeris/illumination.hpp"

namespace nadir::atmosphere {

/// The air in layers, as a user describes it: what a table is computed from.
struct Layered {
  std::shared_ptr<const BandTables> gases;
  std::shared_ptr<const ParticleTables> particles;
  Profile profile;               ///< amounts already scaled
  double ground_height_m = 0.0;  ///< of the scene, above sea level
  Aerosol aerosol;
  std::vector<Cloud> clouds;
  NightSky night;
};

enum class AirMode { accurate, fast };

/// What the table is to serve, and how fine.
struct AirSettings {
  AirMode mode = AirMode::accurate;
  int streams = 8;
  double term_tolerance = 5e-4;  ///< of transmittance, see GasAbsorption::terms
  int zenith_nodes = 16;         ///< on either side of the horizon
  int azimuth_nodes = 13;
  int share_nodes = 16;
  double observer_height_m = 0.0;  ///< above sea level
  bool paths = true;               ///< a view from the observer; without: the sky only
  double dark_below = 1e-6;        ///< bodies this much weaker than the strongest are left out
};

/// Absorption terms at the wavelengths of bands: each wavelength with its interval becomes as many
/// lanes as its gases need.
struct SplitLane {
  int source = 0;  ///< which of the wavelengths asked for
  spectral::AbsorptionLane absorption;
  double weight = 1.0;
  /// Vertical optical depth of all gases by layer of the air that it was split for.
  std::vector<double> gas_depth{};
  AirParts wanted{};  ///< what the lane is to be solved for
};
/// @param wavelengths  ascending; absorption(i) holds the interval
[[nodiscard]] std::vector<SplitLane> split_lanes(const Layered& air, const AirSettings& settings,
                                                 const std::vector<Micrometres>& wavelengths,
                                                 const std::vector<spectral::AbsorptionLane>& of);

struct SolveCounts;

/// Solves the air at all lanes and tabulates it. Threaded over lanes (oneTBB); the result does not
/// depend on the number of threads. A body below 18 degrees under the horizon is left out. Light
/// from outside the air is its mean over a lane's interval. What a lane does not want is not
/// solved, and 0 in the table; where none wants anything of the line of sight there are no views.
/// @param counts  if given, what was solved is added (make/lane_fields.hpp)
/// @throws InputError  the observer inside the ground, the ground below the first level, a spectrum
///                     that does not cover the lanes
[[nodiscard]] AirTable make_air_table(const Layered& air, const AirSettings& settings,
                                      const std::vector<SplitLane>& lanes,
                                      const std::vector<Micrometres>& wavelengths,
                                      const ephemeris::Illumination& bodies,
                                      SolveCounts* counts = nullptr);

}  // namespace nadir::atmosphere
