#pragma once

#include <cstdint>
#include <optional>
#include <variant>
#include <vector>

#include "radiometry/effect_shares.hpp"
#include "radiometry/generic_solver.hpp"
#include "radiometry/path_solver.hpp"
#include "sensor/camera/path_view.hpp"
#include "sim/plan/array_plan.hpp"
#include "sim/run/band_sums.hpp"
#include "sim/run/image.hpp"
#include "sim/run/render.hpp"
#include "sim/run/sampling_goal.hpp"
#include "sim/run/truth_sums.hpp"

namespace nadir::sim {

/// A pixel of a detector array and a path through it.
struct PathNumber {
  int sample = 0, line = 0;
  int replicate = 0, path = 0;
};
/// The random numbers of a path. @param array_key  of the array
[[nodiscard]] Sampler path_numbers(std::uint64_t array_key, const sensor::DetectorArray& array,
                                   const PathNumber& number);

/// One detector array against the scene, at the wavelengths that its bands need.
struct ArrayJob {
  const radiometry::SceneDescription* scene = nullptr;
  const sensor::Platform* platform = nullptr;
  const sensor::DetectorArray* array = nullptr;
  ArrayPlan plan;
  std::vector<radiometry::LitScene> blocks;  ///< the scene at each block of lanes
  TruthOptions truth;
  std::size_t number = 0;  ///< of the array
};

/// One round of an array's samples.
struct PixelRound {
  std::uint64_t array_key = 0;  ///< of the round's random numbers
  bool truth = true;            ///< filled by the first round alone
};
/// The key of a round's random numbers: independent of those of all other rounds and arrays.
[[nodiscard]] std::uint64_t round_key(std::uint64_t seed, std::size_t array, std::uint32_t round);

/// What was found at one pixel, by band.
struct PixelMeasure {
  std::vector<Estimate> bands;                  ///< W m^-2 sr^-1 um^-1
  std::vector<std::vector<double>> replicates;  ///< [band][replicate]: means of the replicates
  std::uint32_t paths = 0;                      ///< sampled
};

/// How a pixel is sampled.
struct PixelOrder {
  /// A replicate, whatever the goal; 0 leaves the pixel blank. Nothing: until the goal of the
  /// options is met or, without one, as often as they say.
  std::optional<int> samples{};
  double least_paths = 0.0;  ///< with a goal: it gets no fewer, though it meets that sooner
  int most_samples = 0;      ///< with a goal: a replicate, met or not; 0: those of the goal
};

/// Renders the pixels of an array one by one. One for each thread or tile: it owns the solvers and
/// all scratch memory, so that a pixel allocates nothing.
class PixelRenderer {
 public:
  PixelRenderer(const ArrayJob& job, const RenderOptions& options, const PixelRound& round);

  /// Computes a pixel and stores it in the strip or tile; pixels may be computed in any order.
  /// @param sample, line  of the image
  void render(int sample, int line, ArrayImage& strip, const PixelOrder& order = {});
  /// Computes a pixel and gives what was found, without storing it.
  /// @param found  is filled; its vectors keep their memory
  void measure(int sample, int line, PixelMeasure& found);
  [[nodiscard]] radiometry::Counters counters() const;

 private:
  void begin_pixel(int sample, int line);
  void sample_as_asked(const PixelOrder& order);
  void sample_to_goal(const PixelOrder& order);
  /// More samples of every replicate, up to a number.
  void sample_to(int samples);
  /// One path: adds what it saw to the sums of all blocks.
  void trace(const sensor::PathView& view, const Sampler& numbers, bool truth);
  void add_weighted(const sensor::PathView& view);
  void add_shares(const geometry::Ray& ray, const std::optional<geometry::Hit>& hit);
  /// Radiance of a band from values of every block's lanes.
  template <class Values>
  [[nodiscard]] double of_band(std::size_t band, const Values& by_block) const;
  void close_replicate(int samples);
  /// What is known of the bands after the present samples, errors stated as the options ask.
  void judge();
  [[nodiscard]] bool meets_goal() const;
  [[nodiscard]] bool all_equal() const;
  [[nodiscard]] std::uint32_t paths() const {
    return static_cast<std::uint32_t>(replicates_) * static_cast<std::uint32_t>(samples_);
  }
  void store(ArrayImage& strip) const;

  const ArrayJob* job_;
  const RenderOptions* options_;
  PixelRound round_;
  int replicates_;
  using Solver = std::variant<radiometry::GenericSolver, radiometry::PathSolver>;
  std::vector<Solver> solvers_;                         // one a block
  std::vector<spectral::SpectrumSum> lane_sums_;        // one a block, of a replicate
  std::vector<spectral::Spectrum> lanes_;               // one a block, of a path
  std::vector<spectral::SpectrumSum> path_, emission_;  // one a block, of a pixel
  bool weighted_;
  std::vector<double> weights_, means_;  // one a band
  BandSums bands_;
  TruthSums truth_;
  int sample_ = 0, line_ = 0, samples_ = 0;  // of the present pixel
  std::vector<Estimate> found_;              // one a band
  std::vector<ErrorStatement> errors_;       // one a band
};

}  // namespace nadir::sim
