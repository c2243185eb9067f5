#include "sim/run/check_view.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "sensor/camera/projection.hpp"
#include "sim/run/error_list.hpp"

namespace nadir::sim {
namespace {

// Lines of sight tried along each side of an array: some 10 ms of rays.
constexpr int tried_along_side = 96;

struct ViewSeen {
  int surfaces = 0;     ///< lines of sight that meet one
  int from_behind = 0;  ///< that meet one from behind
  bool bounds = false;  ///< whether any enters the scene's bounds
};

/// Whether a line enters a box: the slabs' intervals overlap.
bool enters(const geometry::Bounds& box, const geometry::Ray& ray) {
  double enter = 0.0, leave = std::numeric_limits<double>::infinity();
  const auto slab = [&](double origin, double direction, double lo, double hi) {
    const double a = (lo - origin) / direction, b = (hi - origin) / direction;
    if (std::isnan(a) || std::isnan(b)) return;  // in the plane of a side
    enter = std::max(enter, std::min(a, b));
    leave = std::min(leave, std::max(a, b));
  };
  slab(ray.origin.x, ray.direction.x, box.lo.x, box.hi.x);
  slab(ray.origin.y, ray.direction.y, box.lo.y, box.hi.y);
  slab(ray.origin.z, ray.direction.z, box.lo.z, box.hi.z);
  return enter <= leave;
}

ViewSeen look(const World& world, const sensor::DetectorArray& array) {
  const geometry::Bounds box = world.scene.geometry.bounds();
  ViewSeen seen;
  const int across = std::min(array.samples, tried_along_side);
  const int down = std::min(array.lines, tried_along_side);
  for (int j = 0; j < down; ++j) {
    for (int i = 0; i < across; ++i) {
      const double sample = (i + 0.5) * array.samples / across;
      const double line = (j + 0.5) * array.lines / down;
      const auto ray = sensor::image_view(array, world.camera.platform, {sample, line}).ray;
      const auto hit = world.scene.geometry.intersect(ray);
      seen.surfaces += hit ? 1 : 0;
      seen.from_behind += hit && hit->back_face ? 1 : 0;
      seen.bounds = seen.bounds || enters(box, ray);
    }
  }
  return seen;
}

/// Whether a corner or the middle of the scene's bounds lies in the array's field of view.
bool bounds_in_view(const World& world, const sensor::DetectorArray& array) {
  const geometry::Bounds box = world.scene.geometry.bounds();
  for (int corner = 0; corner < 9; ++corner) {
    const Vec3 place = corner == 8 ? (box.lo + box.hi) * 0.5
                                   : Vec3{(corner & 1) != 0 ? box.hi.x : box.lo.x,
                                          (corner & 2) != 0 ? box.hi.y : box.lo.y,
                                          (corner & 4) != 0 ? box.hi.z : box.lo.z};
    if (sensor::in_view(array, world.camera.platform, place)) return true;
  }
  return false;
}

void check_array(const World& world, const sensor::DetectorArray& array, Diagnostics& diagnostics) {
  const ViewSeen seen = look(world, array);
  if (2 * seen.from_behind > seen.surfaces) {
    diagnostics.warn(
        fmt::format("array {} sees most surfaces from behind; is the camera below the ground or "
                    "inside a body?",
                    array.name));
  }
  if (seen.surfaces > 0) return;
  const std::string message = fmt::format(
      "array {} meets no surface along any line of sight that was tried; does the "
      "camera look the right way?",
      array.name);
  const bool dark_sky =
      !world.air && std::holds_alternative<atmosphere::None>(world.scene.atmosphere);
  if (dark_sky && !seen.bounds && !bounds_in_view(world, array)) throw InputError{message};
  diagnostics.warn(message);
}

}  // namespace

void check_view(const World& world, Diagnostics& diagnostics) {
  ErrorList errors;
  for (const sensor::DetectorArray& array : world.camera.arrays) {
    errors.attempt("camera", world.file.string(), [&] { check_array(world, array, diagnostics); });
  }
  errors.throw_if_any();
}

}  // namespace nadir::sim
