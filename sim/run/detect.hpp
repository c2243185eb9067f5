#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <vector>

#include "core/diagnostics.hpp"
#include "sensor/detector/signal_chain.hpp"
#include "sim/run/camera.hpp"
#include "sim/run/image.hpp"
#include "sim/scenario/results_input.hpp"

namespace nadir::sim {

/// The detectors of a camera, after the render: from the radiance of each band that has a detector
/// to its digital numbers. The same seed gives the same numbers, however the lines are cut into
/// strips; other seeds give other noise and the same fixed pattern.
class DetectorStage {
 public:
  /// @throws InputError naming array and band, for figures out of range
  DetectorStage(const Camera& camera, const ProductsInput& wanted, std::uint64_t seed);
  ~DetectorStage();
  DetectorStage(DetectorStage&&) noexcept;
  DetectorStage& operator=(DetectorStage&&) noexcept;

  /// Fills `dn`, `noise` and, where they are wanted, `electrons` of the strip's bands that have a
  /// detector. The strips of an array come in order, from line 0 on; those of other arrays may come
  /// between.
  /// @throws std::invalid_argument for a strip that does not follow the former one or is not the
  ///         array's
  void apply(std::size_t array, ArrayImage& strip);

  /// Whether any band of any array has a detector.
  [[nodiscard]] bool any() const noexcept;
  /// Whether every band of the array has one.
  [[nodiscard]] bool complete(std::size_t array) const noexcept;
  /// Back to radiance, by array and band; 1 and 0 for bands without a detector, nothing for arrays
  /// without any.
  [[nodiscard]] std::vector<std::vector<sensor::Calibration>> calibrations() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Another noisy image of what a run has rendered: reads each array's radiance from the run's
/// folder and writes its digital numbers beside it, `<array>_dn_<seed>.img` with its header, some
/// lines at a time.
/// @return the images written
/// @throws InputError for mistakes in the scenario, a camera without detectors, and images that are
///         missing or not of this scenario; std::runtime_error where a file cannot be written
[[nodiscard]] std::vector<std::filesystem::path> detect_again(const std::filesystem::path& scenario,
                                                              const std::filesystem::path& output,
                                                              std::uint64_t seed,
                                                              Diagnostics& diagnostics);

}  // namespace nadir::sim
