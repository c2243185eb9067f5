#include "sensor/detector_array.hpp"

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

}  // namespace nadir::sensor
