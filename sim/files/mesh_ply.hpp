#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "geometry/mesh.hpp"

namespace nadir::sim {

/// The polygons of a PLY file, in the file's own axes and unit (taken as metres).
///
/// ASCII, binary little endian and binary big endian, version 1.0; `x`, `y`, `z` of the element
/// `vertex` in any scalar type, texture coordinates as `s`, `t`, as `u`, `v` or as `texture_u`,
/// `texture_v` of the vertices, `vertex_indices` or `vertex_index` of the element `face` in any
/// integer types. A temperature of the vertices, as `temperature_k`, `temperature_c` (turned into
/// K) or `temperature` (K), becomes the mesh's vertex_values. Polygons are cut as fans. Other
/// elements and properties are passed over. The one part is named "default". Source of the format:
/// G. Turk, "The PLY Polygon File Format" (1994).
/// @throws InputError with every mistake of the file (20 in full): with line and column in the
///         header and in ASCII data, with the number of the byte in binary data
[[nodiscard]] geometry::TriangleMesh read_ply(const std::filesystem::path& file);

/// The same from bytes; `name` stands in messages.
[[nodiscard]] geometry::TriangleMesh parse_ply(std::string_view bytes, const std::string& name);

}  // namespace nadir::sim
