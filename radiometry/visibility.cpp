#include "radiometry/visibility.hpp"

#include "radiometry/surface_point.hpp"

namespace nadir::radiometry {
namespace {

using geometry::Ray;
using spectral::Spectrum;

constexpr int most_sheets = 256;  // a ray that grazes along a thousand panes carries nothing

/// Goes from sheet to sheet until the ray is through or meets something else.
bool passes_sheets(const LitScene& scene, Ray ray, const Sampler& numbers, Spectrum& light) {
  for (int sheet = 0; sheet < most_sheets; ++sheet) {
    const auto hit = scene.intersect(ray, numbers.child(static_cast<std::uint32_t>(sheet)));
    if (!hit) return true;
    const materials::BoundMaterial& pane = scene.material(hit->material);
    if (!pane.traits.straight) return false;
    light *=
        materials::straight_transmittance(pane.scattering, SurfacePoint{scene, ray, *hit}.wo());
    const Vec3 origin = geometry::leaving_origin(*hit, ray.direction);
    ray.max_distance -= dot(origin - ray.origin, ray.direction);
    ray.origin = origin;
    if (!(ray.max_distance > 0.0)) return true;
  }
  return false;
}

}  // namespace

bool passes(const LitScene& scene, const Ray& ray, const Sampler& numbers, Spectrum& light) {
  if (!scene.shadows()) return true;
  const bool free = !scene.geometry().occluded(ray);
  if (!free && (!scene.has_sheets() || !passes_sheets(scene, ray, numbers, light))) return false;
  const BoundVolumes& volumes = scene.volumes();
  if (!volumes.empty() && volumes.crossed(ray, ray.max_distance)) {
    light *= volumes.transmittance(ray, ray.max_distance, numbers);
  }
  return true;
}

}  // namespace nadir::radiometry
