#pragma once

#include <vector>

#include "sim/run/camera.hpp"
#include "sim/run/error_list.hpp"
#include "sim/run/input_files.hpp"
#include "sim/scenario/camera_input.hpp"

namespace nadir::sim {

/// A camera without its platform.
struct CameraArrays {
  std::vector<sensor::DetectorArray> arrays;
  std::vector<std::vector<BandElectronics>> electronics;  ///< by array and band
};

/// Reads responses, view tables and point spreads, and checks every array. Mistakes go to `errors`;
/// what has one is incomplete.
[[nodiscard]] CameraArrays load_arrays(const CameraInput& camera, InputFiles& files,
                                       ErrorList& errors);

/// How a band's radiance becomes numbers.
/// @param array  with its pitch and fill
/// @throws InputError for figures that cannot be
[[nodiscard]] BandElectronics load_electronics(const ArrayInput& input, const BandInput& band,
                                               const sensor::DetectorArray& array,
                                               const spectral::Response& response);

/// Checks that light can be counted: a dark current that fills the well, or no exposure at all.
/// @param electronics  of all the array's bands
/// @throws InputError at the detector
void check_electronics(const ArrayInput& input, const sensor::DetectorArray& array,
                       const std::vector<BandElectronics>& electronics);

/// All moments that arrays can ask for. @param arrays  one at least
[[nodiscard]] sensor::TimeSpan span_of(const std::vector<sensor::DetectorArray>& arrays);

}  // namespace nadir::sim
