#include "radiometry/effect_shares.hpp"

#include "radiometry/surface_point.hpp"

namespace nadir::radiometry {

EffectShares effect_shares(const LitScene& scene, const geometry::Ray& ray,
                           const std::optional<geometry::Hit>& hit) {
  const int lanes = scene.lanes().count();
  if (!hit) {
    return {scene.air().beyond(ray.origin, ray.direction), spectral::Spectrum{lanes, 0.0F}};
  }
  const atmosphere::PathTerms path = scene.air().path(ray.origin, ray.direction, hit->distance);
  const SurfacePoint point{scene, ray, *hit};
  return {path.radiance, emission(scene, point) * path.transmittance};
}

}  // namespace nadir::radiometry
