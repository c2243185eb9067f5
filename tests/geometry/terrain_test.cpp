#include "geometry/terrain.hpp"
#include "core/error.hpp"
#include "geometry/scene_helpers.hpp"
#include "support/catch.hpp"

using namespace nadir;
using namespace nadir::geometry;
using namespace nadir::geometry::test;

namespace {

HeightGrid flat_grid(int columns, int rows, double step_deg, double height_m = 0.0) {
  HeightGrid grid{columns, rows, {}};
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i) {
      grid.posts.push_back({36.0 - step_deg * (j - (rows - 1) / 2.0),
                            -84.0 + step_deg * (i - (columns - 1) / 2.0), height_m});
    }
  }
  return grid;
}

double least_up(const TriangleMesh& mesh) {
  double least = 1.0;
  for (const auto& t : mesh.triangles) {
    const Vec3 a = mesh.positions[t[0]];
    least =
        std::min(least, normalised(cross(mesh.positions[t[1]] - a, mesh.positions[t[2]] - a)).z);
  }
  return least;
}

}  // namespace

TEST_CASE("terrain falls away from the tangent plane by d^2 / 2R") {
  const LocalFrame frame{{36.0, -84.0, 0.0}};
  // Radius of curvature along the meridian at 36 degrees: a (1 - e^2) / (1 - e^2 sin^2)^1.5.
  const double s2 = std::pow(std::sin(36.0 * std::numbers::pi / 180.0), 2), e2 = 0.00669437999014;
  const double radius = 6'378'137.0 * (1.0 - e2) / std::pow(1.0 - e2 * s2, 1.5);
  const Scene scene = scene_of(surface(terrain_mesh(flat_grid(5, 401, 0.01), frame)));
  for (const double d : {10e3, 100e3}) {
    for (const double side : {1.0, -1.0}) {
      const auto hit = scene.intersect({{0.0, side * d, 2e4}, {0, 0, -1}});
      REQUIRE(hit);
      const double drop = d * d / (2.0 * radius);
      // Next terms: d^4 / 8R^3 (0.05 m at 100 km) and the change of curvature with latitude,
      // e^2 sin(2 lat) d^3 / 2R^2 (0.08 m); chords of cells of 1.1 km sag by 0.04 m at most.
      CHECK(-hit->position.z ==
            Approx(drop).margin(0.04 + 0.13 * std::pow(d / 100e3, 3)).epsilon(0));
      CHECK(drop == Approx(d == 10e3 ? 7.87 : 787.0).epsilon(0.002));  // what surveyors know
    }
  }
}

TEST_CASE("terrain normals point up whichever way rows and columns run") {
  const LocalFrame frame{{36.0, -84.0, 0.0}};
  HeightGrid grid = flat_grid(5, 4, 0.01);
  for (std::size_t i = 0; i < grid.posts.size(); ++i) grid.posts[i].height_m = 100.0 * (i % 3 == 0);
  CHECK(least_up(terrain_mesh(grid, frame)) > 0.9);
  std::reverse(grid.posts.begin(), grid.posts.end());  // turned by 180 degrees
  CHECK(least_up(terrain_mesh(grid, frame)) > 0.9);
  for (int row = 0; row < grid.rows; ++row) {  // mirrored: east to west
    std::reverse(grid.posts.begin() + 5 * row, grid.posts.begin() + 5 * (row + 1));
  }
  CHECK(least_up(terrain_mesh(grid, frame)) > 0.9);
}

TEST_CASE("terrain crosses the date line") {
  const LocalFrame frame{{-17.0, 180.0, 0.0}};
  const HeightGrid grid{
      2, 2, {{-16.9, 179.9, 5}, {-16.9, -179.9, 5}, {-17.1, 179.9, 5}, {-17.1, -179.9, 5}}};
  const TriangleMesh mesh = terrain_mesh(grid, frame);
  CHECK(least_up(mesh) > 0.9);
  for (const Vec3& p : mesh.positions) CHECK(length(p) < 20e3);
}

TEST_CASE("cells with a missing corner are left out") {
  const LocalFrame frame{{36.0, -84.0, 0.0}};
  HeightGrid grid = flat_grid(4, 4, 0.001, 200.0);
  grid.posts[5].height_m = std::numeric_limits<double>::quiet_NaN();  // inner: corner of 4 cells
  const TriangleMesh mesh = terrain_mesh(grid, frame);
  CHECK(mesh.triangles.size() == 2 * (9 - 4));
  for (const Vec3& p : mesh.positions) CHECK(is_finite(p));
  CHECK(mesh.positions.size() == 12);  // posts 0, 1, 4 and 5 belong to no other cell
  CHECK(mesh.part_names == std::vector<std::string>{"terrain"});
  CHECK(mesh.parts.size() == mesh.triangles.size());
}

TEST_CASE("a terrain grid needs at least one whole cell") {
  const LocalFrame frame{{36.0, -84.0, 0.0}};
  CHECK_THROWS_AS(terrain_mesh(flat_grid(1, 5, 0.01), frame), InputError);
  HeightGrid grid = flat_grid(2, 2, 0.01);
  grid.posts.pop_back();
  CHECK_THROWS_AS(terrain_mesh(grid, frame), InputError);
  grid.posts.push_back({36.0, -84.0, std::numeric_limits<double>::quiet_NaN()});
  CHECK_THROWS_AS(terrain_mesh(grid, frame), InputError);
}
