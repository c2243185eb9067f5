#include "sensor/camera/path_view.hpp"

#include <algorithm>
#include <cmath>

#include "core/normal_pair.hpp"
#include "sensor/camera/focal_plane.hpp"

namespace nadir::sensor {
namespace {

// What the random numbers of a path serve. The pixel's area comes first: so a plain camera draws
// what it always drew.
struct PathNumber {
  static constexpr std::uint32_t area = 0, moment = 1, age = 2, stage = 3, spread = 4,
                                 shake_xy = spread + PointSpread::dimensions,
                                 shake_z = shake_xy + 1;
};
static_assert(PathNumber::shake_z < path_dimensions);

// A place among the detectors and the centre of its exposure.
struct Exposed {
  DetectorPlace place;
  double time_s = 0.0;
};

double row_of_frame(const DetectorArray& array, double line) noexcept {
  return (line - 0.5 * array.lines) * array.height_m();
}

// Where in its sweep a line of a whiskbroom's image is seen.
struct Sweep {
  double start_s = 0.0;  // centre of the exposure of its sample 0
  double row = 0.0;      // from the column's upper end, in pixels
};

Sweep sweep_of(const Whiskbroom& broom, double line) noexcept {
  const double scan = std::floor(line / broom.lines_per_scan);
  return {broom.first_sample_s + scan * broom.scan_period_s, line - scan * broom.lines_per_scan};
}

/// @param inside  of the pixel, from its upper left corner, in [0, 1)
Exposed exposed(const DetectorArray& array, int sample, int line, Vec2 inside) noexcept {
  const auto& scan = array.timing.scan;
  const double column = sample + inside.x;
  if (const auto* broom = std::get_if<Pushbroom>(&scan)) {
    return {{column, (inside.y - 0.5) * array.height_m()},
            broom->first_line_s + line * broom->line_period_s};
  }
  if (const auto* broom = std::get_if<Whiskbroom>(&scan)) {
    const Sweep sweep = sweep_of(*broom, line);
    return {{0.5 * array.samples + (inside.x - 0.5),
             (sweep.row + inside.y - 0.5 * broom->lines_per_scan) * array.height_m()},
            sweep.start_s + sample * broom->sample_period_s};
  }
  const DetectorPlace place{column, row_of_frame(array, line + inside.y)};
  if (const auto* shutter = std::get_if<RollingShutter>(&scan)) {
    return {place, shutter->first_line_s + line * shutter->line_period_s};
  }
  return {place, std::get<GlobalShutter>(scan).centre_s};
}

// The middle of the sensitive area at a place of the image, and its moment.
Exposed exposed(const DetectorArray& array, ImagePoint image) noexcept {
  const auto& scan = array.timing.scan;
  if (const auto* broom = std::get_if<Pushbroom>(&scan)) {
    return {{image.sample, 0.0}, broom->first_line_s + (image.line - 0.5) * broom->line_period_s};
  }
  if (const auto* broom = std::get_if<Whiskbroom>(&scan)) {
    const Sweep sweep = sweep_of(*broom, image.line);
    return {{0.5 * array.samples, (sweep.row - 0.5 * broom->lines_per_scan) * array.height_m()},
            sweep.start_s + (image.sample - 0.5) * broom->sample_period_s};
  }
  const DetectorPlace place{image.sample, row_of_frame(array, image.line)};
  if (const auto* shutter = std::get_if<RollingShutter>(&scan)) {
    return {place, shutter->first_line_s + (image.line - 0.5) * shutter->line_period_s};
  }
  return {place, std::get<GlobalShutter>(scan).centre_s};
}

// The sensitive part of the pixel: the whole of it stays as it was drawn, to the bit.
Vec2 sensitive(const DetectorArray& array, Vec2 inside) noexcept {
  if (array.fill_x != 1.0) inside.x = 0.5 + (inside.x - 0.5) * array.fill_x;
  if (array.fill_y != 1.0) inside.y = 0.5 + (inside.y - 0.5) * array.fill_y;
  return inside;
}

// A row of the time-delay integration: those that lie ahead see the ground before.
void draw_stage(const DetectorArray& array, const Sampler& numbers, Exposed& at) noexcept {
  const Timing& timing = array.timing;
  const auto* broom = std::get_if<Pushbroom>(&timing.scan);
  if (timing.still || timing.tdi_stages <= 1 || broom == nullptr) return;
  const double drawn = std::floor(numbers.number(PathNumber::stage) * timing.tdi_stages);
  const double ahead = drawn - 0.5 * (timing.tdi_stages - 1);
  at.place.row_m += (timing.tdi_reversed ? -ahead : ahead) * array.height_m();
  at.time_s -= ahead * broom->line_period_s;
}

// A moment of the exposure about its centre, or of the detector's memory before it is read.
void draw_moment(const Timing& timing, const Sampler& numbers, Exposed& at) noexcept {
  if (timing.still) return;
  if (timing.exposure_s > 0.0)
    at.time_s += (numbers.number(PathNumber::moment) - 0.5) * timing.exposure_s;
  if (timing.lag_s > 0.0) {
    // Exponential by inversion; the number is below 1, so that the logarithm is finite.
    const double age = std::min(-std::log1p(-numbers.number(PathNumber::age)), most_lags);
    at.time_s -= age * timing.lag_s;
  }
}

Pose shaken_pose(const Platform& platform, double time_s, const Sampler& numbers) noexcept {
  const Vec2 xy = normal_pair(numbers.point(PathNumber::shake_xy));
  return platform.shaken(time_s, {xy.x, xy.y, normal_pair(numbers.point(PathNumber::shake_z)).x});
}

geometry::Ray ray_from(const DetectorArray& array, const Pose& pose, Vec2 focal_m) noexcept {
  if (std::holds_alternative<Orthographic>(array.projection)) {
    return {pose.position + pose.axes * Vec3{focal_m.x, focal_m.y, 0.0}, pose.axes.z};
  }
  return {pose.position, normalised(pose.axes * sight(array, focal_m))};
}

}  // namespace

PathView path_view(const DetectorArray& array, const Platform& platform, int sample, int line,
                   const Sampler& numbers) noexcept {
  Exposed at = exposed(array, sample, line, sensitive(array, numbers.point(PathNumber::area)));
  draw_stage(array, numbers, at);
  draw_moment(array.timing, numbers, at);
  const Module* module = array.modules.empty() ? nullptr : module_of(array, sample);
  Vec2 focal = focal_place(array, module, at.place);
  PointSpread::Draw spread{};
  if (array.spread != nullptr) {
    spread = array.spread->draw(numbers, PathNumber::spread);
    focal.x += spread.displacement_m.x;
    focal.y += spread.displacement_m.y;
  }
  // Built where the caller wants it: copying rays costs as much as computing them.
  if (platform.has_white_jitter() && !array.timing.still) {
    return {ray_from(array, shaken_pose(platform, at.time_s, numbers), focal), at.time_s, spread};
  }
  return {ray_from(array, platform.at(at.time_s), focal), at.time_s, spread};
}

double image_time_s(const DetectorArray& array, ImagePoint image) noexcept {
  return exposed(array, image).time_s;
}

PathView image_view(const DetectorArray& array, const Platform& platform,
                    ImagePoint image) noexcept {
  const Exposed at = exposed(array, image);
  const Vec2 focal = focal_place(array, module_of(array, at.place.column), at.place);
  return {ray_from(array, platform.steady(at.time_s), focal), at.time_s};
}

}  // namespace nadir::sensor
