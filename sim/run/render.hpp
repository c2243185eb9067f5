#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "radiometry/counters.hpp"
#include "radiometry/effect.hpp"
#include "radiometry/lit_scene.hpp"
#include "sensor/camera/detector_array.hpp"
#include "sim/plan/camera_plan.hpp"
#include "sim/run/camera.hpp"
#include "sim/run/image.hpp"
#include "sim/run/pixel_ray.hpp"
#include "sim/run/sampling_goal.hpp"
#include "sim/scenario/scenario.hpp"

namespace nadir::sim {

class TileStore;

/// Rounds of samples that a picture is merged from. Each has random numbers of its own; round 0 has
/// those of a run without rounds.
struct RenderRounds {
  /// Rounds below this are merged where the store has them, and not computed (but for round 0,
  /// which no pixel is without).
  std::uint32_t kept = 0;
  /// Those from `kept` to before this are taken from the store or computed. With a time goal it
  /// says nothing: there are as many rounds as there is time for.
  std::uint32_t end = 1;
};

struct RenderOptions {
  SamplingInput sampling;
  std::uint64_t seed = 1;
  int threads = 0;    ///< 0: one per processor
  bool truth = true;  ///< fill the truth planes (costs a ray per path for the shadow plane)
  std::function<void(std::size_t done, std::size_t all)> progress{};  ///< called after each tile
  const CameraPlan* plan = nullptr;  ///< of the camera; null: for air that has no lanes of its own
  const RayBending* bending = nullptr;  ///< null: the camera's rays are straight
  /// By array: whether temperatures are solved for its truth planes; null: for all.
  const std::vector<bool>* asks_for_heat = nullptr;
  bool sky_view = false, fractions = false;     ///< truth planes that cost more
  bool shares = false;                          ///< share of each effect in the radiance
  const geometry::LocalFrame* frame = nullptr;  ///< of the scene; null: no places in the truth
  const std::vector<std::string>* object_names = nullptr;  ///< by number; null: without names

  /// By array: what is simulated; null: everything.
  const std::vector<radiometry::EffectSet>* effects = nullptr;
  /// Sampling to an accuracy; null: as `sampling` says.
  const SamplingGoal* goal = nullptr;
  /// Sampling until a moment; needs a goal, which says what errors are worth; null: no limit.
  const TimeGoal* time = nullptr;
  /// By array and band: what is known of the error that sampling does not show, relative to
  /// max(radiance, floor); with a goal it fills BandImage::bias. Null: that is not filled.
  const std::vector<std::vector<double>>* bias = nullptr;
  TileStore* store = nullptr;  ///< where tiles are kept and found; null: nowhere
  RenderRounds rounds{};
};

/// What takes the image as it is made: strips of whole lines of one array after the other, each
/// from its first line to its last.
using StripSink = std::function<void(std::size_t array, ArrayImage&& strip)>;

/// What a render came to.
struct RenderTally {
  radiometry::Counters counters;  ///< tiles from the store count as well
  GoalOutcome outcome;            ///< empty without a goal
  std::uint32_t rounds = 1;       ///< the number of the first round that nobody has sampled yet
};

/// Computes every pixel of every array, in strips so that memory does not grow with the number of
/// lines. The result does not depend on the number of threads, nor on which tiles the store had;
/// with a time goal it depends on how fast the machine was.
/// @throws InputError where a spectrum does not serve the bands
[[nodiscard]] RenderTally render_strips(const radiometry::SceneDescription& scene,
                                        const Camera& camera, const RenderOptions& options,
                                        Diagnostics& diagnostics, const StripSink& sink);

struct RenderResult {
  std::vector<ArrayImage> images;
  radiometry::Counters counters;
  GoalOutcome outcome;
};

/// The same with the images as a whole.
[[nodiscard]] RenderResult render(const radiometry::SceneDescription& scene, const Camera& camera,
                                  const RenderOptions& options, Diagnostics& diagnostics);

}  // namespace nadir::sim
