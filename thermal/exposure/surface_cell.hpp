#pragma once

#include <cstdint>

#include "core/vec.hpp"
#include "geometry/scene.hpp"

namespace nadir::thermal {

/// Into how many pieces a facet is cut so that none is longer than the resolution: a triangle into
/// count^2 triangles alike, the faces of shapes into count x count_v pieces of their parameters.
struct CellGrid {
  std::uint32_t count = 1, count_v = 1;
  bool triangle = true;

  [[nodiscard]] std::uint32_t cells() const noexcept { return count * count_v; }
  /// Number of the piece that holds a place of the facet. For a triangle 2 (row count + column) of
  /// the barycentric grid, less what lies outside: any one-to-one numbering from 0 to cells() - 1.
  [[nodiscard]] std::uint32_t cell_at(Vec2 uv) const noexcept;
  /// A place of the piece: uniform over it for uniform u in [0, 1)^2 (of parameters, for shapes).
  [[nodiscard]] Vec2 place_in(std::uint32_t cell, Vec2 u) const noexcept;
};
/// At most 4096 along an edge.
[[nodiscard]] CellGrid cut(const geometry::FacetSize& size, double resolution_m) noexcept;

/// A piece of one side of a facet: what has one temperature.
struct SurfaceCell {
  const geometry::Scene* scene = nullptr;
  std::uint64_t facet = 0;
  bool back = false;  ///< the side that the facet's normal points away from
  CellGrid grid;
  std::uint32_t cell = 0;

  /// A hit on the piece, as by a ray that came from its side.
  [[nodiscard]] geometry::Hit place(Vec2 u) const;
  /// The same for all of what may be drawn: a key for random numbers.
  [[nodiscard]] std::uint64_t key() const noexcept;
};

/// Many places of one cell. On a flat facet whose parameters run evenly (triangles, planes, boxes)
/// the scene is asked for the cell's corners alone.
class CellPlaces {
 public:
  explicit CellPlaces(const SurfaceCell& cell);

  [[nodiscard]] bool flat() const noexcept { return flat_; }
  /// As SurfaceCell::place: position, normal, side and what follows from the facet. On a flat facet
  /// uv, texture and tangent are those of a corner, and the lift is the corners' largest. Valid
  /// until the next call.
  [[nodiscard]] const geometry::Hit& at(Vec2 u);

 private:
  const SurfaceCell* cell_;
  geometry::Hit flat_hit_, other_hit_;
  Vec3 corner_, along_, across_;
  double edge_ = 0.0;  ///< what of a triangle is nearer to its edges than this goes the general way
  bool flat_ = false;
};

}  // namespace nadir::thermal
