#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "core/vec.hpp"

namespace nadir::sensor {

/// Lines of sight measured pixel by pixel, in camera axes: of the centres of pixels on a grid of
/// every n-th sample and line (the last row and column included), bilinear between.
struct ViewTable {
  int samples = 0, lines = 0;                 ///< of the grid, at least 2 x 1
  double sample_step = 1.0, line_step = 1.0;  ///< pixels from node to node; node 0 at (0.5, 0.5)
  std::vector<Vec3> directions;               ///< row-major, unit
};

/// Unit line of sight at a place of the image; beyond the outermost nodes the outermost cells go
/// on. A table of one line has no y of its own: places off its middle, y = 0.5, lie square to it,
/// in steps as wide as those from sample to sample.
[[nodiscard]] Vec3 direction(const ViewTable& table, Vec2 image) noexcept;

/// The place of the image that looks along a unit direction: undoes `direction` to 1e-9 pixel.
/// None where it finds none: behind, or beyond where the outermost cells can go on.
[[nodiscard]] std::optional<Vec2> place_of(const ViewTable& table, Vec3 towards);

/// @throws InputError for sizes that do not fit, directions that are not finite or of no length,
///         neighbours more than 10 degrees apart
[[nodiscard]] std::shared_ptr<const ViewTable> checked(ViewTable table);

}  // namespace nadir::sensor
