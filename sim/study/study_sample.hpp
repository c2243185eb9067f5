#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "sim/study/study_settings.hpp"

namespace nadir::sim {

/// A band that a study looks at.
struct StudyBand {
  std::string array, name;
  std::size_t array_number = 0, band_number = 0;
  double centre_um = 0.0;
  double floor_radiance = 0.0;  ///< W m^-2 sr^-1 um^-1, stated or of the sensor's noise; 0: none
};

/// How pixels are to be sampled.
struct SamplingRequest {
  int replicates = 8, samples = 1;  ///< independent scramblings, paths of each
  std::uint64_t seed = 1;
  int pixels = 0;  ///< so many of the study's of each array; 0: all of them
};

struct SampleCost {
  double path_cpu_s = 0.0;     ///< processor time of a path, mean over the pixels
  double path_wall_s = 0.0;    ///< the clock's, on all threads
  double picture_cpu_s = 0.0;  ///< of one path in every pixel of the whole picture
  double setup_s = 0.0;        ///< before the first path: the scene bound to wavelengths, tables
  double wall_s = 0.0;         ///< all that it took
  double rays_per_path = 0.0;
  double peak_memory_bytes = 0.0;  ///< of the process while it ran
};

/// What was found at the study's pixels.
struct StudySample {
  SamplingRequest request;
  /// By band and pixel of its array: mean of the replicates, variance between them (of one
  /// replicate's mean). W m^-2 sr^-1 um^-1, and squared.
  std::vector<std::vector<double>> mean, variance;
  SampleCost cost;
  [[nodiscard]] double paths() const noexcept {
    return static_cast<double>(request.replicates) * request.samples;
  }
};

/// Samples the study's pixels with some settings.
using Prober = std::function<StudySample(const StudySettings&, const SamplingRequest&)>;
/// Seconds since the study began, those of interrupted attempts included.
using StudyTime = std::function<double()>;

}  // namespace nadir::sim
