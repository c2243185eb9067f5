#pragma once

#include <cstdint>
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
};

/// Renders the pixels of an array one by one. One for each thread or tile: it owns the solvers and
/// all scratch memory, so that a pixel allocates nothing.
class PixelRenderer {
 public:
  PixelRenderer(const ArrayJob& job, const RenderOptions& options, std::uint64_t array_key);

  /// Computes a pixel and stores it in the strip; pixels may be computed in any order.
  /// @param line  of the image
  void render(int sample, int line, ArrayImage& strip);
  [[nodiscard]] radiometry::Counters counters() const;

 private:
  /// One path: adds what it saw to the sums of all blocks.
  void trace(const sensor::PathView& view, const Sampler& numbers);
  void add_weighted(const sensor::PathView& view);
  void add_shares(const geometry::Ray& ray, const std::optional<geometry::Hit>& hit);
  /// Radiance of a band from values of every block's lanes.
  template <class Values>
  [[nodiscard]] double of_band(std::size_t band, const Values& by_block) const;
  void close_replicate();
  void store(std::size_t pixel, ArrayImage& strip) const;
  void store_brightness(std::size_t pixel, std::size_t band, const Estimate& radiance,
                        BandImage& image) const;

  const ArrayJob* job_;
  const RenderOptions* options_;
  std::uint64_t array_key_;
  using Solver = std::variant<radiometry::GenericSolver, radiometry::PathSolver>;
  std::vector<Solver> solvers_;                         // one a block
  std::vector<spectral::SpectrumSum> lane_sums_;        // one a block, of a replicate
  std::vector<spectral::Spectrum> lanes_;               // one a block, of a path
  std::vector<spectral::SpectrumSum> path_, emission_;  // one a block, of a pixel
  bool weighted_;
  std::vector<double> weights_, means_;  // one a band
  BandSums bands_;
  TruthSums truth_;
};

}  // namespace nadir::sim
