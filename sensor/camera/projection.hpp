#pragma once

#include <optional>

#include "sensor/camera/path_view.hpp"

namespace nadir::sensor {

/// Where in an array's image a place of the scene appears (nothing in between considered): undoes
/// image_view to 1e-7 pixel. Places outside the image, by at most a tenth of its size, have
/// coordinates too; farther ones, and those behind the camera, none.
/// Where a whiskbroom's sweeps overlap, the earlier one counts; where a place falls between the
/// modules of a staggered array, the nearer one.
[[nodiscard]] std::optional<ImagePoint> image_of(const DetectorArray& array,
                                                 const Platform& platform, Vec3 place);

/// Whether a place in scene axes lies in the array's field of view.
[[nodiscard]] bool in_view(const DetectorArray& array, const Platform& platform, Vec3 place);

}  // namespace nadir::sensor
