// What the solver says of its own results: where they are held, unfinished or uncertain.
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "core/constants.hpp"
#include "support/catch.hpp"
#include "thermal/heat_scene.hpp"
#include "thermal/solve/heat_solver.hpp"

namespace nadir::thermal {
namespace {

using namespace test;

geometry::Scene open_ground() { return scene_of({surface(ground(), of_soil)}); }

TEST_CASE("sound places give no cautions", "[thermal][heat_solver]") {
  const auto scene = open_ground();
  const HeatSolver solver{scene, model_of({})};
  CHECK(solver.at(from_above(scene, 1.0, 2.0)).value > 250.0);
  CHECK(solver.cautions().empty());
  CHECK(solver.counters().held == 0);
  CHECK(solver.counters().references_held == 0);
}

TEST_CASE("a place that its source would melt is held at 2000 K, which is told",
          "[thermal][heat_solver]") {
  HeatModel model = model_of({});
  model.materials[of_soil]->layers.layers[0].heat_w_m2 = 1e6;  // 2000 K radiate 0.86 MW m^-2
  const auto scene = open_ground();
  const HeatSolver solver{scene, model};
  CHECK(solver.at(from_above(scene, 1.0, 2.0)).value <= 2000.0);
  CHECK(solver.at(from_above(scene, 2.0, 1.0)).value > 900.0);
  CHECK(solver.counters().held == 2);
  CHECK(solver.counters().references_held == 2);
  const auto cautions = solver.cautions();
  REQUIRE(cautions.size() >= 2);
  CHECK(cautions[0].rfind("material 0: 2 of 2 solved cells reached 2.7 or 2000 K", 0) == 0);
}

TEST_CASE("hot insides are told even where the surface stays cold", "[thermal][heat_solver]") {
  HeatModel model = model_of({});
  // 500 W m^-2 through half a metre of wool would need 500 x 0.5 / 0.04 = 6250 K across it.
  model.materials[of_soil]->layers.layers = {{{0.04, 50.0, 1000.0}, 0.5, 0.0},
                                             {{1.0, 2000.0, 900.0}, 0.1, 500.0},
                                             {{0.04, 50.0, 1000.0}, 0.5, 0.0}};
  model.materials[of_soil]->layers.back = FixedBack{290.0_K};
  model.settings.spin_up_days = 200;
  const auto scene = open_ground();
  const HeatSolver solver{scene, model};
  const auto hit = from_above(scene, 1.0, 2.0);
  const HeatRecord record = solver.record(hit);
  for (const auto& row : record.rows) {
    CHECK(row.surface_k < 360.0);
    CHECK(row.back_k < 360.0);
  }
  CHECK(solver.at(hit).value < 360.0);
  CHECK(solver.counters().held == 1);
}

TEST_CASE("pipes that cool a rink keep it below freezing; what is cooled without end is held",
          "[thermal][heat_solver]") {
  HeatModel model = model_of({});
  model.weather = still_weather(283.0, 300.0);
  Layer& layer = model.materials[of_soil]->layers.layers[0];
  layer.thickness_m = 0.1;
  layer.heat_w_m2 = -300.0;
  model.materials[of_soil]->surface = {0.6, 0.9, FixedFilm{10.0}, 1.0, 0.0};
  model.settings.spin_up_k = 1e-4;
  const auto scene = open_ground();
  const HeatSolver solver{scene, model};
  double low = 100.0, high = 300.0;  // 0 = eps (L - sigma T^4) + h (T_air - T) - 300
  while (high - low > 1e-9) {
    const double t = 0.5 * (low + high);
    const double into =
        0.9 * (300.0 - si::stefan_boltzmann * std::pow(t, 4)) + 10.0 * (283.0 - t) - 300.0;
    (into > 0.0 ? low : high) = t;
  }
  CHECK(low < 270.0);
  CHECK(solver.at(from_above(scene, 1.0, 2.0)).value == Approx(low).epsilon(0.0).margin(3e-4));
  CHECK(solver.cautions().empty());

  layer.heat_w_m2 = -1e6;
  const HeatSolver colder{scene, model};
  CHECK(colder.at(from_above(scene, 1.0, 2.0)).value >= 2.7F * (1.0 - 1e-6));
  CHECK(colder.counters().held == 1);
  REQUIRE_FALSE(colder.cautions().empty());
}

TEST_CASE("days that do not come to repeat themselves are told, level places as well",
          "[thermal][heat_solver]") {
  HeatModel model = model_of({});
  model.settings.spin_up_days = 1;
  model.settings.spin_up_k = 1e-9;
  const auto scene = open_ground();
  const HeatSolver solver{scene, model};
  static_cast<void>(solver.at(from_above(scene, 1.0, 2.0)));
  const HeatCounters counters = solver.counters();
  CHECK(counters.not_repeating == 1);
  CHECK(counters.references_not_repeating >= 2);
  const auto cautions = solver.cautions();
  REQUIRE(cautions.size() >= 2);
  CHECK(cautions[0] ==
        "material 0: 1 of 1 solved cells did not come to repeat their day within 1 days of "
        "spin-up");
  CHECK(cautions[1].rfind("material 0: 2 of 2 level places", 0) == 0);
}

// ---- what rays leave undecided ------------------------------------------------------------------

/// Ground beside a wall.
struct Yard {
  Day day{15.0};
  HeatModel model = model_of(day);
  geometry::Scene scene =
      scene_of({surface(ground(16.0), of_soil),
                surface({{4.0, -16.0, 0.0}, {0.0, 32.0, 0.0}, {0.0, 0.0, 6.0}}, of_wall)});
  std::vector<geometry::Hit> hits;

  Yard() {
    model.settings.resolution_m = 4.0;
    model.settings.step_s = 1800.0;
    model.settings.exposure.sky_rays = 16;
    for (int i = 0; i < 12; ++i) {
      for (int j = 0; j < 4; ++j) hits.push_back(from_above(scene, -14.9 + 2.7 * i, -6.0 + 4 * j));
    }
  }
};

TEST_CASE("the error of a cell is what other rays would have made of it",
          "[thermal][heat_solver]") {
  const Yard yard;
  const HeatSolver solver{yard.scene, yard.model};
  CHECK(solver.error(64).cells == 0);
  solver.solve_ahead(yard.hits);
  const HeatCounters before = solver.counters();
  const HeatError error = solver.error(1000);
  CHECK(error.cells == before.cells_ahead);
  CHECK(error.rms_k > 0.05);
  CHECK(error.largest_k > error.rms_k);
  CHECK(solver.counters().rays == before.rays);

  // The same from solvers of other seeds: sqrt of the mean variance over cells, each of which has
  // one hit. Of six solvers either way; a few cells at the edge of a shadow carry most of it.
  REQUIRE(error.cells == yard.hits.size());
  constexpr int seeds = 6;
  double told = 0.0;
  std::vector<double> sum(yard.hits.size()), squares(yard.hits.size());
  for (std::uint64_t seed = 11; seed < 11 + seeds; ++seed) {
    const HeatSolver other{yard.scene, yard.model, seed};
    other.solve_ahead(yard.hits);
    told += std::pow(other.error(1000).rms_k, 2) / seeds;
    for (std::size_t i = 0; i < yard.hits.size(); ++i) {
      const double k = other.at(yard.hits[i]).value;
      sum[i] += k;
      squares[i] += k * k;
    }
  }
  double variance = 0.0;
  for (std::size_t i = 0; i < sum.size(); ++i) {
    variance += (squares[i] - sum[i] * sum[i] / seeds) / (seeds - 1);
  }
  const double expected = std::sqrt(variance / static_cast<double>(sum.size()));
  CHECK(std::sqrt(told) == Approx(expected).epsilon(0.2));
}

TEST_CASE("which cells are tried for their error depends on what is solved alone",
          "[thermal][heat_solver]") {
  const Yard yard;
  const HeatSolver one{yard.scene, yard.model}, other{yard.scene, yard.model};
  one.solve_ahead(yard.hits);
  for (auto hit = yard.hits.rbegin(); hit != yard.hits.rend(); ++hit) {
    static_cast<void>(other.at(*hit));
  }
  const HeatError a = one.error(7), b = other.error(7);
  CHECK(a.cells == 7);
  CHECK(a.rms_k == b.rms_k);
  CHECK(a.largest_k == b.largest_k);
}

TEST_CASE("open ground has no error from rays", "[thermal][heat_solver]") {
  const auto scene = open_ground();
  const HeatSolver solver{scene, model_of({})};
  static_cast<void>(solver.at(from_above(scene, 1.0, 2.0)));
  static_cast<void>(solver.at(from_above(scene, 2.0, 1.0)));
  const HeatError error = solver.error(5);
  CHECK(error.cells == 2);
  // Half the disc of a sun that rises is down: a ray may find it or not, a cosine of 1e-3 then.
  CHECK(error.largest_k < 2e-3);
}

}  // namespace
}  // namespace nadir::thermal
