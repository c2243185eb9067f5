#pragma once

namespace nadir::radiometry {

/// Which solver computes a scene.
enum class Method {
  generic,  ///< the generic radiometry solver: hemisphere of quads, sample decay, thresholds
  path      ///< the path solver: unbiased
};

}  // namespace nadir::radiometry
