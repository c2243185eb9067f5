#include <array>
#include <map>

#include "core/transform.hpp"
#include "support/catch.hpp"
#include "thermal/exposure/exposure.hpp"
#include "thermal/exposure_scene.hpp"

using namespace nadir;
using namespace nadir::thermal;
using namespace nadir::thermal::test;

namespace {

constexpr int many = 8192;

/// Four standard deviations of a share p of independent rays.
double four_sigma(double p) { return 4.0 * std::sqrt(p * (1.0 - p) / many); }

double sum_of(const SurroundingsSeen& seen) {
  double sum = seen.sky_fraction;
  for (const SurroundingPatch& patch : seen.patches) sum += patch.view_factor;
  return sum;
}

/// A yard: ground, walls of two materials, a post and a roof over a part of it.
geometry::Scene yard() {
  geometry::SceneBuilder builder;
  builder.add(at_times(geometry::Plane{{}, 41.0, 41.0}, 1), {}, 0);
  builder.add(at_times(geometry::Box{{4, -8, 0}, {5, 8, 6}}, 2), {}, 1);
  builder.add(at_times(geometry::Box{{-8, 4, 0}, {4, 5, 4}}, 3), {}, 2);
  builder.add(at_times(geometry::Cylinder{{-2, -2, 0}, {-2, -2, 5}, 0.3, true}, 4), {}, 3);
  builder.add(at_times(geometry::Box{{-8, -2, 3}, {-3, 4, 3.2}}, 5), {}, 4);
  return builder.build();
}

}  // namespace

// F12 by the exact closed forms (Howell, "A Catalog of Radiation Heat Transfer Configuration
// Factors", C-11 and C-14), evaluated to 8 digits.
TEST_CASE("rectangles see one another by their view factors") {
  struct Case {
    double a, b, gap, factor;
  };
  const Case parallel[]{{1, 1, 1, 0.19982490},
                        {1, 1.5, 0.5, 0.47557644},
                        {2, 2, 1, 0.41525328},
                        {10, 10, 1, 0.82699452}};
  const ExposureSettings settings{many, 0, 3600.0};
  const SunTrack track = track_of({towards(0, 10), towards(0, 10)});
  for (const Case& c : parallel) {
    geometry::SceneBuilder builder;
    builder.add(at_times(geometry::Plane{{}, c.a, c.b}, 1), {}, 0);
    builder.add(at_times(geometry::Plane{{0, 0, c.gap}, c.a, c.b}, 2), {}, 1);
    const geometry::Scene scene = builder.build();
    const Exposure seen = exposure_of(whole(scene, 0), track, settings);
    CAPTURE(c.a, c.b, c.gap);
    CHECK(view_factor_of(seen.seen[0], 2) == Approx(c.factor).margin(four_sigma(c.factor)));
    CHECK(seen.seen[0].sky_fraction == Approx(1.0 - c.factor).margin(four_sigma(c.factor)));
  }
  // Width of the one, height of the other, length of the edge between them.
  const Case upright[]{
      {1, 1, 1, 0.20004378}, {1, 2, 1, 0.23285260}, {2, 1, 1, 0.11642630}, {0.5, 3, 1, 0.31960896}};
  for (const Case& c : upright) {
    geometry::SceneBuilder builder;
    builder.add(at_times(geometry::Plane{{0.5 * c.a, 0, 0}, c.a, c.gap}, 1), {}, 0);
    const Affine raised{rotation({0, 1, 0}, 90.0 * degree), {0, 0, 0.5 * c.b}};
    builder.add(at_times(geometry::Plane{{}, c.b, c.gap}, 2), raised, 1);
    const geometry::Scene scene = builder.build();
    const Exposure seen = exposure_of(whole(scene, 0), track, settings);
    CAPTURE(c.a, c.b, c.gap);
    CHECK(view_factor_of(seen.seen[0], 2) == Approx(c.factor).margin(four_sigma(c.factor)));
  }
}

// Coaxial discs, the same source (C-41). A disc's pieces are even in the radius, not in the area:
// rings are weighed by theirs.
TEST_CASE("discs see one another by their view factors") {
  struct Case {
    double r1, r2, gap, factor;
  };
  const Case cases[]{{1, 1, 1, 0.38196601}, {1, 2, 1, 0.76393202}, {0.5, 0.5, 2, 0.05572809}};
  constexpr std::uint32_t rings = 16;
  const ExposureSettings settings{many / static_cast<int>(rings), 0, 3600.0};
  const SunTrack track = track_of({towards(0, 10), towards(0, 10)});
  for (const Case& c : cases) {
    geometry::SceneBuilder builder;
    builder.add(at_times(geometry::Disc{{}, {0, 0, 1}, c.r1}, 1), {}, 0);
    builder.add(at_times(geometry::Disc{{0, 0, c.gap}, {0, 0, 1}, c.r2}, 2), {}, 1);
    const geometry::Scene scene = builder.build();
    double factor = 0.0;
    for (std::uint32_t ring = 0; ring < rings; ++ring) {
      const SurfaceCell cell{&scene, 0, false, {rings, 1, false}, ring};
      const double area = (2.0 * ring + 1.0) / (rings * rings);
      factor += area * view_factor_of(exposure_of(cell, track, settings).seen[0], 2);
    }
    CAPTURE(c.r1, c.r2, c.gap);
    CHECK(factor == Approx(c.factor).margin(four_sigma(c.factor)));
  }
}

TEST_CASE("what a place sees adds up to the whole hemisphere, whatever is followed") {
  const geometry::Scene scene = yard();
  const int followed = GENERATE(0, 1, 3, 8, 64);
  const ExposureSettings settings{64, followed, 3600.0};
  for (std::uint64_t facet = 0; facet < scene.facets(); ++facet) {
    const Exposure seen = exposure_of(whole(scene, facet), overhead_track(), settings);
    CAPTURE(facet, followed);
    CHECK(sum_of(seen.seen[0]) == Approx(1.0).epsilon(1e-12));
    for (const SurroundingPatch& patch : seen.seen[0].patches) {
      CHECK(patch.view_factor > 0.0);
      CHECK(patch.sky_fraction >= 0.0);
      CHECK(patch.sky_fraction <= 1.0);
      CHECK(length(patch.normal) == Approx(1.0).epsilon(1e-12));
      const bool is_sunless = followed == 0 && patch.material != ground_about;
      CHECK(patch.sun_cosine.size() == (is_sunless ? 0U : 13U));
    }
    // At most the wanted number, and one for each of five materials and the ground about.
    CHECK(seen.seen[0].patches.size() <= static_cast<std::size_t>(followed) + 6);
  }
}

TEST_CASE("the shares of materials do not depend on what is followed") {
  const geometry::Scene scene = yard();
  std::map<std::uint32_t, double> shares;
  for (const int followed : {64, 8, 2, 0}) {
    const Exposure seen = exposure_of(middle(scene, 0), overhead_track(), {128, followed, 3600.0});
    std::map<std::uint32_t, double> now;
    for (const SurroundingPatch& patch : seen.seen[0].patches) {
      now[patch.material] += patch.view_factor;
    }
    if (shares.empty()) shares = now;
    CHECK(now.size() >= 4);
    REQUIRE(now.size() == shares.size());
    for (const auto& [material, share] : now) {
      CHECK(share == Approx(shares[material]).epsilon(1e-12));
    }
  }
}

TEST_CASE("a wall that is seen has the sun while it faces it and nothing stands before it") {
  geometry::SceneBuilder builder;
  builder.add(at_times(geometry::Plane{{}, 21.0, 21.0}, 1), {}, 0);
  builder.add(at_times(geometry::Box{{-50, 4, 0}, {50, 5, 40}}, 2), {}, 1);
  builder.add(at_times(geometry::Box{{-200, -60, 0}, {-50, 4, 400}}, 3), {}, 2);
  const geometry::Scene scene = builder.build();
  // The sun goes from east over south to west at 30 degrees; the wall faces south, and west of it
  // a tower takes the sun away once it stands there.
  std::vector<Vec3> directions;
  for (int i = 0; i <= 72; ++i) directions.push_back(towards(45.0 + 3.75 * i, 30.0));
  const SunTrack track = track_of(directions);
  const Exposure seen = exposure_of(middle(scene, 0), track, {64, 8, 3600.0});
  int walls = 0;
  for (const SurroundingPatch& patch : seen.seen[0].patches) {
    if (patch.material != 2) continue;
    ++walls;
    CHECK(length(patch.normal - Vec3{0, -1, 0}) < 1e-12);
    CHECK(patch.sky_fraction == 0.5);
    REQUIRE(patch.sun_cosine.size() == 13);
    for (std::size_t i = 0; i < 13; ++i) {
      const double azimuth = 45.0 + 22.5 * static_cast<double>(i);
      const double facing = std::max(0.0, -towards(azimuth, 30.0).y);
      CAPTURE(azimuth);
      if (azimuth < 185.0) {
        CHECK(static_cast<double>(patch.sun_cosine[i]) == Approx(facing).margin(1e-6));
      }
      if (azimuth > 250.0) CHECK(patch.sun_cosine[i] == 0.0F);
    }
  }
  CHECK(walls >= 4);
}

TEST_CASE("a patch of surroundings is in the shade of what is there at the moment") {
  geometry::SceneBuilder builder;
  const std::uint32_t before = 2U;
  builder.add(at_times(geometry::Plane{{}, 21.0, 21.0}, 1), {}, 0);
  builder.add(at_times(geometry::Box{{-50, 4, 0}, {50, 5, 40}}, 2), {}, 1);
  builder.add(at_times(geometry::Box{{-200, -31, 0}, {200, -30, 400}}, 3, before), {}, 2);
  const geometry::Scene scene = builder.build();
  // Twelve hours, the sun low in the south; what hides it leaves after 5 h 20 min.
  SunTrack track = track_of(std::vector<Vec3>(37, towards(180.0, 40.0)), 1200.0);
  for (std::size_t i = 0; i < 17; ++i) track.epoch[i] = before;
  const Exposure seen = exposure_of(middle(scene, 0), track, {64, 8, 3600.0});
  int walls = 0;
  for (const SurroundingPatch& patch : seen.seen[1].patches) {
    if (patch.material != 2) continue;
    ++walls;
    REQUIRE(patch.sun_cosine.size() == 13);
    for (std::size_t i = 0; i < 13; ++i) CHECK((patch.sun_cosine[i] > 0.0F) == (i >= 6));
  }
  CHECK(walls >= 4);
  // At intervals that do not fall on the track's moments, that of the nearest counts.
  const Exposure between = exposure_of(middle(scene, 0), track, {64, 8, 500.0});
  const std::vector<float>& cosine = between.seen[1].patches.back().sun_cosine;
  REQUIRE(cosine.size() == 87);
  CHECK(cosine[39] == 0.0F);  // 19,500 s after the first; halfway to its 18th stands 19,800 s
  CHECK(cosine[40] > 0.0F);
}

TEST_CASE("where little is about nothing is followed") {
  geometry::SceneBuilder builder;
  builder.add(at_times(geometry::Plane{{}, 201.0, 201.0}, 1), {}, 0);
  builder.add(at_times(geometry::Box{{30, -1, 0}, {31, 1, 8}}, 2), {}, 1);
  const geometry::Scene scene = builder.build();
  const Exposure seen = exposure_of(middle(scene, 0), overhead_track(), {1024, 8, 3600.0});
  // A tower of 2 by 8 m at 30 m takes up about 0.002.
  CHECK(view_factor_of(seen.seen[0], 2) < 0.02);
  CHECK(view_factor_of(seen.seen[0], 2) > 0.0);
  // One ray a moment, 7 more in the last 6 and where the tower's shadow comes or goes.
  CHECK(seen.rays <= 361 + 12 * 7 + 1024);
}

TEST_CASE("patches stand for what they were drawn from: half of the ground about is in the shade") {
  geometry::SceneBuilder builder;
  builder.add(at_times(geometry::Plane{{}, 400.0, 400.0}, 1), {}, 0);
  // Above the western half hangs a roof, and over the place a small sheet that looks down.
  builder.add(at_times(geometry::Plane{{-100, 0, 30}, 200.0, 400.0}, 2), {}, 1);
  builder.add(at_times(geometry::Plane{{0, 0, 2}, 0.1, 0.1}, 3), {}, 2);
  const geometry::Scene scene = builder.build();
  const SunTrack track = track_of(std::vector<Vec3>(7, towards(90.0, 89.9)));
  double lit = 0.0, all = 0.0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    const Exposure seen = exposure_of(whole(scene, 2, true), track, {64, 8, 3600.0}, seed);
    for (const SurroundingPatch& patch : seen.seen[0].patches) {
      all += patch.view_factor;
      if (patch.sun_cosine.front() > 0.5F) lit += patch.view_factor;
    }
  }
  // 320 patches, of which those across the border are random.
  CHECK(lit / all == Approx(0.5).margin(0.03));
}
