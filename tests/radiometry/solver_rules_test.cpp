#include <cmath>

#include "radiometry/quad_hemisphere.hpp"
#include "radiometry/sample_allocation.hpp"
#include "radiometry/small_scene.hpp"
#include "radiometry/thresholds.hpp"
#include "support/catch.hpp"

// The rules of the generic solver: how many rays of which kind, and what the thresholds do to them.

namespace nadir::radiometry::test {
namespace {

const spectral::Lanes one_lane_solver_rules{{0.55_um}};

TEST_CASE("quads have equal solid angle and cover the hemisphere", "[radiometry]") {
  const QuadHemisphere quads{5, 7};
  CHECK(quads.count() * quads.solid_angle() == Approx(2.0 * std::numbers::pi).epsilon(1e-15));
  // The first moment of the hemisphere is pi along the normal: stratified midpoints find it exactly
  // in mu, and nothing across.
  Vec3 moment;
  for (int quad = 0; quad < quads.count(); ++quad) {
    moment += quads.centre(quad) * quads.solid_angle();
  }
  CHECK(moment.z == Approx(std::numbers::pi).epsilon(1e-14));
  CHECK(std::hypot(moment.x, moment.y) < 1e-14);
}

TEST_CASE("directions of a quad stay inside it and above the surface", "[radiometry]") {
  const QuadHemisphere quads{3, 4};
  for (const double u : {0.0, 0.5, 1.0 - 0x1p-32}) {
    for (const double v : {0.0, 0.5, 1.0 - 0x1p-32}) {
      for (int quad = 0; quad < quads.count(); ++quad) {
        const Vec3 d = quads.direction(quad, {u, v});
        CHECK(length(d) == Approx(1.0).epsilon(1e-14));
        CHECK(d.z > 0.0);
        const int ring = quad / 4;
        CHECK(d.z >= ring / 3.0);
        CHECK(d.z <= (ring + 1) / 3.0 + 1e-15);
      }
    }
  }
}

TEST_CASE("the number of full samples decays as ceil(initial / decay^g)", "[radiometry]") {
  const int expected[] = {100, 50, 25, 13, 7};
  for (int g = 0; g < 5; ++g) CHECK(full_sample_count(100, 2.0, g) == expected[g]);
  CHECK(full_sample_count(0, 2.0, 0) == 0);
  CHECK(full_sample_count(5, 1.0, 40) == 5);
}

TEST_CASE("samples are dealt out in proportion to importance, all of them", "[radiometry]") {
  const double importance[] = {0.5, 0.0, 2.0, 1.25, 0.25};
  double mean[5] = {};
  const int draws = 1000;
  for (int k = 0; k < draws; ++k) {
    SystematicAllocation allocation{6, 4.0, (k + 0.5) / draws};
    int total = 0;
    for (int bin = 0; bin < 5; ++bin) {
      const auto share = allocation.next(importance[bin]);
      CHECK(share.count >= std::floor(share.expected));
      CHECK(share.count <= std::ceil(share.expected));
      total += share.count;
      mean[bin] += share.count / static_cast<double>(draws);
    }
    REQUIRE(total == 6);
  }
  // u runs over a grid of 1000 midpoints: a bin's mean is off by at most two grid steps.
  for (int bin = 0; bin < 5; ++bin) CHECK(mean[bin] == Approx(importance[bin] * 1.5).margin(0.002));
}

SmallScene floor_and_wall(double reflectance) {
  SmallScene scene;
  const auto material = scene.material(grey(reflectance), Kelvin{0.0});
  scene.add(geometry::Plane{{0.0, 0.0, 0.0}, 100.0, 100.0}, material);
  scene.add(geometry::Box{{1.0, -50.0, 0.0}, {2.0, 50.0, 50.0}}, material);
  scene.sky(1.0);
  return scene;
}

TEST_CASE("full samples and top-up come in the numbers that the settings say", "[radiometry]") {
  SmallScene scene;
  scene.add(geometry::Plane{{0.0, 0.0, 0.0}, 10.0, 10.0}, scene.material(grey(0.5), Kelvin{0.0}));
  scene.sky(1.0);
  scene.solver = {
      .initial_sample_count = 7, .mu_samples = 3, .phi_samples = 4, .min_quad_samples = 2};
  const Counters all = measure(scene.build(), one_lane_solver_rules, downward(), 2, 50).counters;
  CHECK(all.primary_rays == 100);
  CHECK(all.full_samples == 700);  // all rays leave to the sky: one generation only
  // Twelve quads hold at least two samples each; no quad's share of seven exceeds two.
  CHECK(all.full_samples + all.direct_only_samples == 2400);
  CHECK(all.target_rays == 0);
}

TEST_CASE("targets are taken from the budget of full samples", "[radiometry]") {
  SmallScene scene;
  scene.add(geometry::Plane{{0.0, 0.0, 0.0}, 10.0, 10.0}, scene.material(grey(0.5), Kelvin{0.0}));
  scene.add_body(0.0, 50.0, 0.266, 1000.0);
  scene.add_body(90.0, 20.0, 0.266, 1.0);
  scene.add_body(90.0, -5.0, 0.266, 1.0);  // below the horizon: neither sampled nor charged
  scene.solver.initial_sample_count = 5;
  const Counters all = measure(scene.build(), one_lane_solver_rules, downward(), 1, 10).counters;
  CHECK(all.target_rays == 20);
  CHECK(all.full_samples == 30);
}

TEST_CASE("a dark surface is treated by the thresholds' own values", "[radiometry]") {
  using namespace thresholds;
  struct Case {
    double reflectance;
    bool full, direct_only;
  };
  // With view weight 1 the sample weight is reflectance times cosine; the cosine is at most 1, and
  // one quad ring of 0.5..1 keeps it above a half.
  const Case cases[] = {{4.0 * full_background_weight, true, false},
                        {0.9 * full_background_weight, false, true},
                        {2.0 * raw_weight, false, true},
                        {0.9 * raw_weight, false, false}};
  for (const Case& c : cases) {
    CAPTURE(c.reflectance);
    SmallScene scene = floor_and_wall(c.reflectance);
    scene.solver = {.initial_sample_count = 4, .mu_samples = 1, .phi_samples = 4};
    const Counters all = measure(scene.build(), one_lane_solver_rules, downward(), 1, 64).counters;
    CHECK((all.full_samples > 0) == c.full);
    CHECK((all.full_samples + all.direct_only_samples > 0) == (c.full || c.direct_only));
    CHECK((all.raw_weight_skips > 0) == !(c.full || c.direct_only));
  }
}

TEST_CASE("full samples lose weight from bounce to bounce until they are downgraded",
          "[radiometry]") {
  // The second generation's weight is about 0.0011^2 = 1.2e-6: no full sample leaves it.
  SmallScene scene = floor_and_wall(0.0011);
  scene.solver = {.initial_sample_count = 8,
                  .sample_decay_rate = 1.0,
                  .max_bounces = 9,
                  .mu_samples = 2,
                  .phi_samples = 4};
  const Counters all = measure(scene.build(), one_lane_solver_rules, downward(), 1, 200).counters;
  CHECK(all.full_weight_downgrades > 0);
  CHECK(all.bounce_limit_stops == 0);
}

TEST_CASE("a ray of too little weight gets only the self-emission of what it hits",
          "[radiometry]") {
  SmallScene scene;
  scene.add(geometry::Plane{{0.0, 0.0, 0.0}, 10.0, 10.0}, scene.material(grey(0.4), 300.0_K));
  scene.sky(1000.0);
  const SceneDescription description = scene.build();
  Diagnostics diagnostics;
  const LitScene lit{description, spectral::Lanes{{10.0_um}}, diagnostics};
  const auto hit = description.geometry.intersect(downward());
  REQUIRE(hit.has_value());
  const double emitted = 0.6 * spectral::planck(10.0_um, 300.0_K).value;
  GenericSolver solver{lit};
  const auto seen = [&](double weight) {
    return static_cast<double>(solver.surface_radiance(downward(), *hit, Sampler{1, 0}, weight)[0]);
  };
  CHECK(seen(0.9 * thresholds::current_weight) == Approx(emitted).epsilon(1e-6));
  CHECK(solver.counters().current_weight_stops == 1);
  CHECK(solver.counters().direct_only_samples == 0);
  CHECK(seen(1.1 * thresholds::current_weight) > 300.0);  // 0.4 of the sky's 1000
  CHECK(solver.counters().current_weight_stops == 1);
}

TEST_CASE("a sun half below the scene's horizon gives half its light", "[radiometry]") {
  // A vertical wall faces a sun on the horizon: the cosine is 1, the horizon cuts the disc in two.
  SmallScene scene;
  scene.add(geometry::Disc{{0.0, 0.0, 0.0}, {0.0, -1.0, 0.0}, 1.0},
            scene.material(grey(1.0), Kelvin{0.0}));
  scene.add_body(180.0, 0.0, 0.266, 1000.0);
  scene.solver.min_quad_samples = 0;
  scene.solver.initial_sample_count = 0;
  const auto seen =
      measure(scene.build(), one_lane_solver_rules, {{0.0, -5.0, 0.0}, {0.0, 1.0, 0.0}}, 16, 64);
  // 64 scrambled points split an area in two to better than 1/64 each, 16 replicates average that.
  CHECK(seen.lanes[0].mean == Approx(500.0 * std::numbers::inv_pi).epsilon(0.01));
}

TEST_CASE("a wide disc brings its irradiance on a plane normal to it", "[radiometry]") {
  // E is defined on that plane, so that an overhead disc gives rho E / pi whatever its radius.
  const double radius_deg = GENERATE(0.266, 10.0, 45.0, 80.0);
  SmallScene scene;
  scene.add(geometry::Disc{{0.0, 0.0, 0.0}, {0.0, 0.0, 1.0}, 1.0},
            scene.material(grey(1.0), Kelvin{0.0}));
  scene.add_body(0.0, 90.0, radius_deg, 1000.0);
  scene.solver = {.initial_sample_count = 0, .min_quad_samples = 0};
  const Estimate seen = measure(scene.build(), one_lane_solver_rules, downward(), 16, 64).lanes[0];
  CAPTURE(radius_deg, seen.mean);
  CHECK(std::abs(seen.mean - 1000.0 * std::numbers::inv_pi) <
        4.0 * seen.standard_error + 1e-5 * seen.mean);
  CHECK(seen.standard_error < 0.002 * seen.mean);
}

TEST_CASE("a budget that targets use up is counted", "[radiometry]") {
  SmallScene scene;
  scene.add(geometry::Plane{{0.0, 0.0, 0.0}, 10.0, 10.0}, scene.material(grey(0.5), Kelvin{0.0}));
  scene.add_body(0.0, 50.0, 0.266, 1000.0);
  scene.solver.initial_sample_count = 1;
  const Counters all = measure(scene.build(), one_lane_solver_rules, downward(), 1, 10).counters;
  CHECK(all.budget_stops == 10);
  CHECK(all.full_samples == 0);
}

TEST_CASE("a dark body costs no rays", "[radiometry]") {
  SmallScene scene;
  scene.add(geometry::Plane{{0.0, 0.0, 0.0}, 10.0, 10.0}, scene.material(grey(0.5), Kelvin{0.0}));
  scene.add_body(0.0, 50.0, 0.266, 0.0);
  CHECK(measure(scene.build(), one_lane_solver_rules, downward(), 1, 10).counters.target_rays == 0);
}

TEST_CASE("the sun's disc is seen in part where an edge cuts it", "[radiometry]") {
  // A screen whose edge points at the centre of the sun, overhead.
  SmallScene scene;
  const auto material = scene.material(grey(1.0), Kelvin{0.0});
  scene.add(geometry::Disc{{0.0, 0.0, 0.0}, {0.0, 0.0, 1.0}, 1.0}, material);
  scene.add(geometry::Box{{0.0, -500.0, 100.0}, {500.0, 500.0, 101.0}}, material);
  scene.add_body(0.0, 90.0, 0.266, 1000.0);
  scene.solver = {.initial_sample_count = 0, .min_quad_samples = 0};
  const auto seen = measure(scene.build(), one_lane_solver_rules, downward(), 16, 64);
  CHECK(seen.lanes[0].mean == Approx(500.0 * std::numbers::inv_pi).epsilon(0.01));
}

TEST_CASE("interreflection in a corner does not depend on how samples are split into kinds",
          "[radiometry]") {
  // With sun and sky on a white corner the top-up must not darken what full samples bring.
  double reference = 0.0;
  for (const int min_quad_samples : {0, 1, 4}) {
    SmallScene scene = floor_and_wall(0.8);
    scene.add_body(225.0, 45.0, 0.266, 10.0);
    scene.solver = {.initial_sample_count = 6,
                    .sample_decay_rate = 1.0,
                    .max_bounces = 2,
                    .mu_samples = 2,
                    .phi_samples = 4,
                    .min_quad_samples = min_quad_samples};
    const Estimate seen =
        measure(scene.build(), one_lane_solver_rules, downward(), 16, 64).lanes[0];
    CAPTURE(min_quad_samples, seen.mean, seen.standard_error);
    CHECK(seen.standard_error < 0.01 * seen.mean);
    if (min_quad_samples == 1) reference = seen.mean;
    // At the last generation the top-up adds one term that no minimum leaves out: at most the
    // reflected sky after three bounces, 0.8^4 of a sky of 1 times the wall's share of the view.
    if (min_quad_samples == 4) CHECK(seen.mean == Approx(reference).epsilon(0.01));
  }
}

}  // namespace
}  // namespace nadir::radiometry::test
