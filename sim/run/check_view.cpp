#include "sim/run/check_view.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

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

// ---- motion -------------------------------------------------------------------------------------

/// The detectors of one moment, where lines or samples come by motion.
struct Scanned {
  double time_s = 0.0;    ///< in the image's middle, or in that of a sweep
  double period_s = 0.0;  ///< from line to line, or from sample to sample of a sweep
  int steps = 0;          ///< of them, that should see different ground
  sensor::DetectorArray still{};
  const char* parts = "lines";
  const char* missing = "does the platform move?";
};

std::optional<Scanned> scanned(const sensor::DetectorArray& array) {
  Scanned found;
  found.still = array;
  found.still.modules.clear();  // their stagger would count as ground between two samples
  if (const auto* push = std::get_if<sensor::Pushbroom>(&array.timing.scan)) {
    found.still.lines = 1;
    found.period_s = push->line_period_s;
    found.steps = array.lines - 1;
    found.time_s = push->first_line_s + 0.5 * found.steps * push->line_period_s;
  } else if (const auto* whisk = std::get_if<sensor::Whiskbroom>(&array.timing.scan)) {
    found.still.samples = 1;
    found.still.lines = whisk->lines_per_scan;
    found.period_s = whisk->sample_period_s;
    found.steps = array.samples - 1;
    const int sweeps = array.lines / whisk->lines_per_scan;
    found.time_s = whisk->first_sample_s + (sweeps / 2) * whisk->scan_period_s +
                   0.5 * found.steps * whisk->sample_period_s;
    found.parts = "samples of a sweep";
    found.missing = "does a mount swing it?";
  } else {
    return std::nullopt;
  }
  return found;
}

/// Motion of what the middle detector looks at, along the sides of its pixel, in pixels a period.
/// The ground's image moves the other way.
struct GroundMotion {
  double x = 0.0, y = 0.0;
};

/// Of a place that stands still, where the middle detector looks; nothing where it sees nothing.
/// On any plane through the place a fixed place's image moves alike: that across the line of sight
/// is never seen edge-on.
std::optional<GroundMotion> motion_of(const World& world, Scanned& scan) {
  const sensor::ImagePoint middle{0.5 * scan.still.samples, 0.5 * scan.still.lines};
  const auto view = [&](double time_s, Vec2 off) {
    scan.still.timing.scan = sensor::GlobalShutter{time_s};
    return sensor::image_view(scan.still, world.camera.platform,
                              {middle.sample + off.x, middle.line + off.y})
        .ray;
  };
  const geometry::Ray ray = view(scan.time_s, {});
  const auto hit = world.scene.geometry.intersect(ray);
  if (!hit) return std::nullopt;
  const Vec3 place = ray.origin + ray.direction * hit->distance, normal = ray.direction;
  const auto seen = [&](double time_s, Vec2 off) {
    const geometry::Ray r = view(time_s, off);
    return r.origin + r.direction * (dot(place - r.origin, normal) / dot(r.direction, normal));
  };
  constexpr double part = 0.25;  // of a period, within the platform's span even for one line
  const double step_s = part * scan.period_s, t = scan.time_s;
  const Vec3 side_x = seen(t, {0.5, 0.0}) - seen(t, {-0.5, 0.0});
  const Vec3 side_y = seen(t, {0.0, 0.5}) - seen(t, {0.0, -0.5});
  const Vec3 moved = (seen(t + step_s, {}) - seen(t - step_s, {})) * (0.5 / part);
  // moved = x side_x + y side_y in the plane.
  const double area = dot(cross(side_x, side_y), normal);
  return GroundMotion{dot(cross(moved, side_y), normal) / area,
                      dot(cross(side_x, moved), normal) / area};
}

/// Rows and charge part by |1 - motion| of a row in a period, over all stages.
void check_charge(const sensor::DetectorArray& array, const GroundMotion& motion,
                  Diagnostics& diagnostics) {
  const sensor::Timing& timing = array.timing;
  const double along = timing.tdi_reversed ? -motion.y : motion.y;  // with the charge
  const double smear = timing.tdi_stages * std::abs(1.0 - along);
  if (timing.tdi_stages <= 1 || smear <= 1.0) return;
  const std::string advice =
      along < 0.0 ? "it moves against the charge: tdi_direction should be the other one"
                  : "line_period_ms should fit speed and height";
  diagnostics.warn(
      fmt::format("array {}: the charge of its {} stages does not follow the ground, whose image "
                  "moves by {:.3g} rows in a line period with it: a blur of {:.3g} rows; {}",
                  array.name, timing.tdi_stages, along, smear, advice));
}

void check_motion(const World& world, const sensor::DetectorArray& array,
                  Diagnostics& diagnostics) {
  auto scan = scanned(array);
  if (!scan) return;
  const auto motion =
      world.camera.platform.is_fixed() ? std::optional{GroundMotion{}} : motion_of(world, *scan);
  if (!motion) return;
  constexpr double least = 0.1;  // pixels over all lines or samples
  // A mirror has to move the line of sight along the samples, whatever the platform does.
  const bool whisk = std::holds_alternative<sensor::Whiskbroom>(array.timing.scan);
  const double moved = std::abs(motion->x) + (whisk ? 0.0 : std::abs(motion->y));
  if (scan->steps > 0 && moved * scan->steps < least) {
    diagnostics.warn(fmt::format("array {}: all {} see the same ground; {}", array.name,
                                 scan->parts, scan->missing));
    return;
  }
  check_charge(array, *motion, diagnostics);
}

// ---- what is seen -------------------------------------------------------------------------------

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
    errors.attempt("camera", world.file.string(), [&] {
      check_array(world, array, diagnostics);
      check_motion(world, array, diagnostics);
    });
  }
  errors.throw_if_any();
}

}  // namespace nadir::sim
