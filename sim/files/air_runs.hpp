#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "atmosphere/table/air_table.hpp"

// What other programs compute of the air, one direction at a time, and a table made of it.

namespace nadir::sim {

/// The way from an eye in one direction, as another program saw it. Spectra run over the set's
/// wavelengths; empty where the run does not give them.
struct AirRun {
  std::string name;                   ///< for messages: file, and which of its runs
  double height_m = 0.0;              ///< of the eye, above sea level
  double zenith_rad = 0.0;            ///< of the direction looked in, at the eye
  std::optional<double> azimuth_rad;  ///< from the sun, 0 to pi; none: does not matter
  double length_m = std::numeric_limits<double>::infinity();  ///< infinite: to ground or space
  std::vector<double> transmittance;
  std::vector<double> solar;  ///< sunlight scattered into the way, W m^-2 sr^-1 um^-1
  std::vector<double> even;   ///< what the air on the way emits, scattered or not, the same unit
};

/// The runs of one air.
struct AirRunSet {
  std::vector<double> wavelength_um;  ///< ascending
  std::vector<AirRun> runs;
  std::optional<double> sun_zenith_rad;
  // Of the sun, by wavelength, empty where no run gives it; W m^-2 um^-1.
  std::vector<double> sun_irradiance;           ///< outside the air, across the beam
  std::vector<double> sun_transmittance;        ///< to the ground
  std::vector<double> sun_transmittance_rough;  ///< used where there is no other
  std::vector<double> ground_irradiance;        ///< direct and diffuse on a level, black ground
  std::vector<double> spherical_albedo;
  std::string made_by;
  std::vector<std::string> notes;
};

/// Takes over what `more` has and `set` has not. @throws InputError for other wavelengths, another
/// sun zenith, or runs that give the same twice
void merge(AirRunSet& set, AirRunSet more);

struct AirRunSettings {
  double ground_m = 0.0, top_m = 100'000.0;
  std::optional<double> sun_zenith_rad;   ///< goes before that of the runs
  std::optional<double> sun_azimuth_rad;  ///< clockwise from north
};

/// Where a run looks, for programs that do not say.
struct RunGeometry {
  double height_m = 0.0, zenith_rad = 0.0;
  std::optional<double> azimuth_rad;  ///< from the sun
  double length_m = std::numeric_limits<double>::infinity();
};

/// The table that the runs make.
///
/// Runs from the ground up to space are the sky; other heights are views, and so is the ground
/// where runs look along it or only part of a way. Every height needs the whole way, to space or
/// ground, in each of its directions, and with sunlight each zenith angle at every azimuth. Partial
/// ways add nodes of `share`; where directions have different ones, sources and extinction, which
/// vary slowly, are interpolated linearly. What the runs do not tell is 0 and noted.
/// @throws InputError that lists the runs which are missing
[[nodiscard]] atmosphere::AirTable table_of_runs(const AirRunSet& set,
                                                 const AirRunSettings& settings);

}  // namespace nadir::sim
