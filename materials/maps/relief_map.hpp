#pragma once

#include <vector>

#include "core/vec.hpp"
#include "materials/maps/map_frame.hpp"

namespace nadir::materials {

/// Bumps too fine for the mesh: slopes of the surface over its two axes, interpolated bilinearly.
/// A height raster is turned into slopes when it is read; a normal map holds them as it is.
/// The axes are east and north for a map that is draped over the ground, growing u and v for one
/// that follows texture coordinates.
struct ReliefMap {
  MapFrame frame;
  std::vector<Vec2> slope;  ///< dz/dx, dz/dy along the local frame's x and y, row-major

  /// Unit normal in the local frame (z along the smooth surface's normal).
  [[nodiscard]] Vec3 normal_at(Vec2 place) const noexcept;
};

/// Slopes of a raster of heights, row-major: central differences, one-sided at the edges of a map
/// that does not repeat. Exact for planes, and inside for paraboloids.
/// @param heights   in the unit of the frame's steps, finite
/// @param strength  factor on the slopes, 1
/// @throws InputError unless there is one height a pixel
[[nodiscard]] std::vector<Vec2> slopes_of_heights(const MapFrame& frame,
                                                  const std::vector<double>& heights,
                                                  double strength);

/// The slopes of a surface with that normal (z > 0, of any length).
[[nodiscard]] Vec2 slope_of_normal(Vec3 normal, double strength);

}  // namespace nadir::materials
