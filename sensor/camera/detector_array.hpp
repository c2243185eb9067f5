#pragma once

#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "geometry/scene.hpp"
#include "sensor/camera/distortion.hpp"
#include "sensor/camera/timing.hpp"
#include "sensor/camera/view_table.hpp"
#include "sensor/optics/point_spread.hpp"
#include "sensor/platform/pose.hpp"
#include "spectral/response.hpp"

namespace nadir::sensor {

/// A central projection through a lens. Lengths on the focal plane as seen from behind the camera:
/// x to image right, y to image down, from the place where the optical axis meets it (the principal
/// point).
struct Perspective {
  double focal_length_m = 0.0;  ///< > 0
  Distortion distortion{};
};
/// Parallel lines of sight; the focal plane is a window at the camera's position, at scale 1.
struct Orthographic {};
/// Lines of sight from a table; for pushbrooms of one line.
using Tabulated = std::shared_ptr<const ViewTable>;

using Projection = std::variant<Perspective, Orthographic, Tabulated>;

/// A spectral band of an array: its name and relative spectral response.
struct Band {
  std::string name;
  spectral::Response response;
};

/// A part of an array that was cut and mounted by itself: samples [first_sample, first_sample +
/// samples) displaced from where a perfect array has them, and turned about the part's middle.
struct Module {
  int first_sample = 0, samples = 0;
  double offset_x_m = 0.0, offset_y_m = 0.0;
  double rotation_rad = 0.0;  ///< from x to y
};

/// A detector array. A frame has `lines` rows of detectors; a pushbroom one row (and more for
/// time-delay integration), its image `lines` exposures of it; a whiskbroom a column.
struct DetectorArray {
  std::string name;
  int samples = 0;  ///< columns of the image, > 0
  int lines = 0;    ///< rows of the image, > 0
  Projection projection;
  double pitch_m = 0.0;     ///< pixel centre to pixel centre along x on the focal plane, > 0
  double offset_x_m = 0.0;  ///< of the array's centre from the principal point, towards image right
  double offset_y_m = 0.0;  ///< the same, towards image down
  std::vector<Band> bands;
  double pitch_y_m = 0.0;             ///< along y; 0: as along x
  double fill_x = 1.0, fill_y = 1.0;  ///< the sensitive part of the pitch, in (0, 1]
  Timing timing{};
  std::vector<Module> modules{};                ///< ascending and complete, or none
  std::shared_ptr<const PointSpread> spread{};  ///< null: none

  [[nodiscard]] double height_m() const noexcept { return pitch_y_m > 0.0 ? pitch_y_m : pitch_m; }
};

/// A place on the focal plane, m from the principal point, of a detector place of the image:
/// (0.5, 0.5) is the centre of the first pixel; of a pushbroom's line and a whiskbroom's sample
/// only the part beyond the whole number counts, from its middle.
[[nodiscard]] Vec2 focal_place(const DetectorArray& array, Vec2 image) noexcept;

/// Unit line of sight in camera axes through a place of the focal plane.
[[nodiscard]] Vec3 camera_direction(const DetectorArray& array, Vec2 focal_m) noexcept;

/// @throws InputError for what cannot be: modules that overlap or leave gaps, a distortion that
///         folds within the array's pixels, an exposure longer than the line's period, lag and
///         exposure together, time-delay integration without a pushbroom, a view table of another
///         size, ...
void check(const DetectorArray& array);

/// Arrays that lie side by side on one focal plane (not those behind lenses or filters of their
/// own).
/// @throws InputError where two of them overlap by more than a tenth of a pixel
void check_apart(const std::vector<DetectorArray>& arrays);

}  // namespace nadir::sensor
