#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "radiometry/volumes/volume.hpp"

namespace nadir::sim {

/// A grid of non-negative numbers from an NRRD file with an attached header: dimension 3, encoding
/// raw, little endian, type float, double, uint8 or uint16 under any of the format's names. The
/// first axis of the file is the grid's x. Where the grid lies is the scenario's to say: the file's
/// spacings, origin, space, units and the like are passed over.
///
/// Compressed, textual, big-endian and detached data are mistakes that say so.
/// Source of the format: Kindlmann, "Definition of NRRD File Format",
/// https://teem.sourceforge.net/nrrd/format.html.
/// @throws InputError with every mistake of the header (with line and column), or for data that is
///         too short, too long, negative or not finite
[[nodiscard]] radiometry::ScalarGrid read_grid(const std::filesystem::path& file);

/// The same from bytes; `name` stands in messages.
[[nodiscard]] radiometry::ScalarGrid parse_grid(std::string_view bytes, const std::string& name);

}  // namespace nadir::sim
