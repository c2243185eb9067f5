#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sensor/camera/detector_array.hpp"
#include "sensor/detector/detector.hpp"
#include "sensor/platform/platform.hpp"

namespace nadir::sim {

/// What is known of a band beside what it sees.
struct BandElectronics {
  std::optional<sensor::Detector> detector;  ///< none: radiance is all that is wanted
  std::optional<double> reference_radiance;  ///< at which data sheets give its SNR
};

/// A camera ready to be pointed at a scene.
struct Camera {
  sensor::Platform platform;
  std::vector<sensor::DetectorArray> arrays;
  std::vector<std::vector<BandElectronics>> electronics{};  ///< by array and band
  std::string platform_name{}, instrument_name{};           ///< for metadata; may be empty
};

/// The camera's pose in the middle of the time that its images take.
[[nodiscard]] inline sensor::Pose middle_pose(const Camera& camera) {
  const sensor::Platform& platform = camera.platform;
  if (platform.is_fixed()) return platform.at(0.0);
  return platform.steady(0.5 * (platform.first_s() + platform.last_s()));
}

}  // namespace nadir::sim
