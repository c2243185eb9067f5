#pragma once

#include "core/sampler.hpp"
#include "sensor/camera/detector_array.hpp"
#include "sensor/platform/platform.hpp"

namespace nadir::sensor {

/// Where a path leaves the camera, and when.
struct PathView {
  geometry::Ray ray;
  double time_s = 0.0;
  PointSpread::Draw spread{};  ///< for the weights of the bands
};

/// Draws one path of a pixel: a point of the detector's sensitive area, a displacement by the
/// point-spread function, a moment of the exposure (and of the detector's lag), a row of the
/// time-delay integration, a shake of the camera. What the camera has not costs nothing.
/// @param numbers  its points 0 and up to `path_dimensions` are used
[[nodiscard]] PathView path_view(const DetectorArray& array, const Platform& platform, int sample,
                                 int line, const Sampler& numbers) noexcept;
inline constexpr std::uint32_t path_dimensions = 16;

/// Continuous image coordinates: (0.5, 0.5) is the centre of the first pixel; samples count to the
/// right, lines down. A pushbroom's line counts time: k + 0.5 is the centre of exposure k.
struct ImagePoint {
  double sample = 0.0, line = 0.0;
};

/// The moment that belongs to a place of the image: its exposure's centre.
[[nodiscard]] double image_time_s(const DetectorArray& array, ImagePoint image) noexcept;

/// The line of sight that belongs to a place of the image at its moment, without blur or shaking.
[[nodiscard]] PathView image_view(const DetectorArray& array, const Platform& platform,
                                  ImagePoint image) noexcept;

}  // namespace nadir::sensor
