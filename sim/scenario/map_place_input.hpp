#pragma once

#include <optional>
#include <variant>

namespace nadir::sim {

/// A rectangle of the ground in scene axes.
struct GroundArea {
  double west_m = 0.0, south_m = 0.0, east_m = 0.0, north_m = 0.0;
};
/// Draped over the ground from above: in the given area, or without one where the raster's own
/// coordinate system puts it.
struct GroundDrape {
  std::optional<GroundArea> area;
};
/// Along a mesh's texture coordinates: the raster's lower left corner is (0, 0).
struct TextureDrape {
  double size_u = 1.0, size_v = 1.0;  ///< texture units that it spans
};
struct MapPlaceInput {
  std::variant<GroundDrape, TextureDrape> drape;
  bool repeats = false;
};

}  // namespace nadir::sim
