#include "sim/run/check_view.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "sim/run/error_list.hpp"

namespace nadir::sim {
namespace {

// Lines of sight tried along each side of an array: some 10 ms of rays.
constexpr int tried_along_side = 96;

bool meets_a_surface(const World& world, const sensor::DetectorArray& array) {
  const int across = std::min(array.samples, tried_along_side);
  const int down = std::min(array.lines, tried_along_side);
  for (int j = 0; j < down; ++j) {
    for (int i = 0; i < across; ++i) {
      const double sample = (i + 0.5) * array.samples / across;
      const double line = (j + 0.5) * array.lines / down;
      const auto ray = sensor::view_ray(array, world.camera.pose, sample, line);
      if (world.scene.geometry.intersect(ray)) return true;
    }
  }
  return false;
}

/// Whether a corner or the middle of the scene's bounds lies in the array's field of view.
bool bounds_in_view(const World& world, const sensor::DetectorArray& array) {
  const geometry::Bounds box = world.scene.geometry.bounds();
  for (int corner = 0; corner < 9; ++corner) {
    const Vec3 place = corner == 8 ? (box.lo + box.hi) * 0.5
                                   : Vec3{(corner & 1) != 0 ? box.hi.x : box.lo.x,
                                          (corner & 2) != 0 ? box.hi.y : box.lo.y,
                                          (corner & 4) != 0 ? box.hi.z : box.lo.z};
    if (sensor::in_view(array, world.camera.pose, place)) return true;
  }
  return false;
}

void check_array(const World& world, const sensor::DetectorArray& array, Diagnostics& diagnostics) {
  if (meets_a_surface(world, array)) return;
  const std::string message = fmt::format(
      "array {} meets no surface along any line of sight that was tried; does the "
      "camera look the right way?",
      array.name);
  const bool dark_sky = std::holds_alternative<atmosphere::None>(world.scene.atmosphere);
  if (dark_sky && !bounds_in_view(world, array)) throw InputError{message};
  diagnostics.warn(message);
}

}  // namespace

void check_view(const World& world, Diagnostics& diagnostics) {
  ErrorList errors;
  for (const sensor::DetectorArray& array : world.camera.arrays) {
    errors.attempt([&] { check_array(world, array, diagnostics); });
  }
  errors.throw_if_any();
}

}  // namespace nadir::sim
