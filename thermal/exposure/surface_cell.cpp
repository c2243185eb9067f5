#include "thermal/exposure/surface_cell.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/random.hpp"

namespace nadir::thermal {
namespace {

constexpr double most_pieces = 4096.0;

/// Places keep this share of a piece away from its edges, so that rounding, at most 4096 times
/// 2^-53, cannot take them to the next piece.
constexpr double edge_share = 1e-9;

std::uint32_t pieces_of(double length_m, double resolution_m) {
  const double pieces = std::ceil(length_m / resolution_m);
  return static_cast<std::uint32_t>(std::clamp(pieces, 1.0, most_pieces));
}

/// The piece that x of [0, 1] lies in.
std::uint32_t piece_at(double x, std::uint32_t pieces) {
  const double scaled = std::clamp(x, 0.0, 1.0) * pieces;
  return std::min(static_cast<std::uint32_t>(scaled), pieces - 1);
}

double off_edges(double u) { return edge_share + (1.0 - 3.0 * edge_share) * u; }

/// A triangle is half of [0, 1)^2: the other half is turned onto it.
Vec2 folded(Vec2 u) {
  if (u.x + u.y > 1.0) return {1.0 - u.x, 1.0 - u.y};
  return u;
}

/// Row j of the barycentric grid has 2 (n - j) - 1 pieces, so that rows before it have j (2 n - j).
std::uint32_t before_row(std::uint32_t j, std::uint32_t n) { return j * (2 * n - j); }

std::uint32_t triangle_cell(Vec2 uv, std::uint32_t n) {
  const std::uint32_t j = piece_at(uv.y, n);
  const std::uint32_t i = std::min(piece_at(uv.x, n), n - 1 - j);
  const bool turned = i + j + 2 <= n && uv.x * n - i + (uv.y * n - j) > 1.0;
  return before_row(j, n) + 2 * i + (turned ? 1 : 0);
}

/// n^2 - cell lies in ((n - j - 1)^2, (n - j)^2] for the pieces of row j.
Vec2 triangle_place(std::uint32_t cell, std::uint32_t n, Vec2 u) {
  const double left = std::ceil(std::sqrt(static_cast<double>(n * n - cell)));
  const std::uint32_t j = n - static_cast<std::uint32_t>(left);
  const std::uint32_t in_row = cell - before_row(j, n), i = in_row / 2;
  u = folded(u);
  double x = off_edges(u.x), y = off_edges(u.y);
  if (in_row % 2 == 1) {
    x = 1.0 - x;
    y = 1.0 - y;
  }
  return {(i + x) / n, (j + y) / n};
}

/// Hits this near to a triangle's edge, in its parameters, may be moved inwards (Hit::inset).
/// Twice what the scene calls an edge.
constexpr double near_edge = 2e-6;

/// Curved or turning parameters leave the flat by more at these places, however small the piece: it
/// is 1/4096 of a turn at least, which turns a normal by 5e-4 and bends a disc's ring by 2e-7 of
/// its length. Rounding is 1e-16 of the scene.
constexpr std::array<Vec2, 2> inside_places{Vec2{0.3, 0.7}, Vec2{0.6, 0.2}};
constexpr double flat_to = 1e-9;

}  // namespace

std::uint32_t CellGrid::cell_at(Vec2 uv) const noexcept {
  if (triangle) return triangle_cell(uv, count);
  return piece_at(uv.y, count_v) * count + piece_at(uv.x, count);
}

Vec2 CellGrid::place_in(std::uint32_t cell, Vec2 u) const noexcept {
  if (triangle) return triangle_place(cell, count, u);
  const std::uint32_t row = cell / count, column = cell % count;
  return {(column + off_edges(u.x)) / count, (row + off_edges(u.y)) / count_v};
}

CellGrid cut(const geometry::FacetSize& size, double resolution_m) noexcept {
  const std::uint32_t along_u = pieces_of(size.u_m, resolution_m);
  if (size.triangle) return {along_u, along_u, true};
  return {along_u, pieces_of(size.v_m, resolution_m), false};
}

geometry::Hit SurfaceCell::place(Vec2 u) const {
  return scene->on_facet(facet, grid.place_in(cell, u), back);
}

CellPlaces::CellPlaces(const SurfaceCell& cell) : cell_{&cell} {
  const bool triangle = cell.grid.triangle;
  flat_hit_ = cell.place({0.0, 0.0});
  corner_ = flat_hit_.position;
  const geometry::Hit u_corner = cell.place({1.0, 0.0}), v_corner = cell.place({0.0, 1.0});
  along_ = u_corner.position - corner_;
  across_ = v_corner.position - corner_;
  flat_hit_.inset = {};
  // The lift grows with the largest coordinate: nowhere on the piece is it larger than at a corner.
  flat_hit_.lift = std::max({flat_hit_.lift, u_corner.lift, v_corner.lift});
  flat_ = true;
  if (triangle) {
    edge_ = near_edge * cell.grid.count;
    return;
  }
  flat_hit_.lift = std::max(flat_hit_.lift, cell.place({1.0, 1.0}).lift);
  const double size = length(along_) + length(across_);
  for (const Vec2 u : inside_places) {
    const geometry::Hit hit = cell.place(u);
    const Vec3 off = hit.position - (corner_ + u.x * along_ + u.y * across_);
    flat_ =
        flat_ && length(off) <= flat_to * size && length(hit.normal - flat_hit_.normal) <= flat_to;
  }
}

const geometry::Hit& CellPlaces::at(Vec2 u) {
  const Vec2 to = cell_->grid.triangle ? folded(u) : u;
  if (!flat_ || (cell_->grid.triangle && std::min({to.x, to.y, 1.0 - to.x - to.y}) < edge_)) {
    other_hit_ = cell_->place(u);
    return other_hit_;
  }
  flat_hit_.position = corner_ + to.x * along_ + to.y * across_;
  return flat_hit_;
}

std::uint64_t SurfaceCell::key() const noexcept { return mix(mix(facet, back ? 1 : 0), cell); }

}  // namespace nadir::thermal
