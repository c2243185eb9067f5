#pragma once

#include <string>
#include <variant>
#include <vector>

#include "geometry/scene.hpp"
#include "sensor/pose.hpp"
#include "spectral/response.hpp"

namespace nadir::sensor {

/// A central projection. Lengths on the focal plane, whose origin is the principal point.
struct Perspective {
  double focal_length_m = 0.0;  ///< > 0
};
/// Parallel lines of sight; the focal plane is a window at the camera's position, at scale 1.
struct Orthographic {};

using Projection = std::variant<Perspective, Orthographic>;

/// A spectral band of an array: its name and relative spectral response.
struct Band {
  std::string name;
  spectral::Response response;
};

/// A framing detector array: all its pixels see the scene at the same time, in all its bands.
struct DetectorArray {
  std::string name;
  int samples = 0;  ///< columns, > 0
  int lines = 0;    ///< rows, > 0
  Projection projection;
  double pitch_m = 0.0;     ///< pixel centre to pixel centre on the focal plane, > 0
  double offset_x_m = 0.0;  ///< of the array's centre from the principal point, towards image right
  double offset_y_m = 0.0;  ///< the same, towards image down
  std::vector<Band> bands;
};

/// The line of sight through a point of the image. (0.5, 0.5) is the centre of the first pixel;
/// samples count to the right, lines count down.
[[nodiscard]] geometry::Ray view_ray(const DetectorArray& array, const Pose& pose, double sample,
                                     double line) noexcept;

/// Whether a place in scene axes lies in the array's field of view (nothing in between considered).
[[nodiscard]] bool in_view(const DetectorArray& array, const Pose& pose, Vec3 place) noexcept;

}  // namespace nadir::sensor
