#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "geometry/mesh.hpp"

namespace nadir::sim {

/// Texture coordinates of a triangle's corners, counted from 1; 0 where a corner has none.
using CornerTexture = std::array<std::uint32_t, 3>;

/// Gives the mesh one texture coordinate for each position: positions at which triangles disagree
/// (seams) are repeated, with their vertex_values. Corners without coordinates get (0, 0).
/// @param corners  for each triangle of the mesh
void set_texture(geometry::TriangleMesh& mesh, const std::vector<Vec2>& texture,
                 const std::vector<CornerTexture>& corners);

}  // namespace nadir::sim
