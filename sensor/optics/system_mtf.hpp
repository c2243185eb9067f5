#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "sensor/camera/detector_array.hpp"
#include "sensor/platform/platform.hpp"

namespace nadir::sensor {

/// One factor of a system's modulation transfer along one axis of the image.
struct MtfTerm {
  std::string name;            ///< "optics", "detector", "smear", "lag", ...
  std::vector<double> values;  ///< one a frequency
};

/// Which modulation transfer is asked for.
struct MtfQuestion {
  std::size_t band = 0;
  bool along = false;  ///< along the lines' sequence (y) instead of x
  /// Of the ground's image along this axis, from + to -: a pushbroom whose lines fit the motion has
  /// 1 / line period along y.
  double motion_px_per_s = 0.0;
};
struct SystemMtf {
  std::vector<double> cycles_per_pixel;
  std::vector<MtfTerm> terms;  ///< those that the array has
  std::vector<double> total;   ///< their product
};
/// Modulation transfer of a band at frequencies in cycles per pixel. Every term that the renderer
/// samples, each by its closed form: optics with stray light, detector area, motion in the
/// exposure, bolometer's lag, time-delay integration that does not match the motion, jitter without
/// memory of perspective cameras. Not in it: jitter with memory, distortion, the turning of
/// modules.
[[nodiscard]] SystemMtf system_mtf(const DetectorArray& array, const Platform& platform,
                                   const MtfQuestion& question,
                                   const std::vector<double>& cycles_per_pixel);

}  // namespace nadir::sensor
