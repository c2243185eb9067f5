#include "thermal/exposure/exposure.hpp"

#include "core/transform.hpp"
#include "support/catch.hpp"
#include "thermal/exposure_scene.hpp"

using namespace nadir;
using namespace nadir::thermal;
using namespace nadir::thermal::test;

namespace {

constexpr std::uint32_t ground = 1, wall = 2, lid = 3;

geometry::SceneBuilder with_ground(double size_m = 1001.0) {
  geometry::SceneBuilder builder;
  builder.add(at_times(geometry::Plane{{}, size_m, size_m}, ground), {}, 0);
  return builder;
}

/// Where the edge of a shadow lies on a square of 10 m or on half of it.
struct ShadowEdge {
  Vec3 through;
  double azimuth_deg = 90.0;  ///< of the sun, 45 degrees high, and of the edge's normal
  bool triangle = false;
};

geometry::Surface square_or_half(bool triangle) {
  if (!triangle) return at_times(geometry::Plane{{}, 10.0, 10.0}, ground);
  geometry::TriangleMesh mesh;
  mesh.positions = {{-5, -5, 0}, {5, -5, 0}, {-5, 5, 0}};
  mesh.triangles = {{0, 1, 2}};
  return {mesh, {ground}};
}

/// What lies towards the sun is shaded, by a board whose upper edge stands in the sun's way.
geometry::Scene shaded_to(const ShadowEdge& edge) {
  geometry::SceneBuilder builder;
  builder.add(square_or_half(edge.triangle), {}, 0);
  const Vec3 level = towards(edge.azimuth_deg, 0.0);
  const Vec3 top = edge.through + 15.0 * level + Vec3{0, 0, 15},
             side{-50 * level.y, 50 * level.x, 0};
  const Vec3 down{0, 0, -15};
  geometry::TriangleMesh board;
  board.positions = {top - side, top + side, top + side + down, top - side + down};
  board.triangles = {{0, 1, 2}, {0, 2, 3}};
  builder.add({board, {wall}}, {}, 1);
  return builder.build();
}

double mean_of(const std::vector<float>& values) {
  double sum = 0.0;
  for (const float v : values) sum += static_cast<double>(v);
  return sum / static_cast<double>(values.size());
}

}  // namespace

TEST_CASE("level open ground sees nothing but sky, and the sun by the sine of its elevation") {
  const geometry::Scene scene = with_ground().build();
  SunTrack track = overhead_track();
  track.direction[7].z = -0.1;  // below the horizon
  const Exposure seen = exposure_of(middle(scene, 0), track);
  REQUIRE(seen.sun_cosine.size() == track.direction.size());
  for (std::size_t i = 1; i + 1 < track.direction.size(); ++i) {
    const double expected = std::max(0.0, track.direction[i].z);
    CHECK(static_cast<double>(seen.sun_cosine[i]) == Approx(expected).margin(1e-7));  // a float's
  }
  CHECK(seen.epochs == std::vector<std::uint32_t>{1});
  REQUIRE(seen.seen.size() == 1);
  CHECK(seen.seen[0].sky_fraction == 1.0);
  CHECK(seen.seen[0].patches.empty());
  // Rays: the sun's 358 moments or so, 7 more in the last 6, 64 about; nothing for surroundings.
  CHECK(seen.rays <= 361 + 6 * 7 + 64);
}

TEST_CASE("the underside of a sheet sees the ground and no sun") {
  geometry::SceneBuilder builder = with_ground();
  builder.add(at_times(geometry::Plane{{0, 0, 1}, 2.0, 2.0}, lid), {}, 1);
  const geometry::Scene scene = builder.build();
  const Exposure seen = exposure_of(whole(scene, 1, true), overhead_track());
  CHECK(mean_of(seen.sun_cosine) == 0.0);
  CHECK(seen.seen[0].sky_fraction == 0.0);
  CHECK(view_factor_of(seen.seen[0], ground) + view_factor_of(seen.seen[0], ground_about) == 1.0);
  // 500 m away the ground ends: of 1 m above it the part beyond is h^2 / r^2 = 4e-6.
  CHECK(view_factor_of(seen.seen[0], ground) == 1.0);
  for (const SurroundingPatch& patch : seen.seen[0].patches) CHECK(patch.sky_fraction == 1.0);
}

TEST_CASE("the foot of a wall sees half a sky, the wall half a sky and half the ground") {
  geometry::SceneBuilder builder = with_ground();
  builder.add(at_times(geometry::Box{{-500, 0, 0}, {500, 1, 500}}, wall), {}, 1);
  const geometry::Scene scene = builder.build();
  const ExposureSettings settings{4096, 8, 3600.0};
  // The wall's southern face is facet 1 + 2. Rays of low discrepancy halve a hemisphere exactly;
  // random ones would be off by 8e-3.
  const Exposure of_wall = exposure_of(middle(scene, 3), overhead_track(), settings);
  CHECK(of_wall.seen[0].sky_fraction == Approx(0.5).margin(1e-3));
  CHECK(view_factor_of(of_wall.seen[0], ground) + view_factor_of(of_wall.seen[0], ground_about) ==
        Approx(0.5).margin(1e-3));
  // Ground 1 m or less in front: 1e-3 of the sky is seen past the wall's ends and over its top;
  // over seeds the standard deviation is 3e-4.
  SurfaceCell foot = middle(scene, 0);
  foot.cell = foot.grid.cell_at({0.5, 0.5 - 0.6 / 1001.0});
  const Exposure of_foot = exposure_of(foot, overhead_track(), settings);
  CHECK(of_foot.seen[0].sky_fraction == Approx(0.501).margin(2e-3));
  CHECK(view_factor_of(of_foot.seen[0], wall) == Approx(0.499).margin(2e-3));
}

TEST_CASE("beyond the edge of the scene lies level ground in the open") {
  geometry::SceneBuilder builder;
  builder.add(at_times(geometry::Box{{-1, -1, 5}, {1, 1, 7}}, wall), {}, 0);
  const geometry::Scene scene = builder.build();
  const ExposureSettings settings{1024, 8, 3600.0};
  const Exposure seen = exposure_of(whole(scene, 2), overhead_track(), settings);
  REQUIRE(seen.seen[0].patches.size() == 1);
  const SurroundingPatch& about = seen.seen[0].patches[0];
  CHECK(about.material == ground_about);
  CHECK(about.view_factor == Approx(0.5).margin(5e-3));
  CHECK(about.sky_fraction == 1.0);
  CHECK(about.normal == Vec3{0, 0, 1});
  REQUIRE(about.sun_cosine.size() == 13);  // 12 h, every hour
  for (int i = 1; i < 12; ++i) {
    CHECK(static_cast<double>(about.sun_cosine[static_cast<std::size_t>(i)]) ==
          Approx(std::sin(15.0 * i * degree)).margin(1e-5));
  }
}

TEST_CASE("a wall's shadow ends when the sun has climbed over its edge") {
  geometry::SceneBuilder builder = with_ground();
  builder.add(at_times(geometry::Box{{10, -400, 0}, {11, 400, 10}}, wall), {}, 1);
  const geometry::Scene scene = builder.build();
  // Ground at x = -4.5..-3.5: the edge stands at atan(10 / 13.5..14.5).
  SurfaceCell place = middle(scene, 0);
  place.cell = place.grid.cell_at({0.5 - 4.0 / 1001.0, 0.5});
  const SunTrack track = overhead_track();
  const Exposure seen = exposure_of(place, track);
  const double disc = std::asin(track.sin_radius) / degree;
  const double low = std::atan2(10.0, 14.55) / degree - disc;
  const double high = std::atan2(10.0, 13.45) / degree + disc;
  for (std::size_t i = 1; i < 360; ++i) {
    const double elevation = 0.5 * static_cast<double>(i);
    CAPTURE(elevation);
    if (elevation < low) CHECK(seen.sun_cosine[i] == 0.0F);
    if (elevation > high) {
      CHECK(static_cast<double>(seen.sun_cosine[i]) ==
            Approx(std::sin(elevation * degree)).margin(1e-6));
    }
  }
}

TEST_CASE("a pole's shadow passes while the sun stands behind it") {
  geometry::SceneBuilder builder = with_ground(101.0);
  builder.add(at_times(geometry::Cylinder{{0, -5, 0}, {0, -5, 4}, 0.5, true}, wall), {}, 1);
  const geometry::Scene scene = builder.build();
  // A centimetre of ground at the origin, the pole 5 m south of it, and a sun 20 degrees high that
  // goes round: hidden within asin(0.5 / 5) of the south. At 45 degrees it shines over the top.
  SurfaceCell place = whole(scene, 0);
  place.grid = {4001, 4001, false};
  place.cell = place.grid.cell_at({0.5, 0.5});
  const double half_deg = std::asin(0.5 / 5.0) / degree,
               margin_deg = 0.27 / std::cos(20 * degree) + 0.2;
  for (const double elevation : {20.0, 45.0}) {
    std::vector<Vec3> directions;
    for (int i = 0; i < 720; ++i) directions.push_back(towards(0.5 * i, elevation));
    const Exposure seen = exposure_of(place, track_of(directions));
    for (std::size_t i = 0; i < 720; ++i) {
      const double off = std::abs(0.5 * static_cast<double>(i) - 180.0);
      CAPTURE(elevation, off);
      const bool lit = seen.sun_cosine[i] > 0.0F;
      if (elevation > 40.0 || off > half_deg + margin_deg) CHECK(lit);
      if (elevation < 40.0 && off < half_deg - margin_deg) CHECK_FALSE(lit);
    }
  }
}

// One ray or eight a moment, as neighbours differ or not: would a moment's own ray have a say in
// it, a share of 0.9 would come out as 0.96 and one of 0.1 as 0.04.
TEST_CASE("a cell that is partly in shadow has its lit share of the sun on average") {
  const SunTrack track = track_of(std::vector<Vec3>(1024, towards(90.0, 45.0)));
  for (const double lit : {0.1, 0.5, 0.7, 0.9}) {
    // From the east: what lies beyond x is shaded.
    const geometry::Scene scene = shaded_to({{10.0 * lit - 5.0, 0.0, 0.0}});
    CAPTURE(lit);
    const auto found = [&](int edge_rays, std::uint64_t seed) {
      const ExposureSettings settings{1, 0, 3600.0, edge_rays, 6};
      return mean_of(exposure_of(whole(scene, 0), track, settings, seed).sun_cosine) /
             track.direction[0].z;
    };
    // Standard deviations over 200 seeds: 0.002 and 0.009, the means right to 3e-4.
    CHECK(found(1, 1) == Approx(lit).margin(0.008));
    CHECK(found(8, 1) == Approx(lit).margin(0.03));
  }
}

TEST_CASE("a cell that a shadow's edge crosses has its lit share at the moment of the picture") {
  // The edge halves the cell: along a side and aslant; on a triangle along two medians, too.
  const double slant = std::atan2(1.0, 2.0) / degree;
  const ShadowEdge edges[]{{{}},
                           {{}, 60.0},
                           {{}, 115.0},
                           {{5.0 - 10.0 / std::numbers::sqrt2, 0, 0}, 90.0, true},
                           {{}, 135.0, true},
                           {{5, -5, 0}, slant, true}};
  constexpr std::uint64_t seeds = 60;
  for (const ShadowEdge& edge : edges) {
    const geometry::Scene scene = shaded_to(edge);
    const Vec3 sun = towards(edge.azimuth_deg, 45.0);
    const SunTrack track = track_of(std::vector<Vec3>(12, sun));
    double squares = 0.0, largest = 0.0;
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
      const auto share = [&](int edge_rays) {
        const ExposureSettings settings{1, 0, 3600.0, edge_rays, 6};
        const Exposure seen = exposure_of(whole(scene, 0), track, settings, seed);
        return static_cast<double>(seen.sun_cosine.back()) / sun.z;
      };
      const double off = share(8) - 0.5;
      squares += off * off;
      largest = std::max(largest, std::abs(off));
      CHECK(std::abs(share(1) - 0.5) == Approx(0.5).epsilon(1e-6));  // one ray: all or nothing
    }
    CAPTURE(edge.triangle, edge.azimuth_deg, largest);
    // 0.03 to 0.13; random rays would have 0.18. Over edges anywhere 0.075 on squares, 0.09 on
    // triangles, and the largest of 12,000 was 0.35.
    CHECK(std::sqrt(squares / seeds) < 0.15);
    CHECK(largest < 0.4);
  }
}

TEST_CASE("more rays look for the sun where shadows come and go, and at last") {
  geometry::SceneBuilder builder = with_ground(11.0);
  builder.add(at_times(geometry::Box{{6, -50, 0}, {7, 50, 30}}, wall), {}, 1);
  const geometry::Scene scene = builder.build();
  // Lit, in the wall's shade, lit, the sun beneath the horizon, lit.
  std::vector<Vec3> directions(20, towards(270.0, 30.0));
  directions.insert(directions.end(), 20, towards(90.0, 30.0));
  directions.insert(directions.end(), 20, towards(270.0, 30.0));
  directions.insert(directions.end(), 10, towards(270.0, -30.0));
  directions.insert(directions.end(), 20, towards(270.0, 30.0));
  const SunTrack track = track_of(directions);
  const auto seen_with = [&](int edge_rays, int last_moments) {
    return exposure_of(whole(scene, 0), track, {1, 0, 3600.0, edge_rays, last_moments});
  };
  const Exposure seen = seen_with(8, 6);
  CHECK(seen.rays == 80 + (2 * 2 + 6) * 7 + 1);
  CHECK(seen_with(8, 0).rays == 80 + 2 * 2 * 7 + 1);
  CHECK(seen_with(1, 6).rays == 80 + 1);
  CHECK(seen_with(3, 1000).rays == 80 * 3 + 1);
  // With all of their rays moments wholly lit or shaded are what they were.
  for (std::size_t i = 0; i < directions.size(); ++i) {
    const bool lit = i < 20 || (i >= 40 && i < 60) || i >= 70;
    CAPTURE(i);
    CHECK(static_cast<double>(seen.sun_cosine[i]) == Approx(lit ? 0.5 : 0.0).margin(1e-7));
  }
  CHECK(seen_with(8, 6).sun_cosine == seen.sun_cosine);
}

TEST_CASE("an edge across the sun's disc lets the part above it pass") {
  const double radius = 0.00465, edge_deg = 45.0 - 0.5 * std::asin(radius) / degree;
  geometry::SceneBuilder builder;
  builder.add(at_times(geometry::Plane{{}, 0.001, 0.001}, ground), {}, 0);
  builder.add(
      at_times(geometry::Box{{10, -50, 0}, {11, 50, 10 * std::tan(edge_deg * degree)}}, wall), {},
      1);
  const geometry::Scene scene = builder.build();
  const SunTrack track = track_of(std::vector<Vec3>(1024, towards(90.0, 45.0)));
  const Exposure seen = exposure_of(whole(scene, 0), track);
  // A chord at half the radius cuts off (acos(1/2) - 1/2 sqrt(3/4)) / pi of a disc. The place's
  // half millimetre is a hundredth of the penumbra's 0.1 m; over seeds 7e-3.
  const double hidden = (std::acos(0.5) - 0.5 * std::sqrt(0.75)) / std::numbers::pi;
  CHECK(mean_of(seen.sun_cosine) / std::sin(45.0 * degree) == Approx(1.0 - hidden).margin(0.02));
  // The eight rays of one moment: random points of the disc would have 0.14, one for all 0.40.
  const SunTrack once = track_of(std::vector<Vec3>(2, towards(90.0, 45.0)));
  double squares = 0.0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    const Exposure then = exposure_of(whole(scene, 0), once, {1, 0, 3600.0}, seed);
    const double off = static_cast<double>(then.sun_cosine.back()) / once.direction[1].z - 1.0;
    squares += (off + hidden) * (off + hidden) / 60;
  }
  CHECK(std::sqrt(squares) < 0.12);
}

TEST_CASE("ground under a box has its sky and sun back when the box has left") {
  geometry::SceneBuilder builder = with_ground();
  const std::uint32_t before = 2U;
  builder.add(at_times(geometry::Box{{-2, -2, 0}, {2, 2, 2}}, lid, before), {}, 1);
  const geometry::Scene scene = builder.build();
  SunTrack track = overhead_track();
  for (std::size_t i = 0; i < 200; ++i) track.epoch[i] = before;
  Exposure seen;
  const SurfaceCell place = middle(scene, 0);
  expose(scene, place, track, {}, 1, seen);
  CHECK(seen.epochs == std::vector<std::uint32_t>{before, geometry::at_the_picture});
  REQUIRE(seen.seen.size() == 2);
  CHECK(seen.seen[0].sky_fraction == 0.0);
  CHECK(view_factor_of(seen.seen[0], lid) == 1.0);
  CHECK(seen.seen[1].sky_fraction == 1.0);
  CHECK(seen.seen[1].patches.empty());
  for (std::size_t i = 1; i < 360; ++i) CHECK((seen.sun_cosine[i] > 0.0F) == (i >= 200));
}

TEST_CASE("the same cell and seed give the same, whatever was looked at before") {
  geometry::SceneBuilder builder = with_ground(31.0);
  builder.add(at_times(geometry::Box{{1, -4, 0}, {2, 4, 3}}, wall), {}, 1);
  builder.add(at_times(geometry::Sphere{{-3, 1, 1}, 1.0}, lid), {}, 2);
  const geometry::Scene scene = builder.build();
  const SunTrack track = overhead_track();
  Exposure used;
  for (const std::uint64_t facet : {1ULL, 6ULL, 7ULL}) {
    expose(scene, whole(scene, facet), track, {}, 1, used);
  }
  const SurfaceCell place = middle(scene, 0);
  expose(scene, place, track, {}, 1, used);
  const Exposure fresh = exposure_of(place, track), other = exposure_of(place, track, {}, 2);
  CHECK(used.sun_cosine == fresh.sun_cosine);
  CHECK(used.rays == fresh.rays);
  REQUIRE(used.seen.size() == fresh.seen.size());
  CHECK(used.seen[0].sky_fraction == fresh.seen[0].sky_fraction);
  REQUIRE(used.seen[0].patches.size() == fresh.seen[0].patches.size());
  REQUIRE_FALSE(fresh.seen[0].patches.empty());
  for (std::size_t i = 0; i < fresh.seen[0].patches.size(); ++i) {
    const SurroundingPatch &a = used.seen[0].patches[i], &b = fresh.seen[0].patches[i];
    CHECK(a.material == b.material);
    CHECK(a.view_factor == b.view_factor);
    CHECK(a.sky_fraction == b.sky_fraction);
    CHECK(a.normal == b.normal);
    CHECK(a.sun_cosine == b.sun_cosine);
  }
  CHECK(other.sun_cosine != fresh.sun_cosine);
}
