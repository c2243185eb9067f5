#include "radiometry/volumes/bound_volumes.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "core/error.hpp"
#include "geometry/bounds.hpp"
#include "radiometry/volumes/walk.hpp"

namespace nadir::radiometry {
namespace {

struct Span {
  double lo, hi;
};
Span along(const geometry::Bounds& b, int axis) {
  if (axis == 0) return {b.lo.x, b.hi.x};
  return axis == 1 ? Span{b.lo.y, b.hi.y} : Span{b.lo.z, b.hi.z};
}

/// How many of the boxes share a point: the deepest point may be sought among the low sides of
/// boxes, one axis after the other. Stops at `enough`.
int depth(const std::vector<geometry::Bounds>& boxes, int axis, int enough) {
  if (axis == 3 || static_cast<int>(boxes.size()) < enough) return static_cast<int>(boxes.size());
  int deepest = 0;
  for (const geometry::Bounds& from : boxes) {
    const double place = along(from, axis).lo;
    std::vector<geometry::Bounds> there;
    for (const geometry::Bounds& box : boxes) {
      const Span span = along(box, axis);
      if (span.lo <= place && place <= span.hi) there.push_back(box);
    }
    deepest = std::max(deepest, depth(there, axis + 1, enough));
    if (deepest >= enough) break;
  }
  return deepest;
}

void check_overlap(const std::vector<BoundVolume>& bound, const std::vector<Volume>& given) {
  if (bound.size() <= most_overlapping) return;
  std::vector<geometry::Bounds> boxes;
  for (const BoundVolume& volume : bound) {
    geometry::Bounds box = volume.region.bounds();
    const Vec3 room = 1e-9 * (box.hi - box.lo);  // the rounding of crossings
    boxes.push_back({box.lo - room, box.hi + room});
  }
  if (depth(boxes, 0, most_overlapping + 1) <= most_overlapping) return;
  throw InputError{InputIssue{given.front().where,
                              "the bounds of more than " + std::to_string(most_overlapping) +
                                  " volumes overlap at one place",
                              "put them together in one grid",
                              {}}};
}

}  // namespace

BoundVolumes::BoundVolumes(const std::vector<Volume>& volumes, const spectral::Lanes& lanes)
    : lanes_{lanes.count()} {
  std::vector<InputIssue> issues;
  geometry::Bounds hull = geometry::no_bounds;
  for (const Volume& volume : volumes) {
    try {
      BoundVolume bound{volume, lanes};
      if (bound.is_empty()) continue;
      hull = geometry::merged(hull, bound.region.bounds());
      volumes_.push_back(std::move(bound));
    } catch (const InputError& error) {
      issues.insert(issues.end(), error.issues().begin(), error.issues().end());
    }
  }
  if (!issues.empty()) throw InputError{std::move(issues)};
  check_overlap(volumes_, volumes);
  if (volumes_.size() > 1) {
    const Vec3 room = 1e-9 * (hull.hi - hull.lo);
    hull_.emplace(geometry::Box{hull.lo - room, hull.hi + room}, Affine{});
  }
}

bool BoundVolumes::crossed(const geometry::Ray& ray, double distance) const noexcept {
  if (volumes_.empty()) return false;
  geometry::Ray part = ray;
  part.max_distance = std::min(ray.max_distance, distance);
  if (hull_ && !hull_->crossing(part)) return false;
  return std::any_of(volumes_.begin(), volumes_.end(), [&](const BoundVolume& volume) {
    return volume.region.crossing(part).has_value();
  });
}

}  // namespace nadir::radiometry
