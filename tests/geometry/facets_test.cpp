#include <set>
#include <tuple>

#include "core/error.hpp"
#include "geometry/scene_helpers.hpp"
#include "support/catch.hpp"

using namespace nadir;
using namespace nadir::geometry;
using namespace nadir::geometry::test;

namespace {

// The same arithmetic from the same parameters, or a few roundings of coordinates of 10 m.
constexpr double same_place = 1e-13;

const Affine turned{rotation(normalised({1, 2, 3}), 1.1) * scaling({2.0, 0.5, 1.5}), {9, 0, 0}};
const Affine in_a_mirror{rotation(normalised({0, 1, 3}), 0.4) * scaling({-1.0, 2.0, 0.7}),
                         {-9, 0, 0}};
const Affine stretched{rotation(normalised({3, 1, 0}), 0.7) * scaling({1.0, 3.0, 2.0}), {0, 9, 0}};

TriangleMesh hut() {
  TriangleMesh mesh = box_mesh({-1, -1, -1}, {1, 1, 1});
  for (const Vec3& p : mesh.positions) {
    mesh.texture.push_back({p.x + 0.1 * p.z, p.y});
    mesh.vertex_values.push_back(static_cast<float>(p.x + 2.0 * p.y));
  }
  return mesh;
}

const Cylinder drum{{0, 0, -1}, {0.3, 0, 1}, 0.8, true};

/// Meshes and shapes of every kind, baked and instanced: 12 + 6 + 1 + 1 + 3 + 1 + 1 facets baked,
/// then two instances (one in_a_mirror) of 12 + 3 + 6.
Scene mixed_scene() {
  SceneBuilder builder;
  builder.add(surface(hut(), 1), in_a_mirror * Affine{{}, {0, 0, 6}}, 0);
  builder.add(surface(Box{{-1, -1, -1}, {1, 2, 1}}, 2), Affine{{}, {0, -9, 0}}, 1);
  builder.add(surface(Sphere{{}, 1.2}, 3), stretched, 2);
  builder.add(surface(Disc{{}, {1, 1, 2}, 1.5}, 4), Affine{{}, {0, 0, 9}}, 3);
  builder.add(surface(drum, 5), stretched * Affine{{}, {0, 0, 6}}, 4);
  builder.add(surface(Cylinder{{0, 0, -1}, {0, 1, 1}, 0.8}, 6), Affine{{}, {0, 0, -9}}, 5);
  builder.add(surface(Plane{{}, 3.0, 2.0}, 7), stretched * Affine{{}, {0, 0, -6}}, 6);
  builder.add_instances(
      {surface(hut(), 8), surface(Shape{drum}, 9), surface(Box{{1.5, -1, -1}, {2, 1, 1}}, 10)},
      {turned, in_a_mirror}, 7);
  return builder.build();
}
constexpr std::uint64_t facets_of_mixed = 25 + 2 * 21;

void check_same_hit(const Hit& a, const Hit& b) {
  CHECK(length(a.position - b.position) < same_place);
  CHECK(length(a.normal - b.normal) < same_place);
  CHECK(a.back_face == b.back_face);
  CHECK(a.facet == b.facet);
  CHECK(a.material == b.material);
  CHECK(a.object == b.object);
  CHECK(a.instance == b.instance);
  CHECK(a.primitive == b.primitive);
  CHECK(a.uv == b.uv);
  CHECK(a.texture == b.texture);
  CHECK(length(a.tangent - b.tangent) < same_place);
  CHECK(a.mirrored_texture == b.mirrored_texture);
  CHECK(a.lift == Approx(b.lift).epsilon(1e-12));
  CHECK(length(a.inset - b.inset) < same_place);
}

}  // namespace

TEST_CASE("a hit's facet and parameters lead back to the hit") {
  const Scene scene = mixed_scene();
  CHECK(scene.facets() == facets_of_mixed);
  Rng rng{31};
  std::set<std::uint64_t> seen;
  for (const Vec3 middle : {Vec3{9, 0, 0}, Vec3{-9, 0, 0}, Vec3{0, 9, 0}, Vec3{0, -9, 0},
                            Vec3{0, 0, 9}, Vec3{0, 0, -9}, Vec3{}}) {
    for (int i = 0; i < 300; ++i) {
      const auto hit = scene.intersect(random_ray(rng, middle, 30.0, 9.0));
      if (!hit) continue;
      REQUIRE(hit->facet < scene.facets());
      seen.insert(hit->facet);
      Hit again = scene.on_facet(hit->facet, hit->uv, hit->back_face);
      CHECK(again.distance == 0.0);
      check_same_hit(again, *hit);
    }
  }
  CHECK(seen.size() > facets_of_mixed / 2);
}

TEST_CASE("every facet is met by a ray straight upon either of its sides, under its own number") {
  const Scene scene = mixed_scene();
  std::set<std::tuple<std::uint32_t, std::uint32_t, std::uint32_t>> places;
  for (std::uint64_t facet = 0; facet < scene.facets(); ++facet) {
    for (const bool back : {false, true}) {
      CAPTURE(facet, back);
      const Hit place = scene.on_facet(facet, {0.31, 0.42}, back);
      CHECK(length(place.normal) == Approx(1.0).epsilon(1e-14));
      CHECK(place.back_face == back);
      // From so near that nothing lies between: the surfaces are 0.1 m apart or more.
      const auto hit = scene.intersect({place.position + 1e-3 * place.normal, -place.normal});
      REQUIRE(hit);
      CHECK(hit->facet == facet);
      CHECK(hit->back_face == back);
      CHECK(length(hit->normal - place.normal) < 1e-9);  // of the curved ones
      CHECK(length(hit->position - place.position) < 1e-9);
      CHECK(hit->material == place.material);
      places.insert({place.object, place.instance, place.primitive});
    }
  }
  // Of shapes all faces are one primitive: 12 + 6 shapes baked, 12 in an instance (its shapes are
  // number 0 like the first triangle).
  CHECK(places.size() == 12 + 6 + 2 * 12);
}

TEST_CASE("the numbers of an instance's facets follow those of the instance before") {
  const Scene scene = mixed_scene();
  for (std::uint64_t facet = 25; facet < 25 + 21; ++facet) {
    const Hit first = scene.on_facet(facet, {0.3, 0.4}, false);
    const Hit second = scene.on_facet(facet + 21, {0.3, 0.4}, false);
    CHECK(first.instance == 0);
    CHECK(second.instance == 1);
    CHECK(first.primitive == second.primitive);
    CHECK(first.material == second.material);
  }
  CHECK(scene.on_facet(24, {0.3, 0.4}, false).material == 7);
  CHECK(scene.on_facet(25 + 12 + 2, {0.3, 0.4}, false).material == 9);
  CHECK(scene.on_facet(25 + 12 + 3, {0.3, 0.4}, false).material == 10);
}

TEST_CASE("the faces of a box point along its axes and those of a drum along its axis and across") {
  const Scene box = scene_of(surface(Box{{-1, -2, -3}, {1, 2, 3}}));
  const Vec3 outward[6]{{-1, 0, 0}, {1, 0, 0}, {0, -1, 0}, {0, 1, 0}, {0, 0, -1}, {0, 0, 1}};
  for (std::uint64_t face = 0; face < 6; ++face) {
    const Hit hit = box.on_facet(face, {0.25, 0.75}, false);
    CHECK(hit.normal == outward[face]);
    const std::uint64_t half_size = face / 2 + 1;
    CHECK(dot(hit.position, outward[face]) == static_cast<double>(half_size));
    CHECK(box.on_facet(face, {0.25, 0.75}, true).normal == -outward[face]);
  }
  const Scene can = scene_of(surface(Cylinder{{0, 0, 1}, {0, 0, 4}, 2.0, true}));
  CHECK(can.facets() == 3);
  CHECK(can.on_facet(0, {0.0, 0.5}, false).normal.z == 0.0);
  CHECK(can.on_facet(1, {0.5, 0.0}, false).normal == Vec3{0, 0, -1});
  CHECK(can.on_facet(2, {0.5, 0.0}, false).normal == Vec3{0, 0, 1});
  CHECK(can.on_facet(2, {0.5, 0.0}, false).position.z == 4.0);
}

TEST_CASE("a facet's size is that of its longest parameter lines") {
  const auto size_of = [](const Shape& shape, std::uint64_t face, const Affine& placement = {}) {
    return scene_of(surface(shape), placement).facet_size(face);
  };
  const double turn = 2.0 * std::numbers::pi;
  const FacetSize ball = size_of(Sphere{{}, 3.0}, 0);
  CHECK_FALSE(ball.triangle);
  CHECK(ball.u_m == Approx(3.0 * turn).epsilon(1e-14));
  CHECK(ball.v_m == Approx(1.5 * turn).epsilon(1e-14));
  const FacetSize wall = size_of(Box{{0, 0, 0}, {2, 3, 5}}, 1);  // +x: u along y, v along z
  CHECK(wall.u_m == 3.0);
  CHECK(wall.v_m == 5.0);
  const FacetSize front = size_of(Box{{0, 0, 0}, {2, 3, 5}}, 2, {scaling({4, 1, 1}), {}});
  CHECK(front.u_m == 8.0);
  CHECK(front.v_m == 5.0);
  const FacetSize cap = size_of(Cylinder{{}, {0, 0, 3}, 2.0, true}, 2);
  CHECK(cap.u_m == Approx(2.0).epsilon(1e-14));
  CHECK(cap.v_m == Approx(2.0 * turn).epsilon(1e-14));
  const FacetSize side = size_of(Cylinder{{}, {0, 0, 3}, 2.0, true}, 0);
  CHECK(side.u_m == Approx(2.0 * turn).epsilon(1e-14));
  CHECK(side.v_m == Approx(3.0).epsilon(1e-14));
  // Triangles are stored in float about the scene's centre.
  const auto t = scene_of(surface(one_triangle({0, 0, 0}, {3, 0, 0}, {0, 4, 0}))).facet_size(0);
  CHECK(t.triangle);
  CHECK(t.u_m == Approx(5.0).epsilon(1e-6));
}

TEST_CASE("no piece of a facet's parameters is longer than its part of the facet's size") {
  const Scene scene = mixed_scene();
  Rng rng{33};
  const double h = 1e-6;
  for (std::uint64_t facet = 0; facet < scene.facets(); ++facet) {
    const FacetSize size = scene.facet_size(facet);
    if (size.triangle) continue;
    double u_m = 0.0, v_m = 0.0;
    for (int i = 0; i < 400; ++i) {
      const Vec2 at{rng.next() * (1.0 - h), rng.next() * (1.0 - h)};
      const Vec3 here = scene.on_facet(facet, at, false).position;
      const Vec3 along_u = scene.on_facet(facet, {at.x + h, at.y}, false).position;
      const Vec3 along_v = scene.on_facet(facet, {at.x, at.y + h}, false).position;
      u_m = std::max(u_m, length(along_u - here) / h);
      v_m = std::max(v_m, length(along_v - here) / h);
    }
    CAPTURE(facet);
    // Differences over 1e-6 lose 1e-8 to rounding; 400 random places come this near to the most.
    CHECK(u_m < size.u_m * (1.0 + 1e-6));
    CHECK(v_m < size.v_m * (1.0 + 1e-6));
    CHECK(u_m > 0.9 * size.u_m);
    CHECK(v_m > 0.9 * size.v_m);
  }
}

TEST_CASE("parameters near a sphere's poles lead back to the place to rounding") {
  const Scene scene = scene_of(surface(Sphere{{}, 1.0}));
  for (const double x : {1e-3, 1e-6, 1e-9}) {
    const auto hit = scene.intersect({{x, 0, 3}, {0, 0, -1}});
    REQUIRE(hit);
    CHECK(length(scene.on_facet(0, hit->uv, false).position - hit->position) < 1e-15);
  }
}

TEST_CASE("values at vertices that are linear in space are met exactly everywhere") {
  const auto value = [](Vec3 p) { return 280.0 + 0.5 * p.x - 0.25 * p.y + 2.0 * p.z; };
  TriangleMesh mesh = box_mesh({-2, -1, -1}, {2, 1, 1});
  for (const Vec3& p : mesh.positions) mesh.vertex_values.push_back(static_cast<float>(value(p)));
  SceneBuilder builder;
  builder.add(surface(mesh), Affine{{}, {0, 0, 4}}, 0);
  builder.add(surface(box_mesh({-2, -1, -4}, {2, 1, -3})), {}, 1);
  builder.add_instances({surface(Shape{Sphere{{9, 0, 0}, 0.5}}), surface(mesh)}, {turned}, 2);
  const Scene scene = builder.build();
  Rng rng{34};
  int with = 0, without = 0;
  for (int i = 0; i < 1500; ++i) {
    const Vec3 target[3]{{0, 0, 4}, {0, 0, -3.5}, {9, 0, 0}};
    const auto hit = scene.intersect(random_ray(rng, target[i % 3], 30.0, 1.5));
    if (!hit) continue;
    const double got = scene.vertex_value(*hit);
    if (hit->object == 1) {
      CHECK(std::isnan(got));
      ++without;
      continue;
    }
    if (std::isnan(got)) continue;  // the sphere among the instance's parts
    const Vec3 own =
        hit->object == 0 ? hit->position - Vec3{0, 0, 4} : turned.inverse().point(hit->position);
    // Vertices are stored in float: 2^-23 of 15 m, times the gradient of 2 and the inverse's 2.
    CHECK(got == Approx(value(own)).margin(2e-5).epsilon(0.0));
    ++with;
  }
  CHECK(with > 300);
  CHECK(without > 100);
}

TEST_CASE("values at vertices must be finite and one for each") {
  SceneBuilder builder;
  TriangleMesh mesh = one_triangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  mesh.vertex_values = {1.0F, 2.0F};
  CHECK_THROWS_WITH(builder.add(surface(mesh), {}, 0),
                    Catch::Matchers::Contains("has values for 2 of its 3 vertices"));
  mesh.vertex_values = {1.0F, std::numeric_limits<float>::infinity(), 2.0F};
  CHECK_THROWS_WITH(builder.add_instances({surface(mesh)}, {Affine{}}, 0),
                    Catch::Matchers::Contains("the value of vertex 1 is not finite"));
}
