// What a place gets by way of its surroundings.
#include <cmath>

#include "core/constants.hpp"
#include "support/catch.hpp"
#include "thermal/heat_scene.hpp"
#include "thermal/solve/heat_solver.hpp"
#include "thermal/solve/side_load.hpp"

namespace nadir::thermal {
namespace {

using namespace test;

double sigma_t4(double t) { return si::stefan_boltzmann * t * t * t * t; }

TEST_CASE("in a closed room of one temperature everything has that temperature",
          "[thermal][heat_solver]") {
  const Day day{13.0};
  HeatModel model = model_of(day);  // in full sun: nothing of it gets in
  model.surroundings[of_wall] = {0.5, GENERATE(0.9, 0.4), 305.0_K};
  model.materials[of_soil]->surface = {0.8, 0.7, FixedFilm{0.0}, 1.0, 0.0};
  model.settings.spin_up_k = 1e-3;
  const auto scene = scene_of({geometry::Surface{geometry::Box{{-3, -3, 0}, {3, 3, 3}}, {of_wall}},
                               surface({{-1, -1, 1}, {2, 0, 0}, {0, 2, 0}}, of_soil)});
  const HeatSolver solver{scene, model};
  // The floor of the shelf and its underside
  for (const double from : {2.0, 0.5}) {
    const auto hit = looking(scene, {0.1, 0.2, from}, {0.1, 0.2, 1.0});
    const HeatRecord record = solver.record(hit);
    CHECK(record.sky_fraction == 0.0);
    CHECK(record.rows.back().terms.reflected == 0.0);
    CHECK(record.rows.back().surface_k == Approx(305.0).epsilon(0.0).margin(2e-3));
  }
}

TEST_CASE("both sides of an open sheet are one", "[thermal][heat_solver]") {
  const Day day{10.0};
  const auto scene =
      scene_of({surface(ground(), of_soil), surface({{0, -2, 1}, {1, 0, 2}, {0, 4, 0}}, of_sheet)});
  const Vec3 middle{0.52, 0.01, 2.04};
  const auto from_east = looking(scene, middle + Vec3{3.0, 0.0, -1.0}, middle);
  const auto from_west = looking(scene, middle + Vec3{-3.0, 0.0, 1.0}, middle);
  REQUIRE(from_east.back_face != from_west.back_face);
  const HeatSolver solver{scene, model_of(day)}, other{scene, model_of(day)};
  const double east = solver.at(from_east).value;
  CHECK(solver.at(from_west).value == east);
  CHECK(other.at(from_west).value == east);
  CHECK(solver.counters().cells_on_demand == 1);
  const HeatRecord lit = solver.record(from_east), dark = solver.record(from_west);
  CHECK(lit.rows.back().surface_k == dark.rows.back().surface_k);
  CHECK(lit.rows.back().sun_cosine != dark.rows.back().sun_cosine);
  CHECK(lit.rows.back().terms.sum() == dark.rows.back().terms.sum());
}

TEST_CASE("a level sheet exchanges with the sky above and the ground beneath",
          "[thermal][heat_solver]") {
  HeatModel model = model_of({});
  model.weather = still_weather(285.0, 260.0);
  model.materials[of_sheet]->surface = {0.5, 0.8, FixedFilm{6.0}, 1.0, 0.0};
  model.ground_about = {0.2, 0.9, 295.0_K};
  const auto scene = scene_of({surface({{-2, -2, 5}, {4, 0, 0}, {0, 4, 0}}, of_sheet)});
  // The ground reflects the sky's long-wave radiation.
  const double from_below = 0.9 * sigma_t4(295.0) + 0.1 * 260.0;
  double low = 200.0, high = 320.0;
  while (high - low > 1e-9) {
    const double t = 0.5 * (low + high);
    const double into = 0.8 * (260.0 + from_below - 2.0 * sigma_t4(t)) + 2.0 * 6.0 * (285.0 - t);
    (into > 0.0 ? low : high) = t;
  }
  CHECK(HeatSolver(scene, model).at(from_above(scene, 0.3, 0.2)).value ==
        Approx(low).epsilon(0.0).margin(2e-3));  // one millimetre: a day forgets everything
}

TEST_CASE("a wall over open ground gets half of what the ground reflects",
          "[thermal][heat_solver]") {
  const Day day{12.0};
  HeatModel model = model_of(day);
  model.settings.exposure.sky_rays = 256;
  const auto scene = scene_of(
      {surface(ground(2000.0), of_soil), surface({{-5, 0, 0}, {10, 0, 0}, {0, 0, 8}}, of_sheet)});
  // Faces south, -y: towards the sun.
  const HeatSolver solver{scene, model};
  const auto record = solver.record(looking(scene, {0.3, -20.0, 1.2}, {0.3, 0.0, 1.2}));
  const auto& noon = record.rows.back();
  const double level =
      noon.weather.direct_normal_w_m2 * day.sun(0.0).z + noon.weather.diffuse_horizontal_w_m2;
  // The other side sees the ground in the wall's shadow by day's middle; the sheet's terms count
  // both. The front alone: half the hemisphere, 0.2 of it back, 0.7 absorbed.
  const double front = 0.7 * 0.5 * 0.2 * level;
  CHECK(noon.terms.reflected > 0.95 * front);
  CHECK(noon.terms.reflected < 2.0 * front);
  CHECK(record.sky_fraction == Approx(0.5).margin(0.03));  // 256 rays, scrambled Sobol
}

SharedStages stages_of(const HeatModel& model) {
  SharedStages shared = make_shared_stages(model);
  shared.surroundings[of_soil] = shared.surroundings[of_wall];
  return shared;
}

TEST_CASE("the surroundings' factors: a cavity is black, open ground is itself",
          "[thermal][heat_solver]") {
  HeatModel model = model_of({12.0});
  model.surroundings[of_wall] = {0.4, 0.7, 300.0_K};
  const SharedStages shared = stages_of(model);
  SurroundingsFactors factors;
  SECTION("cavity") {
    const SurroundingPatch floor{of_wall, 0.3, 1.0, {0, 0, 1}, {}};
    const SurroundingPatch wall{of_wall, 0.7, 0.5, {1, 0, 0}, {}};
    find_factors(model, shared, {0.0, {floor, wall}}, 0.0, factors);
    REQUIRE(factors.emissions.size() == 1);
    CHECK(factors.emissions[0].shaded + factors.emissions[0].lit == Approx(1.0).epsilon(1e-12));
    CHECK(factors.reflected_long_wave == 0.0);
    CHECK(factors.reflected_sky == 0.0);
  }
  SECTION("open ground in the sun, seen by a wall") {
    SurroundingPatch level{of_wall, 0.5, 1.0, {0, 0, 1}, shared.level_patch_cosine};
    find_factors(model, shared, {0.5, {level}}, 0.0, factors);
    REQUIRE(factors.emissions.size() == 1);
    // 1e-7: its sun is kept in floats
    CHECK(factors.emissions[0].lit == Approx(0.5 * 0.7).epsilon(1e-7));
    CHECK(factors.emissions[0].shaded == Approx(0.0).margin(1e-7));
    CHECK(factors.reflected_long_wave == Approx(0.5 * 0.3).epsilon(1e-7));
    CHECK(factors.reflected_sky == Approx(0.5 * 0.4).epsilon(1e-7));
  }
  SECTION("a street: walls of which some see the sky, some each other") {
    // The place itself, level, sees 0.6 of its sky: openness 0.6, as no patch could have the sun.
    const SurroundingPatch wall{of_wall, 0.4, 0.5, {0, 1, 0}, {}};
    find_factors(model, shared, {0.6, {wall}}, 1.0, factors);
    REQUIRE(factors.emissions.size() == 1);
    // s = 0.5 x 0.6 = 0.3; B = (eps E + (1 - eps) s L) / (1 - (1 - eps) (1 - s))
    const double closed_heat = 1.0 / (1.0 - 0.3 * 0.7), closed_light = 1.0 / (1.0 - 0.4 * 0.7);
    CHECK(factors.emissions[0].shaded == Approx(0.4 * 0.7 * closed_heat).epsilon(1e-12));
    CHECK(factors.reflected_long_wave == Approx(0.4 * 0.3 * 0.3 * closed_heat).epsilon(1e-12));
    CHECK(factors.reflected_sky == Approx(0.4 * 0.4 * 0.3 * closed_light).epsilon(1e-12));
  }
  SECTION("a white cavity without an end stays finite") {
    model.surroundings[of_wall] = {1.0, 0.0, 300.0_K};
    const SurroundingPatch wall{of_wall, 1.0, 0.5, {1, 0, 0}, {}};
    find_factors(model, shared, {0.0, {wall}}, 0.0, factors);
    CHECK(std::isfinite(factors.reflected_sky));
    CHECK(std::isfinite(factors.reflected_long_wave));
  }
}

TEST_CASE("the scene changes half-way between two moments of the sun's track",
          "[thermal][heat_solver]") {
  HeatModel model = model_of({12.0});
  model.sun = sun_track({12.0}, 3600.0);
  for (std::size_t i = 0; i < 20; ++i) model.sun.epoch[i] = 2;  // up to 5 h before the picture
  const SharedStages shared = make_shared_stages(model);
  REQUIRE(shared.epochs == std::vector<std::uint32_t>{2, 1});
  REQUIRE(shared.runs.size() == 2);
  CHECK(shared.runs[0].begin == 0);
  // 4.5 h before is the end of step 117; from there on, its second stage included, it is new.
  CHECK(shared.runs[0].end == 2 * 116 + 1);
  CHECK(shared.runs[1].end == 288);
}

TEST_CASE("a map of materials is as warm as the material that it names", "[thermal][heat_solver]") {
  const Day day{13.0};
  HeatModel model = model_of(day);
  model.surroundings.push_back({0.2, 0.95, OfItsHeatBalance{of_soil}});
  const auto scene = [](std::uint32_t material) {
    return scene_of(
        {surface(ground(), material), surface({{-5, 0, 0}, {10, 0, 0}, {0, 0, 8}}, of_sheet)});
  };
  const auto of_map = scene(3), own = scene(of_soil);
  const auto hit = looking(own, {0.3, -20.0, 1.2}, {0.3, 0.0, 1.2});
  CHECK(HeatSolver(of_map, model).at(hit).value == HeatSolver(own, model).at(hit).value);
}

}  // namespace
}  // namespace nadir::thermal
