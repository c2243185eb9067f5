#pragma once

#include <optional>
#include <vector>

#include "core/quaternion.hpp"
#include "sim/products/product_geometry.hpp"

namespace nadir::sim {

/// Columns: the scene's axes in ECEF.
[[nodiscard]] Mat3 scene_axes_ecef(const geometry::LocalFrame& frame);

/// A camera's poses at even steps, ECEF: what readers interpolate with eight-point Lagrange
/// polynomials, of the quaternion's components too.
struct PoseTable {
  double first_s = 0.0, step_s = 0.0;  ///< of the first pose, after the scenario's time
  std::vector<Vec3> positions_m, velocities_m_s;
  std::vector<Quaternion> camera_to_earth;     ///< signs continuous
  std::vector<Vec3> angular_velocities_rad_s;  ///< of the camera, in ECEF axes
  double error_px = 0.0;                       ///< the largest seen of the interpolation

  [[nodiscard]] double last_s() const {
    return first_s + step_s * static_cast<double>(positions_m.size() - 1);
  }
};

/// What a table has to serve.
struct PoseSpan {
  double first_s = 0.0, last_s = 0.0;
  double middle_s = 0.0;   ///< a pose is at this time, and others by whole steps from it
  double pixel_rad = 0.0;  ///< of the camera: what an error of the attitude counts in
  double pixel_m = 0.0;    ///< on the ground: likewise of the position
};

/// The table with the widest step (a power of two, s) that is within a tenth of a thousandth of a
/// pixel, or the finest that is allowed. It goes five steps beyond the span at both ends, where
/// readers would fall back to lower orders.
[[nodiscard]] PoseTable pose_table(const ProductGeometry& geometry, const PoseSpan& span);

/// One pose alone.
[[nodiscard]] PoseTable single_pose(const ProductGeometry& geometry, double time_s);

}  // namespace nadir::sim
