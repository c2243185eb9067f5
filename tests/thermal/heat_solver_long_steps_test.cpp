// The first day in long steps, and the record's first day that need not be gone through again.
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "support/catch.hpp"
#include "thermal/heat_scene.hpp"
#include "thermal/solve/heat_solver.hpp"
#include "thermal/solve/shared_stages.hpp"

namespace nadir::thermal {
namespace {

using namespace test;

std::size_t in_long_step(double step_s) {
  HeatSettings settings;
  settings.step_s = step_s;
  return make_time_grid(settings).in_long_step;
}

TEST_CASE("a long step is an hour at most and divides the day", "[thermal][heat_solver]") {
  CHECK(in_long_step(600.0) == 6);
  CHECK(in_long_step(60.0) == 60);
  CHECK(in_long_step(700.0) == 4);            // 124 steps of 697 s: 5 do not divide them
  CHECK(in_long_step(86400.0 / 139.0) == 1);  // a prime
  CHECK(in_long_step(3600.0) == 1);
  CHECK(in_long_step(21600.0) == 1);
}

TEST_CASE("a long step keeps the mean and the trend of what it is made of",
          "[thermal][heat_solver]") {
  const SharedStages shared = make_shared_stages(model_of({}));
  const SharedStages::LongSteps& steps = shared.long_steps;
  const std::size_t count = 2 * shared.grid.in_long_step;
  REQUIRE(steps.mean.size() == count);
  REQUIRE(steps.weather.size() == 48);
  const double begin_s = -day_s, long_s = 3600.0;
  const auto line = [](double time_s) { return 300.0 + 0.02 * (time_s + day_s); };
  double at_0 = 0.0, at_1 = 0.0, mean = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    const double value = line(shared.grid.stage_s(i));
    at_0 += steps.weights[0][i] * value;
    at_1 += steps.weights[1][i] * value;
    mean += steps.mean[i] * value;
  }
  // A straight line is what it is: rounding alone.
  CHECK(at_0 == Approx(line(begin_s + Column::gamma * long_s)).epsilon(1e-13));
  CHECK(at_1 == Approx(line(begin_s + long_s)).epsilon(1e-13));
  CHECK(mean == Approx(line(begin_s + 0.5 * long_s)).epsilon(1e-13));
  // Whatever runs within, the scheme's weights give the mean.
  for (std::size_t i = 0; i < count; ++i) {
    CHECK((1.0 - Column::gamma) * steps.weights[0][i] + Column::gamma * steps.weights[1][i] ==
          Approx(steps.mean[i]).epsilon(0.0).margin(1e-15));
  }
}

/// Ground beside a wall, two days of record.
struct TwoDays {
  Day day{15.0};
  HeatModel model = model_of(day);
  geometry::Scene scene =
      scene_of({surface(ground(), of_soil),
                surface({{4.0, -50.0, 0.0}, {0.0, 100.0, 0.0}, {0.0, 0.0, 6.0}}, of_wall)});

  TwoDays() {
    model.weather = fine_weather(day, 2.0);
    model.sun = sun_track(day, 600.0, 2.0);
    model.settings.history_s = 2.0 * day_s;
    model.settings.resolution_m = 4.0;
  }
};

TEST_CASE("who has seen the day that repeats begins after it", "[thermal][heat_solver]") {
  const TwoDays place;
  const HeatSolver solver{place.scene, place.model};
  HeatModel fine_model = place.model;
  fine_model.settings.spin_up_k = 1e-6;
  const HeatSolver fine{place.scene, fine_model};
  std::vector<geometry::Hit> hits;
  for (double x = -9.0; x < 12.0; x += 2.9) hits.push_back(from_above(place.scene, x, 1.0));
  for (const auto& hit : hits) {
    const double kelvin = solver.at(hit).value;
    // A fifth of spin_up_k, 0.05 K; then a day of the record. Floats lie 3e-5 K apart.
    CHECK(kelvin == Approx(fine.at(hit).value).epsilon(0.0).margin(0.01));
    CHECK(kelvin == Approx(solver.record(hit).rows.back().surface_k).epsilon(0.0).margin(0.003));
  }
  // A day of 24 hours, one of 144 steps, the record's second; now and then a day more.
  const HeatCounters counters = solver.counters();
  CHECK(counters.steps < counters.cells_on_demand * 320);
  CHECK(counters.steps >= counters.cells_on_demand * 312);
}

}  // namespace
}  // namespace nadir::thermal
