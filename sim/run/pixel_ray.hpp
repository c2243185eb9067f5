#pragma once

#include <optional>

#include "atmosphere/paths/ray_bending.hpp"
#include "geometry/scene.hpp"
#include "sensor/camera/path_view.hpp"

namespace nadir::sim {

/// The air in which the rays of a camera bend.
struct RayBending {
  atmosphere::Refractivity air;
  double ground_m = 0.0;  ///< height above sea level of the origin of the scene's axes
};

/// The first surface along a ray that bends. The hit's distance is the way along the curve.
[[nodiscard]] std::optional<geometry::Hit> intersect_bent(const geometry::Scene& scene,
                                                          const RayBending& bending,
                                                          const geometry::Ray& ray);

/// How far bending shifts what an array sees, in pixels: the greatest shift among 9 x 9 lines of
/// sight over the array, each as far as the surface that it meets.
[[nodiscard]] double bending_in_pixels(const geometry::Scene& scene, const RayBending& bending,
                                       const sensor::DetectorArray& array,
                                       const sensor::Platform& platform);

}  // namespace nadir::sim
