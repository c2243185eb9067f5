#include "sim/products/sheet_geometry.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sensor/camera/path_view.hpp"

namespace nadir::sim {
namespace {

constexpr double no_length = std::numeric_limits<double>::quiet_NaN();
constexpr Vec3 nowhere{no_length, no_length, no_length};

/// The ellipsoid of WGS84 (NIMA TR8350.2), both axes longer by the ground's height: within
/// f^2 h / 2, 6e-6 of the height, of the surface of constant height.
class GroundEllipsoid {
 public:
  GroundEllipsoid(const geometry::LocalFrame& frame, double ground_height_m)
      : frame_{frame},
        equator_m_{6378137.0 + ground_height_m},
        pole_m_{6356752.314245179 + ground_height_m} {}

  /// Where the ray meets it first, ECEF; NaN where it does not.
  [[nodiscard]] Vec3 meet(const geometry::Ray& ray) const {
    const Vec3 origin = frame_.ecef(ray.origin);
    const Vec3 direction = frame_.ecef(ray.origin + ray.direction) - origin;
    const Vec3 o = round(origin), d = round(direction);
    // |o + t d|^2 = 1; q keeps its digits, the distance is the lesser root.
    const double a = dot(d, d), b = dot(o, d), c = dot(o, o) - 1.0;
    const double discriminant = b * b - a * c;
    if (discriminant < 0.0 || b >= 0.0 || c < 0.0) return nowhere;
    const double t = c / (std::sqrt(discriminant) - b);
    return origin + direction * t;
  }

 private:
  [[nodiscard]] Vec3 round(Vec3 v) const {
    return {v.x / equator_m_, v.y / equator_m_, v.z / pole_m_};
  }
  geometry::LocalFrame frame_;
  double equator_m_, pole_m_;
};

/// The array's detectors, all at one moment: where lines or samples come by motion, those of one.
sensor::DetectorArray snapshot(const sensor::DetectorArray& array, double time_s) {
  sensor::DetectorArray still = array;
  still.bands.clear();
  still.modules.clear();  // their stagger would count as ground between two samples
  if (std::holds_alternative<sensor::Pushbroom>(array.timing.scan)) still.lines = 1;
  if (const auto* broom = std::get_if<sensor::Whiskbroom>(&array.timing.scan)) {
    still.samples = 1;
    still.lines = broom->lines_per_scan;
  }
  still.timing = {};
  still.timing.scan = sensor::GlobalShutter{time_s};
  return still;
}

class SheetView {
 public:
  SheetView(const sensor::Platform& platform, const GroundEllipsoid& ground)
      : platform_{platform}, ground_{ground} {}

  [[nodiscard]] Vec3 seen(const sensor::DetectorArray& array, sensor::ImagePoint image) const {
    return ground_.meet(sensor::image_view(array, platform_, image).ray);
  }

 private:
  const sensor::Platform& platform_;
  const GroundEllipsoid& ground_;
};

sensor::ImagePoint middle_of(const sensor::DetectorArray& array) {
  return {0.5 * array.samples, 0.5 * array.lines};
}

/// A pixel's sides on the ground, and the speed of what it looks at.
struct Footprint {
  Vec3 x, y;
  Vec3 velocity;
};

/// A moment in the middle of the image at which the detectors look at the ground.
double middle_time(const sensor::DetectorArray& array) {
  if (const auto* broom = std::get_if<sensor::Whiskbroom>(&array.timing.scan)) {
    // The middle of a sweep: between sweeps a mirror looks elsewhere.
    const int sweeps = array.lines / broom->lines_per_scan;
    return broom->first_sample_s + (sweeps / 2) * broom->scan_period_s +
           0.5 * (array.samples - 1) * broom->sample_period_s;
  }
  const sensor::TimeSpan all = span(array.timing, array.samples, array.lines);
  return 0.5 * (all.first_s + all.last_s);
}

Footprint footprint_of(const sensor::DetectorArray& array, const sensor::Platform& platform,
                       const SheetView& view) {
  const double time_s = middle_time(array);
  const sensor::DetectorArray still = snapshot(array, time_s);
  const sensor::ImagePoint m = middle_of(still);
  Footprint found;
  found.x = view.seen(still, {m.sample + 0.5, m.line}) - view.seen(still, {m.sample - 0.5, m.line});
  found.y = view.seen(still, {m.sample, m.line + 0.5}) - view.seen(still, {m.sample, m.line - 0.5});
  if (platform.is_fixed()) return found;
  constexpr double half_step_s = 0.5e-3;
  const double before = std::max(time_s - half_step_s, platform.first_s());
  const double after = std::min(time_s + half_step_s, platform.last_s());
  if (!(after > before)) return found;
  found.velocity = (view.seen(snapshot(array, after), m) - view.seen(snapshot(array, before), m)) *
                   (1.0 / (after - before));
  return found;
}

/// Components of a velocity along the sides of a pixel, in sides: least squares in three
/// dimensions.
ImageMotion along_sides(const Footprint& f) {
  const double xx = dot(f.x, f.x), xy = dot(f.x, f.y), yy = dot(f.y, f.y);
  const double vx = dot(f.velocity, f.x), vy = dot(f.velocity, f.y);
  const double determinant = xx * yy - xy * xy;
  return {(vx * yy - vy * xy) / determinant, (vy * xx - vx * xy) / determinant};
}

/// Length of what a row of pixels sees, edge to edge, following the ground.
double swath_of(const sensor::DetectorArray& array, const SheetView& view, double pixel_m) {
  const bool swept = std::holds_alternative<sensor::Whiskbroom>(array.timing.scan);
  const sensor::DetectorArray still = swept ? array : snapshot(array, middle_time(array));
  // A sweep is asked for pixel centres: between them the image jumps by a detector.
  const double inset = swept ? 0.5 : 0.0,
               line = std::floor(0.5 * still.lines) + (swept ? 0.5 : 0.0);
  constexpr int pieces = 64;
  double swath_m = 0.0;
  Vec3 last = view.seen(still, {inset, line});
  for (int i = 1; i <= pieces; ++i) {
    double sample = inset + (array.samples - 2.0 * inset) * i / pieces;
    if (swept) sample = std::floor(sample) + 0.5;
    sample = std::min(sample, array.samples - inset);
    const Vec3 next = view.seen(still, {sample, line});
    swath_m += length(next - last);
    last = next;
  }
  const double least = pixel_m * array.samples;
  if (!swept) return swath_m;
  return swath_m > 0.0 ? swath_m + pixel_m : least;  // a mirror that does not move: what it samples
}

/// Samples and lines that come by motion are as far apart as the ground moves between them.
void set_sampling(const sensor::DetectorArray& array, const Footprint& f, SheetGeometry& found) {
  found.gsd_x_m = length(f.x);
  found.gsd_y_m = length(f.y);
  if (const auto* broom = std::get_if<sensor::Whiskbroom>(&array.timing.scan)) {
    const double moved = std::abs(found.motion.x_px_s) * broom->sample_period_s;
    if (moved > 0.0) found.gsd_x_m *= moved;
  } else if (const auto* push = std::get_if<sensor::Pushbroom>(&array.timing.scan)) {
    const double moved = std::abs(found.motion.y_px_s) * push->line_period_s;
    if (moved > 0.0) found.gsd_y_m *= moved;
  }
}

}  // namespace

SheetGeometry sheet_geometry(const sensor::DetectorArray& array, const sensor::Platform& platform,
                             const SheetGround& ground) {
  const Vec3 camera = platform.steady(middle_time(array)).position;
  const double camera_height_m = ground.frame.geodetic(camera).height_m;
  const GroundEllipsoid ellipsoid{ground.frame, camera_height_m - ground.height_m};
  const SheetView view{platform, ellipsoid};
  Footprint footprint = footprint_of(array, platform, view);
  const auto* push = std::get_if<sensor::Pushbroom>(&array.timing.scan);
  if (platform.is_fixed()) {
    const double matched = push != nullptr ? length(footprint.y) / push->line_period_s : 0.0;
    const double speed = ground.ground_speed_m_s > 0.0 ? ground.ground_speed_m_s : matched;
    footprint.velocity = footprint.y * (speed / length(footprint.y));
  }
  SheetGeometry found;
  found.motion = along_sides(footprint);
  found.ground_speed_m_s = length(footprint.velocity);
  set_sampling(array, footprint, found);
  found.swath_m = swath_of(array, view, found.gsd_x_m);
  return found;
}

}  // namespace nadir::sim
