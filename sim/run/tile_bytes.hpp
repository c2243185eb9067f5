#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sim/run/tile_store.hpp"

namespace nadir::sim {

/// Which of the journal's lists of names a tile's truth has: such a list may be as long as the
/// scene has objects, and is the same for all tiles.
struct TileNames {
  std::uint32_t materials = 0, objects = 0;
};
/// Lists of names by number; 0 is the empty list.
using NameLists = std::map<std::uint32_t, std::vector<std::string>>;

/// A tile as bytes (docs/resume.md has the layout): every plane that the render fills, bit by bit.
/// What the detectors make of the radiance is left out, as they count anew in every run.
[[nodiscard]] std::string to_bytes(const TileRecord& record, const TileNames& names);

/// Back again. @return nothing where the bytes are not those of a tile, or a list is missing
[[nodiscard]] std::optional<TileRecord> tile_from_bytes(std::string_view bytes,
                                                        const NameLists& lists);

/// A list of names as bytes, and back.
[[nodiscard]] std::string to_bytes(const std::vector<std::string>& names);
[[nodiscard]] std::optional<std::vector<std::string>> names_from_bytes(std::string_view bytes);

}  // namespace nadir::sim
