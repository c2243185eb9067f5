#pragma once

#include <cstdint>
#include <variant>
#include <vector>

#include "core/statistics.hpp"
#include "radiometry/generic_solver.hpp"
#include "radiometry/path_solver.hpp"
#include "sim/plan/array_plan.hpp"
#include "sim/run/image.hpp"
#include "sim/run/render.hpp"

namespace nadir::sim {

/// The random numbers of a pixel's first path. @param array_key  of the array
[[nodiscard]] Sampler first_path(std::uint64_t array_key, const sensor::DetectorArray& array,
                                 int sample, int line);
/// The line of sight of a path through a pixel, straight.
[[nodiscard]] geometry::Ray pixel_ray(const sensor::DetectorArray& array, const sensor::Pose& pose,
                                      const Sampler& numbers, int sample, int line);

/// One detector array against the scene, at the wavelengths that its bands need.
struct ArrayJob {
  const radiometry::SceneDescription* scene = nullptr;
  const sensor::Pose* pose = nullptr;
  const sensor::DetectorArray* array = nullptr;
  ArrayPlan plan;
  std::vector<radiometry::LitScene> blocks;  ///< the scene at each block of lanes
  bool solves_heat = true;  ///< for its truth planes; false: where no product needs it
};

/// Renders the pixels of an array one by one. One for each thread or tile: it owns the solvers and
/// all scratch memory, so that a pixel allocates nothing.
class PixelRenderer {
 public:
  PixelRenderer(const ArrayJob& job, const RenderOptions& options, std::uint64_t array_key);

  /// Computes a pixel and stores it in the image; pixels may be computed in any order.
  void render(int sample, int line, ArrayImage& image);
  [[nodiscard]] radiometry::Counters counters() const;

 private:
  struct TruthSums;
  [[nodiscard]] const ephemeris::LightSource* sun() const;  // or null
  [[nodiscard]] std::uint32_t shown_as(std::uint32_t material) const;
  /// One path: adds what it saw to the sums of all blocks.
  void trace(const geometry::Ray& ray, const Sampler& numbers, TruthSums& truth);
  /// Turns the sums of a replicate into one draw of each band's radiance.
  void close_replicate();
  void add_truth(const geometry::Hit& hit, TruthSums& truth);
  void store(std::size_t pixel, const TruthSums& truth, ArrayImage& image) const;

  const ArrayJob* job_;
  const RenderOptions* options_;
  std::uint64_t array_key_;
  using Solver = std::variant<radiometry::GenericSolver, radiometry::PathSolver>;
  std::vector<Solver> solvers_;                   // one a block
  std::vector<Welford> spread_;                   // one a band
  std::vector<spectral::SpectrumSum> lane_sums_;  // one a block
  std::vector<std::uint32_t> material_votes_;     // one a material, and the sky first
  std::uint64_t truth_rays_ = 0;
};

}  // namespace nadir::sim
