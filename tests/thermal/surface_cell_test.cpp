#include "thermal/exposure/surface_cell.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include "core/random.hpp"
#include "core/transform.hpp"
#include "geometry/scene_builder.hpp"
#include "support/catch.hpp"

using namespace nadir;
using namespace nadir::thermal;

namespace {

/// The corners of [0, 1)^2 and what lies about its diagonal, where triangles fold it, and inside.
std::vector<Vec2> corner_cases() {
  const double last = 1.0 - 0x1.0p-53;
  std::vector<Vec2> u{{0, 0}, {last, 0}, {0, last}, {last, last}, {0.5, 0.5}, {0.25, 0.75}};
  Rng rng{5};
  for (int i = 0; i < 20; ++i) u.push_back({rng.next(), rng.next()});
  return u;
}

geometry::Scene ground_triangle() {
  geometry::TriangleMesh mesh;
  mesh.positions = {{0, 0, 0}, {8, 0, 0}, {1, 6, 0}};
  mesh.triangles = {{0, 1, 2}};
  geometry::SceneBuilder builder;
  builder.add({mesh, {3}}, {}, 0);
  return builder.build();
}

constexpr std::uint32_t even = 1, uneven = 2;

/// Of each kind one, at the scene's corner and as instances that are turned, mirrored, stretched.
geometry::Scene all_kinds() {
  geometry::TriangleMesh mesh;
  mesh.positions = {{0, 0, 0}, {8, 0, 1}, {1, 6, 0}, {2, 2, 5}};
  mesh.triangles = {{0, 1, 2}, {0, 3, 1}};
  const std::vector<geometry::Surface> kinds{
      {mesh, {even}},
      {geometry::Plane{{1, 2, 3}, 4.0, 9.0}, {even}},
      {geometry::Box{{-1, -2, 0}, {1, 3, 4}}, {even}},
      {geometry::Sphere{{3, 1, 1}, 2.0}, {uneven}},
      {geometry::Disc{{3, 1, 1}, {0.1, 0.2, 1.0}, 2.0}, {uneven}},
      {geometry::Cylinder{{1, 0, 0}, {1, 1, 4}, 0.5, true}, {uneven}},
      {geometry::Cylinder{{1, 0, 0}, {1, 0, 100}, 1e-4}, {uneven}}};
  const Affine turned{rotation({1, 2, 3}, 0.7), {2000, 1500, 30}};
  Affine mirrored = turned;
  mirrored.linear.x = -1.7 * mirrored.linear.x;
  mirrored.origin = {1990, 1510, 30};
  geometry::SceneBuilder builder;
  for (const geometry::Surface& kind : kinds) builder.add(kind, {{}, {2010, 1490, 20}}, 0);
  builder.add_instances(kinds, {turned, mirrored}, 1);
  return builder.build();
}

void check_places(const SurfaceCell& cell) {
  CellPlaces places{cell};
  CHECK(places.flat() == (cell.place({0.3, 0.3}).material == even));
  double largest = 0.0;
  for (const Vec2 u : {Vec2{0, 0}, Vec2{0, 1}, Vec2{1, 0}, Vec2{1, 1}}) {
    largest = std::max(largest, cell.place(u).lift);
  }
  std::vector<Vec2> all = corner_cases();
  for (const double near : {1e-7, 6e-6, 1e-5, 4e-3}) all.push_back({near, 0.4});
  for (const Vec2 u : all) {
    const geometry::Hit expected = cell.place(u), found = places.at(u);
    CAPTURE(u.x, u.y);
    // Coordinates of 4 km and their sums are rounded to 1e-12 m at the most.
    CHECK(length(found.position - expected.position) < 4e-12);
    CHECK(length(found.normal - expected.normal) < 1e-12);
    CHECK(length(found.inset - expected.inset) < 1e-12);
    CHECK(found.facet == expected.facet);
    CHECK(found.back_face == expected.back_face);
    CHECK(found.lift >= expected.lift);
    CHECK(found.lift <= (places.flat() ? largest : expected.lift));
  }
}

}  // namespace

TEST_CASE("every place of a piece lies in that piece") {
  for (const CellGrid grid : {CellGrid{1, 1, true}, CellGrid{2, 2, true}, CellGrid{7, 7, true},
                              CellGrid{1, 1, false}, CellGrid{5, 3, false}}) {
    for (std::uint32_t cell = 0; cell < grid.cells(); ++cell) {
      for (const Vec2 u : corner_cases()) CHECK(grid.cell_at(grid.place_in(cell, u)) == cell);
    }
  }
}

TEST_CASE("the finest cuts keep their places, too") {
  const bool triangle = GENERATE(true, false);
  const CellGrid grid{4096, 4096, triangle};
  CHECK(grid.cells() == 4096U * 4096U);
  Rng rng{6};
  for (int i = 0; i < 300; ++i) {
    const auto cell = i < 4 ? static_cast<std::uint32_t>(i)
                            : static_cast<std::uint32_t>(rng.next() * grid.cells());
    for (const std::uint32_t c : {cell, grid.cells() - 1 - cell}) {
      for (const Vec2 u : corner_cases()) {
        if (grid.cell_at(grid.place_in(c, u)) != c) FAIL("cell " << c << ": " << u.x << " " << u.y);
      }
    }
  }
}

TEST_CASE("every place of a facet has a piece, its corners included") {
  const CellGrid triangle{5, 5, true}, face{5, 3, false};
  Rng rng{7};
  std::set<std::uint32_t> seen, seen_on_face;
  for (int i = 0; i < 4000; ++i) {
    double a = rng.next(), b = rng.next();
    seen_on_face.insert(face.cell_at({a, b}));
    if (a + b > 1.0) {
      a = 1.0 - a;
      b = 1.0 - b;
    }
    seen.insert(triangle.cell_at({a, b}));
  }
  for (const Vec2 corner : {Vec2{0, 0}, Vec2{1, 0}, Vec2{0, 1}, Vec2{0.5, 0.5}}) {
    seen.insert(triangle.cell_at(corner));
    seen_on_face.insert(face.cell_at(corner));
  }
  seen_on_face.insert(face.cell_at({1, 1}));
  CHECK(seen.size() == 25);
  CHECK(*seen.rbegin() == 24);
  CHECK(seen_on_face.size() == 15);
  CHECK(*seen_on_face.rbegin() == 14);
  // Rounding may put a hit a little outside.
  CHECK(triangle.cell_at({-1e-17, 1.0 + 1e-16}) < 25);
  CHECK(triangle.cell_at({0.6, 0.4 + 1e-15}) < 25);
}

TEST_CASE("places are uniform over a piece") {
  // Midpoints of a grid over [0, 1)^2 are as uniform as can be: their image's mean is the piece's
  // centroid and its second moments are a triangle's or a rectangle's, to the grid's 1 / 64^2.
  for (const CellGrid grid : {CellGrid{3, 3, true}, CellGrid{3, 2, false}}) {
    for (std::uint32_t cell = 0; cell < grid.cells(); ++cell) {
      Vec2 mean, square;
      for (int i = 0; i < 64 * 64; ++i) {
        const int row = i / 64, column = i % 64;
        const Vec2 at = grid.place_in(cell, {(column + 0.5) / 64, (row + 0.5) / 64});
        mean = {mean.x + at.x / 4096, mean.y + at.y / 4096};
        square = {square.x + at.x * at.x / 4096, square.y + at.y * at.y / 4096};
      }
      CAPTURE(grid.triangle, cell);
      CHECK(grid.cell_at(mean) == cell);
      const double variance = grid.triangle ? 1.0 / 18.0 : 1.0 / 12.0;
      CHECK((square.x - mean.x * mean.x) * grid.count * grid.count ==
            Approx(variance).epsilon(0.02));
      CHECK((square.y - mean.y * mean.y) * grid.count_v * grid.count_v ==
            Approx(variance).epsilon(0.02));
      const double third = std::fmod(3.0 * grid.count * mean.x, 1.0);
      if (grid.triangle) CHECK(std::min(third, 1.0 - third) < 0.02);  // centroids are at thirds
    }
  }
}

TEST_CASE("pieces are no longer than the resolution and no more than needed") {
  const CellGrid triangle = cut({true, 10.0, 0.0}, 2.5);
  CHECK(triangle.triangle);
  CHECK(triangle.cells() == 16);
  CHECK(cut({true, 10.1, 0.0}, 2.5).cells() == 25);
  const CellGrid face = cut({false, 3.0, 8.0}, 1.5);
  CHECK_FALSE(face.triangle);
  CHECK(face.count == 2);
  CHECK(face.count_v == 6);
  CHECK(cut({true, 0.0, 0.0}, 1.0).cells() == 1);
  CHECK(cut({false, 1e9, 0.1}, 1e-3).count == 4096);
}

TEST_CASE("a cell's places are hits on its own side of its own piece") {
  const geometry::Scene scene = ground_triangle();
  const CellGrid grid = cut(scene.facet_size(0), 2.0);
  for (std::uint32_t cell = 0; cell < grid.cells(); ++cell) {
    for (const bool back : {false, true}) {
      const SurfaceCell piece{&scene, 0, back, grid, cell};
      const geometry::Hit hit = piece.place({0.3, 0.9});
      CHECK(hit.material == 3);
      CHECK(hit.back_face == back);
      CHECK(hit.normal.z == (back ? -1.0 : 1.0));
      CHECK(grid.cell_at(hit.uv) == cell);
      const double z = hit.normal.z;
      const auto met = scene.intersect({hit.position + Vec3{0, 0, 3.0 * z}, {0, 0, -z}});
      REQUIRE(met);
      CHECK(met->facet == 0);
      CHECK(grid.cell_at(met->uv) == cell);
    }
  }
}

TEST_CASE("places found from a cell's corners are those that the scene gives") {
  const geometry::Scene scene = all_kinds();
  Rng rng{8};
  for (std::uint64_t facet = 0; facet < scene.facets(); ++facet) {
    const bool triangle = scene.facet_size(facet).triangle;
    for (const std::uint32_t count : {1U, 7U, 4096U}) {
      const CellGrid grid{count, triangle ? count : count / 3 + 1, triangle};
      const auto some = static_cast<std::uint32_t>(rng.next() * grid.cells());
      for (const std::uint32_t number : {0U, some}) {
        CAPTURE(facet, count, number);
        check_places({&scene, facet, facet % 2 == 1, grid, number});
      }
    }
  }
}

TEST_CASE("cells have keys of their own") {
  std::set<std::uint64_t> keys;
  for (std::uint64_t facet = 0; facet < 20; ++facet) {
    for (const bool back : {false, true}) {
      for (std::uint32_t cell = 0; cell < 20; ++cell) {
        keys.insert(SurfaceCell{nullptr, facet, back, {5, 4, false}, cell}.key());
      }
    }
  }
  CHECK(keys.size() == 800);
}
