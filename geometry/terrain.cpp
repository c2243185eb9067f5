#include "geometry/terrain.hpp"

#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "core/error.hpp"

namespace nadir::geometry {
namespace {

using Quad = std::array<std::uint32_t, 4>;  ///< corners of a cell in turn, as numbers of posts

bool is_there(const Geodetic& post) {
  return std::isfinite(post.latitude_deg) && std::isfinite(post.longitude_deg) &&
         std::isfinite(post.height_m);
}

void check_size(const HeightGrid& grid) {
  if (grid.columns < 2 || grid.rows < 2) {
    throw InputError{"a terrain grid needs at least 2 x 2 posts, this one has " +
                     std::to_string(grid.columns) + " x " + std::to_string(grid.rows)};
  }
  const auto posts = static_cast<std::size_t>(grid.columns) * static_cast<std::size_t>(grid.rows);
  if (grid.posts.size() != posts || posts > std::numeric_limits<std::uint32_t>::max()) {
    throw InputError{"a terrain grid of " + std::to_string(grid.columns) + " x " +
                     std::to_string(grid.rows) + " posts holds " +
                     std::to_string(grid.posts.size())};
  }
}

std::vector<Quad> complete_cells(const HeightGrid& grid) {
  std::vector<Quad> cells;
  const auto columns = static_cast<std::uint32_t>(grid.columns);
  const auto rows = static_cast<std::uint32_t>(grid.rows);
  for (std::uint32_t row = 0; row + 1 < rows; ++row) {
    for (std::uint32_t column = 0; column + 1 < columns; ++column) {
      const std::uint32_t first = row * columns + column;
      const Quad cell{first, first + columns, first + columns + 1, first + 1};
      bool complete = true;
      for (const std::uint32_t post : cell) complete = complete && is_there(grid.posts[post]);
      if (complete) cells.push_back(cell);
    }
  }
  if (cells.empty()) throw InputError{"the terrain grid has no cell with four known heights"};
  return cells;
}

/// Whether the cells' corners run clockwise seen from above: the sum of their areas as seen from
/// the earth's centre tells, because no height can turn a cell round.
bool runs_clockwise(const std::vector<Quad>& cells, const std::vector<Vec3>& enu,
                    const LocalFrame& frame) {
  const Vec3 earth_centre = frame.enu_from_ecef({});
  double area = 0.0;
  for (const Quad& cell : cells) {
    const Vec3 across = cross(enu[cell[2]] - enu[cell[0]], enu[cell[3]] - enu[cell[1]]);
    area += dot(across, normalised(enu[cell[0]] - earth_centre));
  }
  return area < 0.0;
}

/// Positions of the posts that cells use, and the cells with their new numbers.
std::vector<Vec3> used_positions(const HeightGrid& grid, const LocalFrame& frame,
                                 std::vector<Quad>& cells) {
  constexpr std::uint32_t unused = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> numbers(grid.posts.size(), unused);
  std::vector<Vec3> positions;
  for (Quad& cell : cells) {
    for (std::uint32_t& post : cell) {
      if (numbers[post] == unused) {
        numbers[post] = static_cast<std::uint32_t>(positions.size());
        positions.push_back(frame.enu(grid.posts[post]));
      }
      post = numbers[post];
    }
  }
  return positions;
}

}  // namespace

TriangleMesh terrain_mesh(const HeightGrid& grid, const LocalFrame& frame) {
  check_size(grid);
  std::vector<Quad> cells = complete_cells(grid);
  TriangleMesh mesh;
  mesh.part_names = {"terrain"};
  mesh.positions = used_positions(grid, frame, cells);
  const bool clockwise = runs_clockwise(cells, mesh.positions, frame);
  mesh.triangles.reserve(2 * cells.size());
  for (Quad cell : cells) {
    if (clockwise) std::swap(cell[1], cell[3]);
    mesh.triangles.push_back({cell[0], cell[1], cell[2]});
    mesh.triangles.push_back({cell[0], cell[2], cell[3]});
  }
  mesh.parts.assign(mesh.triangles.size(), 0);
  return mesh;
}

}  // namespace nadir::geometry
