#pragma once

#include <cmath>
#include <cstddef>

#include "core/vec.hpp"

namespace nadir::materials {

/// Where a map lies on surfaces: how its columns and rows follow from a point. A map is draped over
/// the ground from above (east, north in m) or follows the texture coordinates of a mesh.
struct MapFrame {
  enum class By { ground, texture };
  By by = By::ground;
  Vec2 origin;           ///< of the outer corner of column 0, row 0; m, or texture units
  Vec2 step{1.0, -1.0};  ///< x from column to column, y from row to row; rows usually run south
  Vec2 lean;  ///< x from row to row, y from column to column: 0 unless the map's axes are turned
  int columns = 0, rows = 0;
  bool repeats = false;  ///< the map tiles the plane; otherwise its edge pixels go on outside

  /// Position in pixels, (0.5, 0.5) at the centre of the first, for (east, north) or (u, v).
  [[nodiscard]] Vec2 pixels(Vec2 at) const noexcept {
    const double dx = at.x - origin.x, dy = at.y - origin.y, d = determinant();
    return {(dx * step.y - dy * lean.x) / d, (dy * step.x - dx * lean.y) / d};
  }

  /// What changes by so much from column to column (x) and from row to row (y): its change along
  /// the axes.
  [[nodiscard]] Vec2 gradient(Vec2 per_pixel) const noexcept {
    const double d = determinant();
    return {(per_pixel.x * step.y - per_pixel.y * lean.y) / d,
            (per_pixel.y * step.x - per_pixel.x * lean.x) / d};
  }

  /// Row-major number of the pixel that holds a position in pixels. Outside the map: that of the
  /// tile, or of the edge. A position that is not finite counts as the first column or row.
  [[nodiscard]] std::size_t pixel_at(Vec2 position) const noexcept {
    const int column = within(position.x, columns), row = within(position.y, rows);
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
           static_cast<std::size_t>(column);
  }

 private:
  [[nodiscard]] double determinant() const noexcept { return step.x * step.y - lean.x * lean.y; }
  [[nodiscard]] int within(double position, int count) const noexcept {
    if (repeats) position -= count * std::floor(position / count);
    if (!(position > 0.0)) return 0;  // NaN too
    return position < count ? static_cast<int>(position) : count - 1;
  }
};

}  // namespace nadir::materials
