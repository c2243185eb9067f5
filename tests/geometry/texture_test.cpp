#include <cmath>
#include <limits>
#include <numbers>

#include "core/error.hpp"
#include "geometry/scene_helpers.hpp"
#include "support/catch.hpp"

// Texture coordinates and tangents of hits.

namespace nadir::geometry {
namespace {

using test::box_mesh;
using test::grid_mesh;
using test::scene_of;
using test::surface;

/// A wavy grid over [-10, 10]^2 with u = 0.3 x + 0.1 y + 2, v = -0.2 x + 0.4 y - 1.
TriangleMesh wavy() {
  TriangleMesh mesh = grid_mesh(8, 10.0, [](double x, double y) { return std::sin(x + 0.7 * y); });
  for (const Vec3& p : mesh.positions) {
    mesh.texture.push_back({0.3 * p.x + 0.1 * p.y + 2.0, -0.2 * p.x + 0.4 * p.y - 1.0});
  }
  return mesh;
}

Ray down(double x, double y) { return {{x, y, 50.0}, {0.0, 0.0, -1.0}}; }

TEST_CASE("texture coordinates are interpolated over the triangle", "[geometry][texture]") {
  const Scene scene = scene_of(surface(wavy()));
  Rng rng{3, 0};
  for (int i = 0; i < 200; ++i) {
    const double x = 18.0 * rng.next() - 9.0, y = 18.0 * rng.next() - 9.0;
    const auto hit = scene.intersect(down(x, y));
    REQUIRE(hit.has_value());
    // 1e-5: vertices and coordinates are stored in float (values to 10, steps 1e-6)
    CHECK(hit->texture.x == Approx(0.3 * x + 0.1 * y + 2.0).margin(1e-5));
    CHECK(hit->texture.y == Approx(-0.2 * x + 0.4 * y - 1.0).margin(1e-5));
  }
}

TEST_CASE("the tangent is a unit vector in the surface along which u grows and v does not",
          "[geometry][texture]") {
  const Scene scene = scene_of(surface(wavy()));
  Rng rng{4, 0};
  for (int i = 0; i < 200; ++i) {
    const double x = 18.0 * rng.next() - 9.0, y = 18.0 * rng.next() - 9.0;
    const auto hit = scene.intersect(down(x, y));
    REQUIRE(hit.has_value());
    const Vec3 t = hit->tangent;
    CHECK(length(t) == Approx(1.0).epsilon(1e-12));
    CHECK(std::abs(dot(t, hit->normal)) < 1e-12);
    CHECK(0.3 * t.x + 0.1 * t.y > 0.0);
    CHECK(std::abs(-0.2 * t.x + 0.4 * t.y) < 1e-5);  // float vertices
  }
}

TEST_CASE("a texture laid on mirrored still has its tangent along growing u",
          "[geometry][texture]") {
  TriangleMesh mesh = wavy();
  for (Vec2& at : mesh.texture) at.x = -at.x;
  const auto straight = scene_of(surface(wavy())).intersect(down(1.3, 2.1));
  const auto turned = scene_of(surface(mesh)).intersect(down(1.3, 2.1));
  REQUIRE((straight && turned));
  CHECK(length(straight->tangent + turned->tangent) < 1e-5);  // float texture coordinates
}

TEST_CASE("seen from behind, texture and tangent are the same", "[geometry][texture]") {
  const Scene scene = scene_of(surface(wavy()));
  const auto above = scene.intersect(down(1.3, 2.1));
  const auto below = scene.intersect({{1.3, 2.1, -50.0}, {0.0, 0.0, 1.0}});
  REQUIRE((above && below));
  CHECK(below->back_face);
  CHECK(below->texture.x == Approx(above->texture.x).epsilon(1e-9));
  CHECK(length(below->tangent - above->tangent) < 1e-9);
}

TEST_CASE("a placement and an instance carry texture and tangent along", "[geometry][texture]") {
  const Affine placement{
      rotation({0.0, 0.0, 1.0}, 0.5 * std::numbers::pi) * scaling({2.0, 2.0, 2.0}),
      {5.0, -3.0, 0.0}};
  const Affine mirrored{scaling({-1.0, 1.0, 1.0}), {}};
  const Affine outer = GENERATE_REF(values({placement, mirrored, placement * mirrored}));
  SceneBuilder builder;
  builder.add_instances({surface(wavy())}, {outer}, 0);
  const Scene instanced = builder.build();
  const Scene placed = scene_of(surface(wavy()), outer);
  const auto original = scene_of(surface(wavy())).intersect(down(1.3, 2.1));
  REQUIRE(original.has_value());
  const Vec3 to = outer.point(original->position);
  const Vec3 expected = normalised(outer.vector(original->tangent));
  for (const Scene* scene : {&instanced, &placed}) {
    const auto hit = scene->intersect(down(to.x, to.y));
    REQUIRE(hit.has_value());
    CHECK(hit->texture.x == Approx(original->texture.x).margin(1e-5));
    CHECK(hit->texture.y == Approx(original->texture.y).margin(1e-5));
    CHECK(length(hit->tangent - expected) < 1e-5);
  }
}

TEST_CASE("an instance that is stretched unevenly keeps the tangent in the surface",
          "[geometry][texture]") {
  SceneBuilder builder;
  builder.add_instances({surface(wavy())}, {{scaling({1.0, 3.0, 0.2}), {}}}, 0);
  const auto hit = builder.build().intersect(down(1.3, 6.3));
  REQUIRE(hit.has_value());
  CHECK(length(hit->tangent) == Approx(1.0).epsilon(1e-12));
  CHECK(std::abs(dot(hit->tangent, hit->normal)) < 1e-12);
  // dP/du of the original is along (0.4, 0.2, ...), stretched: (0.4, 0.6, ...)
  CHECK(hit->tangent.y / hit->tangent.x == Approx(1.5).epsilon(1e-4));
}

TEST_CASE("meshes without texture, shapes and degenerate texture have no tangent",
          "[geometry][texture]") {
  TriangleMesh folded = wavy();
  for (Vec2& at : folded.texture) at = {0.25, 0.75};
  const auto flat = scene_of(surface(folded)).intersect(down(1.0, 1.0));
  REQUIRE(flat.has_value());
  CHECK(flat->texture == Vec2{0.25, 0.75});
  CHECK(flat->tangent == Vec3{});
  const auto box =
      scene_of(surface(box_mesh({-1.0, -1.0, -1.0}, {1.0, 1.0, 1.0}))).intersect(down(0.1, 0.2));
  REQUIRE(box.has_value());
  CHECK(box->texture == Vec2{});
  CHECK(box->tangent == Vec3{});
  const auto sphere = scene_of(surface(Sphere{{}, 1.0})).intersect(down(0.1, 0.2));
  REQUIRE(sphere.has_value());
  CHECK(sphere->tangent == Vec3{});
}

TEST_CASE("texture coordinates for some vertices only, or not finite, are refused",
          "[geometry][texture]") {
  TriangleMesh some = wavy();
  some.texture.pop_back();
  CHECK_THROWS_WITH(scene_of(surface(some)),
                    Catch::Contains("texture coordinates for 80 of its 81 vertices"));
  TriangleMesh bad = wavy();
  bad.texture[3].y = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_WITH(scene_of(surface(bad)),
                    Catch::Contains("texture coordinates of vertex 3 are not finite"));
}

}  // namespace
}  // namespace nadir::geometry
