#pragma once

#include "core/diagnostics.hpp"
#include "sim/run/pixel.hpp"
#include "sim/run/render.hpp"

namespace nadir::sim {

/// One array of a camera, ready to be rendered with these options.
/// @throws InputError where a spectrum does not serve the bands
[[nodiscard]] ArrayJob array_job(const radiometry::SceneDescription& scene, const Camera& camera,
                                 std::size_t number, const ArrayPlan& plan,
                                 const RenderOptions& options, Diagnostics& diagnostics);

/// The plan that the options name, or one for air without lanes of its own.
[[nodiscard]] CameraPlan plan_of(const Camera& camera, const RenderOptions& options);

/// Pixels of an array that nobody has rendered yet: a tile, or a strip of whole lines.
struct ImagePart {
  int first_sample = 0, first_line = 0;
  int samples = 0, lines = 0;
};
/// @param truth  with planes of the truth
[[nodiscard]] ArrayImage blank_image(const ArrayJob& job, const ImagePart& part,
                                     const RenderOptions& options, bool truth);

}  // namespace nadir::sim
