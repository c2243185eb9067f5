#include "sensor/camera/detector_array.hpp"

namespace nadir::sensor {

geometry::Ray view_ray(const DetectorArray& array, const Pose& pose, double sample,
                       double line) noexcept {
  const double x = array.offset_x_m + (sample - 0.5 * array.samples) * array.pitch_m;
  const double y = array.offset_y_m + (line - 0.5 * array.lines) * array.pitch_m;
  if (const auto* lens = std::get_if<Perspective>(&array.projection)) {
    const Vec3 direction = pose.axes * Vec3{x, y, lens->focal_length_m};
    return {pose.position, normalised(direction)};
  }
  return {pose.position + pose.axes * Vec3{x, y, 0.0}, pose.axes.z};
}

bool in_view(const DetectorArray& array, const Pose& pose, Vec3 place) noexcept {
  const Vec3 seen = pose.axes.transposed() * (place - pose.position);  // camera axes
  if (seen.z <= 0.0) return false;
  const auto* lens = std::get_if<Perspective>(&array.projection);
  const double scale = lens != nullptr ? lens->focal_length_m / seen.z : 1.0;
  const double sample = (seen.x * scale - array.offset_x_m) / array.pitch_m + 0.5 * array.samples;
  const double line = (seen.y * scale - array.offset_y_m) / array.pitch_m + 0.5 * array.lines;
  return sample >= 0.0 && sample <= array.samples && line >= 0.0 && line <= array.lines;
}

}  // namespace nadir::sensor
