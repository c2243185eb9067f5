#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "geometry/mesh.hpp"

namespace nadir::sim {

/// The polygons of a Wavefront OBJ file, in the file's own axes and unit (taken as metres).
///
/// Read: `v` (a weight or a colour behind x y z is checked and left), `f` with v, v/vt, v//vn and
/// v/vt/vn, `vt` (its first two numbers; where faces disagree about a vertex it is stored once for
/// each; corners without one have 0 0 if others have some), negative indices, more than three
/// corners (cut as a fan), `usemtl`, `g`, `o`, comments and lines continued by a backslash. The
/// part of a face is named by the last `usemtl`, without one by the last `g` or `o`, else
/// "default". Normal, smoothing and material-file statements are passed over; free-form curves and
/// surfaces are a mistake, as they would be lost. Source of the format: Wavefront Technologies,
/// "Advanced Visualizer manual", appendix B1.
/// @throws InputError with every mistake of the file (20 in full), each with line and column
[[nodiscard]] geometry::TriangleMesh read_obj(const std::filesystem::path& file);

/// The same from text; `name` stands in messages.
[[nodiscard]] geometry::TriangleMesh parse_obj(std::string_view text, const std::string& name);

}  // namespace nadir::sim
