#include "core/error.hpp"
#include "geometry/scene_helpers.hpp"
#include "support/catch.hpp"

using namespace nadir;
using namespace nadir::geometry;
using namespace nadir::geometry::test;

namespace {

TriangleMesh triangle_soup(int count, Rng& rng) {
  TriangleMesh mesh;
  for (int i = 0; i < count; ++i) {
    const Vec3 middle = random_point(rng, {-10, -10, -10}, {10, 10, 10});
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (int k = 0; k < 3; ++k) mesh.positions.push_back(middle + 2.0 * random_direction(rng));
    mesh.triangles.push_back({first, first + 1, first + 2});
  }
  return mesh;
}

const Affine skewed{rotation(normalised({1, 2, 3}), 1.1) * scaling({2.0, 0.5, 1.5}),
                    {3.0, -4.0, 5.0}};
const Affine mirrored{rotation(normalised({0, 1, 3}), 0.4) * scaling({-1.0, 2.0, 0.7}), {1, 2, 3}};

}  // namespace

TEST_CASE("random rays meet what a search of all triangles in double finds") {
  Rng rng{11};
  const TriangleMesh mesh = rounded(triangle_soup(200, rng));
  const Scene scene = scene_of(surface(mesh));
  int hits = 0, near_edges = 0;
  for (int i = 0; i < 5000; ++i) {
    const Ray ray = random_ray(rng, {}, 20.0, 10.0);
    const auto hit = scene.intersect(ray);
    const auto expected = brute_force(mesh, ray);
    // Float rounding decides at edges: 10 m * 2^-23 of triangles of 2 m is 1e-6 in barycentrics.
    const bool agree =
        hit.has_value() == expected.has_value() && (!hit || hit->primitive == expected->primitive);
    if (!agree) {
      ++near_edges;
      continue;
    }
    CHECK(scene.occluded(ray) == hit.has_value());
    if (!hit) continue;
    ++hits;
    // Both in double; the margin is for grazing hits, where 1e-15 m across is more along the ray.
    CHECK(hit->distance == Approx(expected->distance).epsilon(1e-11));
    CHECK(length(ray.origin + hit->distance * ray.direction - hit->position) < 1e-11);
    CHECK(dot(hit->normal, ray.direction) <= 0.0);
    CHECK(length(hit->normal) == Approx(1.0).epsilon(1e-14));
  }
  CHECK(hits > 1000);
  CHECK(near_edges <= 2);  // expected: 5000 rays, a chance of about 1e-5 each
}

TEST_CASE("an instance is hit as the same mesh baked by the same transform") {
  Rng rng{12};
  const TriangleMesh mesh = triangle_soup(60, rng);
  const Affine placement = GENERATE(skewed, mirrored);
  SceneBuilder builder;
  builder.add_instances({surface(mesh, 3)}, {placement}, 9);
  const Scene instanced = builder.build();
  const Scene baked = scene_of(surface(mesh, 3), placement);
  int hits = 0, disagreements = 0;
  for (int i = 0; i < 2000; ++i) {
    const Ray ray = random_ray(rng, placement.origin, 40.0, 15.0);
    const auto a = instanced.intersect(ray), b = baked.intersect(ray);
    if (a.has_value() != b.has_value() || (a && a->primitive != b->primitive)) {
      ++disagreements;
      continue;
    }
    if (!a) continue;
    ++hits;
    // Stored in float two ways: a few 2^-23 of 30 m, more along the ray where it grazes.
    const double along = 3e-5 / std::max(1e-3, std::abs(dot(a->normal, ray.direction)));
    CHECK(a->distance == Approx(b->distance).margin(along).epsilon(0.0));
    CHECK(length(a->normal - b->normal) < 1e-4);
    CHECK(a->back_face == b->back_face);
    CHECK(a->material == 3);
    CHECK(a->object == 9);
  }
  CHECK(hits > 200);
  CHECK(disagreements <= 2);  // at edges, as above
}

TEST_CASE("shapes in a prototype are placed like shapes that are placed once") {
  const Affine placement = GENERATE(skewed, mirrored);
  const std::vector<Shape> shapes{Sphere{{0.5, 0, 0}, 1.0}, Disc{{0, 0, 1}, {1, 1, 1}, 2.0},
                                  Box{{-1, -1, -1}, {1, 2, 3}}, Plane{{0, 0, 1}, 3.0, 2.0},
                                  Cylinder{{0, 0, 0}, {1, 2, 3}, 0.7, true}};
  Rng rng{13};
  for (const Shape& shape : shapes) {
    SceneBuilder builder;
    builder.add_instances({surface(shape)}, {placement}, 1);
    const Scene instanced = builder.build();
    const Scene once = scene_of(surface(shape), placement);
    int hits = 0, disagreements = 0;
    for (int i = 0; i < 400; ++i) {
      const Ray ray = random_ray(rng, placement.origin, 8.0, 3.0);
      const auto a = instanced.intersect(ray), b = once.intersect(ray);
      CHECK(instanced.occluded(ray) == a.has_value());
      if (a.has_value() != b.has_value()) {
        ++disagreements;
        continue;
      }
      if (!a) continue;
      ++hits;
      const double along = 1e-5 / std::max(1e-3, std::abs(dot(a->normal, ray.direction)));
      CHECK(a->distance == Approx(b->distance).margin(along).epsilon(0.0));
      CHECK(length(a->normal - b->normal) < 1e-3);  // curvature times 1e-5 m over a grazing angle
      CHECK(a->back_face == b->back_face);
    }
    CHECK(hits > 50);
    CHECK(disagreements <= 1);  // at the rim
  }
}

TEST_CASE("a mirrored mesh keeps its outside outside") {
  const TriangleMesh box = box_mesh({-1, -1, -1}, {1, 1, 1});
  const Ray from_outside{{-10, 2, 3}, {1, 0, 0}};
  const Scene baked = scene_of(surface(box), mirrored);
  REQUIRE(baked.intersect(from_outside));
  CHECK_FALSE(baked.intersect(from_outside)->back_face);
  CHECK(baked.intersect({mirrored.origin, {0, 0, 1}})->back_face);
}

TEST_CASE("every instance is told by its number and its object") {
  std::vector<Affine> placements;
  for (int i = 0; i < 10; ++i) placements.push_back({{}, {3.0 * i, 0.0, 0.0}});
  SceneBuilder builder;
  builder.add(surface(Plane{{0, 0, -2}, 1e3, 1e3}, 4), {}, 6);
  builder.add_instances(
      {surface(box_mesh({-1, -1, 0}, {1, 1, 1}), 1), surface(Sphere{{0, 0, 1.5}, 0.5}, 2)},
      placements, 8);
  const Scene scene = builder.build();
  CHECK(scene.stored_primitives() == 1 + 13);
  CHECK(scene.represented_primitives() == 1 + 130);
  for (std::uint32_t i = 0; i < 10; ++i) {
    const auto top = scene.intersect({{3.0 * i, 0.0, 50.0}, {0, 0, -1}});
    REQUIRE(top);
    CHECK(top->material == 2);
    CHECK(top->object == 8);
    CHECK(top->instance == i);
    CHECK(top->position.z == Approx(2.0).epsilon(1e-6));  // the placement is held in float
    const auto roof = scene.intersect({{3.0 * i + 0.9, 0.9, 50.0}, {0, 0, -1}});
    REQUIRE(roof);
    CHECK(roof->material == 1);
    CHECK(roof->instance == i);
  }
  const auto ground = scene.intersect({{1.5, 0.0, 50.0}, {0, 0, -1}});
  REQUIRE(ground);
  CHECK(ground->material == 4);
  CHECK(ground->object == 6);
  CHECK(ground->distance == 52.0);
}

TEST_CASE("every triangle has the material of its part") {
  TriangleMesh mesh = grid_mesh(2, 1.0, [](double, double) { return 0.0; });
  mesh.part_names = {"a", "b", "c"};
  mesh.parts = {0, 0, 1, 1, 2, 2, 0, 1};
  SceneBuilder builder;
  builder.add({mesh, {10, 11, 12}}, {}, 0);
  const Scene scene = builder.build();
  for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
    Vec3 middle;
    for (const std::uint32_t v : mesh.triangles[i]) middle += mesh.positions[v] / 3.0;
    const auto hit = scene.intersect({middle + Vec3{0, 0, 1}, {0, 0, -1}});
    REQUIRE(hit);
    CHECK(hit->primitive == i);
    CHECK(hit->material == 10 + mesh.parts[i]);
  }
}

TEST_CASE("max_distance ends a ray exactly") {
  const Scene scene = scene_of(surface(one_triangle({-8, -8, 0}, {8, -8, 0}, {0, 8, 0})));
  const Scene round = scene_of(surface(Sphere{{0, 0, -1}, 1.0}));
  const Vec3 down{0, 0, -1};
  for (const Scene& s : {scene, round}) {
    CHECK(s.intersect({{0, 0, 3}, down, 3.0 + 1e-9}));
    CHECK_FALSE(s.intersect({{0, 0, 3}, down, 3.0 - 1e-9}));
    CHECK(s.occluded({{0, 0, 3}, down, 3.0 + 1e-9}));
    CHECK_FALSE(s.occluded({{0, 0, 3}, down, 3.0 - 1e-9}));
  }
}

TEST_CASE("a scene without surfaces is never hit") {
  const Scene scene = SceneBuilder{}.build();
  CHECK_FALSE(scene.intersect({{0, 0, 1}, {0, 0, -1}}));
  CHECK_FALSE(scene.occluded({{0, 0, 1}, {0, 0, -1}}));
  CHECK(scene.stored_primitives() == 0);
}

TEST_CASE("a builder is empty after it has built") {
  SceneBuilder builder;
  builder.add(surface(Sphere{}), {}, 0);
  CHECK(builder.build().stored_primitives() == 1);
  CHECK(builder.build().stored_primitives() == 0);
}

TEST_CASE("building leaves denormal numbers alone") {
  const Scene scene = scene_of(surface(Sphere{}));
  (void)scene.intersect({{0, 0, 5}, {0, 0, -1}});
  volatile double smallest = std::numeric_limits<double>::min();
  CHECK(smallest / 2.0 > 0.0);
}

TEST_CASE("triangles without area are tolerated and not hit") {
  TriangleMesh mesh = one_triangle({-1, -1, 0}, {1, -1, 0}, {0, 1, 0});
  mesh.positions.push_back({0, 0, 0.5});
  mesh.triangles.push_back({3, 3, 3});
  mesh.triangles.push_back({0, 1, 1});
  const auto hit = scene_of(surface(mesh)).intersect({{0, 0, 1}, {0, 0, -1}});
  REQUIRE(hit);
  CHECK(hit->primitive == 0);
  CHECK(hit->distance == 1.0);
}

TEST_CASE("what cannot be built is refused with the reason") {
  SceneBuilder builder;
  TriangleMesh mesh = one_triangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  const Affine flat{scaling({1, 0, 1}), {}};
  CHECK_THROWS_WITH(builder.add(surface(mesh), flat, 0), Catch::Matchers::Contains("singular"));
  CHECK_THROWS_WITH(builder.add_instances({surface(mesh)}, {Affine{}, flat}, 0),
                    Catch::Matchers::Contains("singular"));
  CHECK_THROWS_WITH(builder.add({mesh, {}}, {}, 0), Catch::Matchers::Contains("has no material"));
  CHECK_THROWS_WITH(builder.add(surface(TriangleMesh{}), {}, 0),
                    Catch::Matchers::Contains("no triangles"));
  mesh.triangles[0][2] = 3;
  CHECK_THROWS_WITH(builder.add(surface(mesh), {}, 0), Catch::Matchers::Contains("names vertex 3"));
  mesh.triangles[0][2] = 2;
  mesh.positions[1].y = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_WITH(builder.add(surface(mesh), {}, 0),
                    Catch::Matchers::Contains("vertex 1 is not finite"));
  mesh.positions[1].y = 1e300;
  CHECK_THROWS_AS(builder.add(surface(mesh), {}, 0), InputError);
}
