#include "geometry/scene_helpers.hpp"
#include "support/catch.hpp"

using namespace nadir;
using namespace nadir::geometry;
using namespace nadir::geometry::test;

namespace {

constexpr int cells = 128;
constexpr double half_m = 500.0;

/// Hills of 40 m and bumps of 1 m: no vertex is on a silhouette for rays steeper than 45 degrees,
/// since slopes stay below 40 * 0.013 + 1 * 0.37 = 0.9.
double bumpy(double x, double y) {
  return 40.0 * std::sin(0.013 * x) * std::cos(0.009 * y) + std::sin(0.37 * x) * std::sin(0.29 * y);
}

Vec3 steep_travel(Rng& rng) {  // at most 40 degrees off the vertical, downwards
  const double zenith = 0.7 * rng.next(), azimuth = 2.0 * std::numbers::pi * rng.next();
  return {std::sin(zenith) * std::cos(azimuth), std::sin(zenith) * std::sin(azimuth),
          -std::cos(zenith)};
}

int misses(const Scene& scene, const std::vector<Vec3>& targets, Rng& rng, double back_m) {
  int missed = 0;
  for (const Vec3& target : targets) {
    const Vec3 travel = steep_travel(rng);
    const Ray ray{target - back_m * travel, travel};
    missed += scene.intersect(ray) ? 0 : 1;
    missed += scene.occluded(ray) ? 0 : 1;
  }
  return missed;
}

/// Bounces inside a closed convex body: the rays that find no wall, and those that find again the
/// wall that they leave.
struct Walk {
  int escapes = 0, self_hits = 0;
};

/// On flat walls and on the side of a cylinder, no ray meets the same normal twice.
bool same_normal(const Hit& left, const Hit& met, Vec3 /*direction*/) {
  return dot(left.normal, met.normal) > 1.0 - 1e-13;
}

/// In a sphere every ray runs along a chord of 2 R cos(theta) = -2 (centre to wall) . direction;
/// the lift shortens it by lift / cos(theta) at most.
bool shorter_than_chord(const Hit& left, const Hit& met, Vec3 direction, double radius) {
  const double cosine = dot(left.normal, direction);
  return met.distance < 2.0 * radius * cosine - 1.01 * left.lift / cosine;
}

template <class IsSelfHit>
Walk walk(const Scene& scene, Vec3 start, int paths, int bounces, IsSelfHit is_self_hit) {
  Rng rng{77};
  Walk result;
  for (int i = 0; i < paths; ++i) {
    Ray ray{start, random_direction(rng)};
    std::optional<Hit> left;
    for (int bounce = 0; bounce < bounces; ++bounce) {
      const auto hit = scene.intersect(ray);
      if (!hit) {
        ++result.escapes;
        break;
      }
      if (left && is_self_hit(*left, *hit, ray.direction)) ++result.self_hits;
      Vec3 d = random_direction(rng);
      if (dot(d, hit->normal) < 0.0) d = -d;
      left = hit;
      ray = {leaving_origin(*hit, d), d};
    }
  }
  return result;
}

}  // namespace

// What is counted: rays within 40 degrees of the nadir, aimed at places inside the outline of the
// grid, that find nothing; each ray is asked twice, by intersect and by occluded.
TEST_CASE("no ray slips through a bumpy terrain", "[slow]") {
  const TriangleMesh mesh = grid_mesh(cells, half_m, bumpy);
  const Scene scene = scene_of(surface(mesh));
  Rng rng{31};
  std::vector<Vec3> targets;
  // 90 m inside the outline: tan 40 degrees times the relief of 82 m, so that no ray passes
  // outside.
  const auto inner = [](Vec3 p) { return std::max(std::abs(p.x), std::abs(p.y)) < half_m - 90.0; };

  SECTION("at random places") {
    for (int i = 0; i < 1'000'000; ++i) {
      const double x = 400.0 * (2.0 * rng.next() - 1.0), y = 400.0 * (2.0 * rng.next() - 1.0);
      targets.push_back({x, y, bumpy(x, y)});
    }
    CHECK(misses(scene, targets, rng, 2000.0) == 0);
  }
  SECTION("exactly at vertices") {
    const TriangleMesh stored = rounded(mesh);
    for (int repeat = 0; repeat < 20; ++repeat) {
      std::copy_if(stored.positions.begin(), stored.positions.end(), std::back_inserter(targets),
                   inner);
    }
    REQUIRE(targets.size() > 200'000);
    CHECK(misses(scene, targets, rng, 2000.0) == 0);
    CHECK(misses(scene, targets, rng, 800e3) == 0);
  }
  SECTION("exactly at edges") {
    const TriangleMesh stored = rounded(mesh);
    for (int repeat = 0; repeat < 3; ++repeat) {
      for (const auto& t : stored.triangles) {
        for (std::size_t k = 0; k < 3; ++k) {
          const Vec3 a = stored.positions[t[k]], b = stored.positions[t[(k + 1) % 3]];
          const Vec3 p = a + rng.next() * (b - a);
          if (inner(p)) targets.push_back(p);
        }
      }
    }
    REQUIRE(targets.size() > 190'000);
    CHECK(misses(scene, targets, rng, 2000.0) == 0);
    CHECK(misses(scene, targets, rng, 36e6) == 0);
  }
  SECTION("straight down at vertices") {
    const TriangleMesh stored = rounded(mesh);
    int missed = 0;
    for (const Vec3& p : stored.positions) {
      if (inner(p)) missed += scene.intersect({{p.x, p.y, 1000.0}, {0, 0, -1}}) ? 0 : 1;
    }
    CHECK(missed == 0);
  }
}

TEST_CASE("no ray leaves a closed body or hits the wall that it leaves", "[slow]") {
  const double size = GENERATE(1e-4, 1.0, 1000.0, 5e5);
  const Vec3 centre{3.0 * size, -size, 0.5 * size};
  const Vec3 half{size, 0.7 * size, 0.4 * size};
  const int paths = size == 1000.0 ? 200'000 : 20'000;  // 1e6 rays for one size, 1e5 for each other
  CAPTURE(size);
  SECTION("a box of triangles") {
    const Walk w = walk(scene_of(surface(box_mesh(centre - half, centre + half))), centre, paths, 5,
                        same_normal);
    CHECK(w.escapes == 0);
    CHECK(w.self_hits == 0);
  }
  SECTION("a box as a shape") {
    const Walk w =
        walk(scene_of(surface(Box{centre - half, centre + half})), centre, paths, 5, same_normal);
    CHECK(w.escapes == 0);
    CHECK(w.self_hits == 0);
  }
  SECTION("a sphere") {
    const Walk w = walk(scene_of(surface(Sphere{centre, size})), centre, 20'000, 5,
                        [&](const Hit& left, const Hit& met, Vec3 d) {
                          return shorter_than_chord(left, met, d, size);
                        });
    CHECK(w.escapes == 0);
    CHECK(w.self_hits == 0);
  }
  SECTION("a capped cylinder") {
    const Cylinder can{centre - half, centre + half, 0.5 * size, true};
    const Walk w = walk(scene_of(surface(can)), centre, 20'000, 5, same_normal);
    CHECK(w.escapes == 0);
    CHECK(w.self_hits == 0);
  }
  SECTION("an instance of a box of triangles in a larger scene") {
    SceneBuilder builder;
    builder.add(surface(Plane{{0, 0, -20.0 * size}, 40.0 * size, 40.0 * size}), {}, 0);
    const Affine placement{rotation(normalised({1, 1, 2}), 0.8) * scaling({2.0, 0.5, 1.0}), centre};
    builder.add_instances({surface(box_mesh(-half, half))}, {placement}, 1);
    const Walk w = walk(builder.build(), centre, 20'000, 5, same_normal);
    CHECK(w.escapes == 0);
    CHECK(w.self_hits == 0);
  }
}
