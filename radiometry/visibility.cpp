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
    const auto* pane =
        std::get_if<materials::BoundClearSheet>(&scene.material(hit->material).scattering);
    if (pane == nullptr) return false;
    light *= pane->albedo(SurfacePoint{scene, ray, *hit}.wo()).transmittance;
    const Vec3 origin = geometry::leaving_origin(*hit, ray.direction);
    ray.max_distance -= dot(origin - ray.origin, ray.direction);
    ray.origin = origin;
    if (!(ray.max_distance > 0.0)) return true;
  }
  return false;
}

}  // namespace

bool passes(const LitScene& scene, const Ray& ray, const Sampler& numbers, Spectrum& light) {
  const bool free = !scene.geometry().occluded(ray);
  if (!free && (!scene.has_sheets() || !passes_sheets(scene, ray, numbers, light))) return false;
  const BoundVolumes& volumes = scene.volumes();
  if (!volumes.empty() && volumes.crossed(ray, ray.max_distance)) {
    light *= volumes.transmittance(ray, ray.max_distance, numbers);
  }
  return true;
}

}  // namespace nadir::radiometry
