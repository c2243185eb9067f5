#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "radiometry/counters.hpp"
#include "radiometry/lit_scene.hpp"
#include "sensor/camera/detector_array.hpp"
#include "sim/plan/camera_plan.hpp"
#include "sim/run/camera.hpp"
#include "sim/run/image.hpp"
#include "sim/run/pixel_ray.hpp"
#include "sim/scenario/scenario.hpp"

namespace nadir::sim {

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
};

/// What takes the image as it is made: strips of whole lines of one array after the other, each
/// from its first line to its last.
using StripSink = std::function<void(std::size_t array, ArrayImage&& strip)>;

/// Computes every pixel of every array, in strips so that memory does not grow with the number of
/// lines. The result does not depend on the number of threads.
/// @throws InputError where a spectrum does not serve the bands
[[nodiscard]] radiometry::Counters render_strips(const radiometry::SceneDescription& scene,
                                                 const Camera& camera, const RenderOptions& options,
                                                 Diagnostics& diagnostics, const StripSink& sink);

struct RenderResult {
  std::vector<ArrayImage> images;
  radiometry::Counters counters;
};

/// The same with the images as a whole.
[[nodiscard]] RenderResult render(const radiometry::SceneDescription& scene, const Camera& camera,
                                  const RenderOptions& options, Diagnostics& diagnostics);

}  // namespace nadir::sim
