#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "sim/run/air_stage.hpp"
#include "sim/run/probe.hpp"
#include "sim/study/study_pixels.hpp"
#include "sim/study/study_record.hpp"

namespace nadir::sim {

/// What a study renders.
struct StudySource {
  std::filesystem::path scenario;
  std::uint64_t seed = 1;
  int threads = 0;  ///< 0: one per processor
};

/// A scenario loaded to be rendered in many ways. Every effect is simulated.
class StudyWorld {
 public:
  /// Reads the scenario and all that it names, solves its temperatures and its air.
  /// @throws InputError for mistakes of the user's files
  StudyWorld(const StudySource& source, Diagnostics& diagnostics);

  /// All that a study's header says but the number of pixels.
  [[nodiscard]] StudyHeader header() const;
  [[nodiscard]] std::vector<ImageSize> image_sizes() const;
  [[nodiscard]] const Camera& camera() const noexcept { return world_.camera; }
  [[nodiscard]] int threads() const noexcept { return threads_; }

  /// From now on these are the pixels.
  void choose_pixels(const StudyHeader& header);
  [[nodiscard]] StudySample sample(const StudySettings& settings, const SamplingRequest& request);
  /// Pixels of anybody's choice.
  [[nodiscard]] ProbeResult probe(const StudySettings& settings, const SamplingRequest& request,
                                  const std::vector<PixelPlace>& places);
  /// Seconds until a first path can be traced with these settings, beyond what every row needs.
  [[nodiscard]] double preparation_s(const StudySettings& settings) const;

 private:
  /// Air and lanes of some wavelengths and streams.
  struct Variant {
    atmosphere::Atmosphere air;
    CameraPlan plan;
  };
  const Variant& variant(const StudySettings& settings);
  Variant make_variant(const StudySettings& settings);
  [[nodiscard]] StudySettings own_settings() const;
  [[nodiscard]] const LayeredTask* layered() const;

  Scenario scenario_;
  Diagnostics* diagnostics_;
  InputFiles inputs_;
  std::uint64_t seed_;
  int threads_;
  World world_;
  std::map<std::string, Variant> variants_;
  std::optional<RayBending> bending_;
  double air_s_ = 0.0;  ///< that the scenario's own air took, or would have taken
  std::vector<StudyBand> bands_;
  std::vector<PixelPlace> places_;
  std::vector<std::uint64_t> image_pixels_;
};

/// The digests of files, in order. @throws std::runtime_error where one cannot be read
[[nodiscard]] std::vector<StudyInput> digests_of(const std::vector<std::string>& paths);

}  // namespace nadir::sim
