#pragma once

#include "sim/products/sensor_sheet.hpp"

namespace nadir::sim {

/// Lengths on the ground and their change, of the middle of an array's image at the middle of its
/// time. NaN where a line of sight misses the ground.
struct SheetGeometry {
  double gsd_x_m = 0.0, gsd_y_m = 0.0, swath_m = 0.0;
  double ground_speed_m_s = 0.0;
  ImageMotion motion;
};

/// Sampling distances are those from pixel centre to pixel centre where samples or lines come by
/// motion, and else the pixel's side. The motion is found by finite differences of where the line
/// of sight meets the ground, 1 ms apart.
[[nodiscard]] SheetGeometry sheet_geometry(const sensor::DetectorArray& array,
                                           const sensor::Platform& platform,
                                           const SheetGround& ground);

}  // namespace nadir::sim
