#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "core/vec.hpp"

namespace nadir::geometry {

/// A triangle mesh as plain data. Coordinates in metres, in whatever axes its owner states.
struct TriangleMesh {
  std::vector<Vec3> positions;
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< indices into positions
  std::vector<Vec2> texture;  ///< one for each position, or empty; a seam repeats its positions
  std::vector<std::uint32_t> parts;     ///< for each triangle an index into part_names
  std::vector<std::string> part_names;  ///< as in the file (OBJ: usemtl)
  /// One for each position, or empty: any quantity (Scene::vertex_value).
  std::vector<float> vertex_values{};
};

}  // namespace nadir::geometry
