#pragma once

#include "core/sampler.hpp"
#include "geometry/scene.hpp"
#include "radiometry/lit_scene.hpp"
#include "spectral/lanes.hpp"

namespace nadir::radiometry {

/// Light that comes along a shadow ray, from its max_distance to its origin: multiplies `light` by
/// what volumes and clear sheets let through. False where something opaque is in the way.
/// An unbiased estimate where a volume is a grid. Without shadows all light passes untouched, and
/// no ray is traced.
[[nodiscard]] bool passes(const LitScene& scene, const geometry::Ray& ray, const Sampler& numbers,
                          spectral::Spectrum& light);

/// The shadow ray to a lamp that was drawn for `position`, from an origin that may be lifted off
/// the surface there. It is aimed anew and stops just before the lamp's own surface: from the
/// lifted origin that is nearer, by more than its margin in a wide scene.
[[nodiscard]] inline geometry::Ray ray_to_lamp(Vec3 origin, Vec3 position,
                                               const LampSample& lamp) noexcept {
  constexpr double short_of_lamp = 1.0 - 1e-6;
  const Vec3 way = position + lamp.distance * lamp.direction - origin;
  const double distance = length(way);
  if (!(distance > 0.0)) return {origin, lamp.direction, 0.0};  // nearer than the lift
  return {origin, way / distance, distance * short_of_lamp};
}

}  // namespace nadir::radiometry
