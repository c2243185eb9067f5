#include "sim/run/pixel_ray.hpp"

#include <algorithm>
#include <cmath>
#include <variant>

namespace nadir::sim {
namespace {

/// How far from a place the farthest corner of the scene lies.
double reach_of(const geometry::Scene& scene, Vec3 eye) {
  const geometry::Bounds box = scene.bounds();
  const auto farthest = [](double at, double lo, double hi) {
    return std::max(std::abs(at - lo), std::abs(at - hi));
  };
  return length(Vec3{farthest(eye.x, box.lo.x, box.hi.x), farthest(eye.y, box.lo.y, box.hi.y),
                     farthest(eye.z, box.lo.z, box.hi.z)});
}

/// Where a chain of straight pieces has run for a given way.
Vec3 place_along(const atmosphere::BentPath& path, double way_m) {
  const auto after = std::find_if(path.points.begin() + 1, path.points.end(),
                                  [&](const auto& point) { return point.way_m >= way_m; });
  if (after == path.points.end()) {
    const auto& last = path.points.back();
    return last.position + path.end_direction * (way_m - last.way_m);
  }
  const auto& before = *(after - 1);
  const double share = (way_m - before.way_m) / (after->way_m - before.way_m);
  return before.position + (after->position - before.position) * share;
}

/// Size of a pixel across a line of sight at a distance.
double pixel_size_m(const sensor::DetectorArray& array, const sensor::Platform& platform,
                    double distance_m) {
  if (std::holds_alternative<sensor::Orthographic>(array.projection)) return array.pitch_m;
  const double sample = 0.5 * array.samples, line = 0.5 * array.lines;
  const Vec3 a = sensor::image_view(array, platform, {sample - 0.5, line}).ray.direction;
  const Vec3 b = sensor::image_view(array, platform, {sample + 0.5, line}).ray.direction;
  return length(b - a) * distance_m;
}

}  // namespace

std::optional<geometry::Hit> intersect_bent(const geometry::Scene& scene, const RayBending& bending,
                                            const geometry::Ray& ray) {
  const auto path = atmosphere::bent_path(bending.air, bending.ground_m, ray.origin, ray.direction,
                                          reach_of(scene, ray.origin));
  // A piece reaches a millimetre into the next one, so that no surface slips between them.
  constexpr double overlap_m = 1e-3;
  for (std::size_t i = 1; i < path.points.size(); ++i) {
    const Vec3 from = path.points[i - 1].position;
    const Vec3 along = path.points[i].position - from;
    const double piece_m = length(along);
    if (piece_m == 0.0) continue;
    auto hit = scene.intersect({from, along * (1.0 / piece_m), piece_m + overlap_m});
    if (!hit) continue;
    hit->distance += path.points[i - 1].way_m;
    return hit;
  }
  auto hit = scene.intersect({path.points.back().position, path.end_direction});
  if (hit) hit->distance += path.points.back().way_m;
  return hit;
}

double bending_in_pixels(const geometry::Scene& scene, const RayBending& bending,
                         const sensor::DetectorArray& array, const sensor::Platform& platform) {
  constexpr int tried = 9;  // along each side, corners included
  double worst = 0.0;
  for (int j = 0; j < tried; ++j) {
    for (int i = 0; i < tried; ++i) {
      const auto ray =
          sensor::image_view(array, platform,
                             {array.samples * i / (tried - 1.0), array.lines * j / (tried - 1.0)})
              .ray;
      const auto hit = intersect_bent(scene, bending, ray);
      if (!hit) continue;
      const auto path = atmosphere::bent_path(bending.air, bending.ground_m, ray.origin,
                                              ray.direction, hit->distance);
      const Vec3 off = place_along(path, hit->distance) - ray.origin;
      const Vec3 aside = off - ray.direction * dot(off, ray.direction);
      worst = std::max(worst, length(aside) / pixel_size_m(array, platform, hit->distance));
    }
  }
  return worst;
}

}  // namespace nadir::sim
