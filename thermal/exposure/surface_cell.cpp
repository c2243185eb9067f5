#include "thermal/exposure/surface_cell.hpp"

#include <algorithm>
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
  if (u.x + u.y > 1.0) u = {1.0 - u.x, 1.0 - u.y};
  double x = off_edges(u.x), y = off_edges(u.y);
  if (in_row % 2 == 1) {
    x = 1.0 - x;
    y = 1.0 - y;
  }
  return {(i + x) / n, (j + y) / n};
}

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

std::uint64_t SurfaceCell::key() const noexcept { return mix(mix(facet, back ? 1 : 0), cell); }

}  // namespace nadir::thermal
