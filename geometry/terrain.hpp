#pragma once

#include <vector>

#include "geometry/earth.hpp"
#include "geometry/mesh.hpp"

namespace nadir::geometry {

/// Heights on a grid of any map projection, its posts already taken to WGS84. Row-major; rows and
/// columns are neighbours on the ground. A NaN height is a hole.
struct HeightGrid {
  int columns = 0, rows = 0;
  std::vector<Geodetic> posts;  ///< columns x rows, heights above the ellipsoid
};

/// The grid as triangles in scene axes, wound so that normals point up: every post goes through
/// ECEF, so the earth's curvature is in the mesh. Cells with a missing corner are left out.
/// @throws InputError for a grid smaller than 2 x 2, or one without any complete cell.
[[nodiscard]] TriangleMesh terrain_mesh(const HeightGrid& grid, const LocalFrame& frame);

}  // namespace nadir::geometry
