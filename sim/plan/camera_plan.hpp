#pragma once

#include <vector>

#include "atmosphere/layered.hpp"
#include "sensor/camera/detector_array.hpp"
#include "sim/plan/array_plan.hpp"

namespace nadir::sim {

/// What the air is solved at: wavelengths, each standing for an interval of a band, and the lanes
/// into which the absorption by gases splits them. Empty where the air has no such lanes.
struct AirLanes {
  std::vector<Micrometres> wavelengths;             ///< ascending
  std::vector<spectral::AbsorptionLane> intervals;  ///< one a wavelength; term 0
  std::vector<atmosphere::SplitLane> lanes;         ///< ascending by wavelength, interval and term
};

/// What is simulated for a camera: one plan an array, in their order.
struct CameraPlan {
  std::vector<ArrayPlan> arrays;
  AirLanes air;
};

/// The least and the greatest wavelength at which anything is simulated.
struct WavelengthRange {
  Micrometres lo, hi;
};
[[nodiscard]] WavelengthRange wavelength_range(const CameraPlan& plan);

/// The nodes of all bands and the part of its band that each stands for, each once; no lanes yet.
[[nodiscard]] AirLanes air_nodes(const std::vector<sensor::DetectorArray>& arrays,
                                 const BandNodes& per_band);

/// Plans for air that absorbs alike over each band's nodes.
[[nodiscard]] CameraPlan plan_camera(const std::vector<sensor::DetectorArray>& arrays,
                                     const BandNodes& per_band);

/// Plans for air in layers. Each node of a band's quadrature stands for the part of the band that
/// is its share of the response (spectral::interval_edges); the gases split it into lanes that each
/// obey Beer's law. A lane counts in the band by its node's weight times its term's. Lanes that
/// arrays and bands have in common are solved once.
/// @throws InputError where the figures of gases do not reach a band
[[nodiscard]] CameraPlan plan_camera(const std::vector<sensor::DetectorArray>& arrays,
                                     const BandNodes& per_band, const atmosphere::Layered& air,
                                     const atmosphere::AirSettings& settings);

/// Plans for a table from elsewhere. Where its lanes are split by gases, the camera's must be those
/// that it was made for; a table of plain wavelengths serves any lane between them.
/// @throws InputError for a band whose lanes the split table has not
[[nodiscard]] CameraPlan plan_camera(const std::vector<sensor::DetectorArray>& arrays,
                                     const BandNodes& per_band, const atmosphere::AirTable& table);

}  // namespace nadir::sim
