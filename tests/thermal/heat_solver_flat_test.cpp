// Open ground: what the solver makes of a place whose loads anyone can write down.
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "core/constants.hpp"
#include "support/catch.hpp"
#include "thermal/heat_scene.hpp"
#include "thermal/solve/heat_solver.hpp"
#include "thermal/solve/material_heat.hpp"

namespace nadir::thermal {
namespace {

using namespace test;

/// The sun's height between the moments of its track, as the solver has it.
double level_cosine(const Day& day, double time_s, double interval_s) {
  const double before = std::floor(time_s / interval_s) * interval_s;
  const double share = (time_s - before) / interval_s;
  const auto cosine = [&](double t) { return std::max(0.0, day.sun(t).z); };
  return (1.0 - share) * cosine(before) + share * cosine(before + interval_s);
}

SurfaceLoad open_load(const HeatModel& model, const Day& day, double time_s) {
  const WeatherState now = model.weather.at(time_s);
  const double wind = now.wind_speed_m_s * model.materials[of_soil]->surface.wind_factor;
  return {.direct_w_m2 = now.direct_normal_w_m2 * level_cosine(day, time_s, 600.0),
          .diffuse_w_m2 = now.diffuse_horizontal_w_m2,
          .sky_long_wave_w_m2 = now.sky_long_wave_w_m2,
          .air_k = now.air_temperature_k,
          .vapour_pressure_hpa = now.vapour_pressure_hpa,
          .pressure_hpa = now.pressure_hpa,
          .film = film(model.materials[of_soil]->surface.convection, {wind, 1.0})};
}

/// Forty days from a uniform start, without any of the solver's devices.
double marched(const HeatModel& model, const Day& day) {
  const Column column{model.materials[of_soil]->layers, model.settings.grid, 600.0_s};
  std::vector<double> nodes(column.nodes(), 290.0);
  const std::array<double, 2> no_room{};
  for (int i = 0; i < 40 * 144; ++i) {
    const double begin = 600.0 * (i % 144) - day_s;
    const std::array<BalanceAt, 2> at{
        BalanceAt{model.materials[of_soil]->surface,
                  open_load(model, day, begin + Column::gamma * 600.0)},
        BalanceAt{model.materials[of_soil]->surface, open_load(model, day, begin + 600.0)}};
    column.advance(
        nodes, [&](int stage, double t) { return at[static_cast<std::size_t>(stage)](t); },
        std::span<const double, 2>{no_room});
  }
  return nodes.front();
}

TEST_CASE("open ground is as warm as days upon days of its own loads make it",
          "[thermal][heat_solver]") {
  const Day day{GENERATE(5.0, 13.5, 20.0)};
  HeatModel model = model_of(day);
  model.settings.spin_up_k = 1e-4;
  model.materials[of_soil]->surface.wetness = 0.3;
  const auto scene = scene_of({surface(ground(), of_soil)});
  const HeatSolver solver{scene, model};
  // 1e-4 K is what spin-up may leave; floats that temperatures are kept in are 3e-5 K apart.
  CHECK(solver.at(from_above(scene, 1.0, 2.0)).value ==
        Approx(marched(model, day)).epsilon(0.0).margin(5e-4));
}

TEST_CASE("a day of the record ends as it began and stores what it receives",
          "[thermal][heat_solver]") {
  const Day day{9.0};
  HeatModel model = model_of(day);
  const auto scene = scene_of({surface(ground(), of_soil)});
  const HeatSolver solver{scene, model};
  const HeatRecord record = solver.record(from_above(scene, 1.0, 2.0));
  REQUIRE(record.rows.size() == 144);
  CHECK(record.rows.back().time_s == 0.0);
  double exchanged = 0.0, coldest = 1e9, hottest = 0.0;
  for (const auto& row : record.rows) {
    exchanged += 600.0 * std::abs(row.conducted);
    coldest = std::min(coldest, row.surface_k);
    hottest = std::max(hottest, row.surface_k);
  }
  CHECK(hottest - coldest > 15.0);  // a fine day
  // Rounding alone: 144 steps of some 1e9 J m^-2.
  CHECK(std::abs(record.stored_j_m2 - record.received_j_m2) < 1e-9 * exchanged);
  // 0.05 K of 0.8 MJ m^-2 K^-1 would be 40 kJ; the day exchanges some 10 MJ.
  CHECK(std::abs(record.stored_j_m2) < 4e-3 * exchanged);
  CHECK(solver.at(from_above(scene, 1.0, 2.0)).value ==
        Approx(record.rows.back().surface_k).epsilon(1e-7));  // kept as a float
}

TEST_CASE("energy is conserved through layers with a room, a source and an open record",
          "[thermal][heat_solver]") {
  const Day day{16.0};
  HeatModel model = model_of(day);
  LayerStack& layers = model.materials[of_soil]->layers;
  layers.layers = {{{0.7, 2000.0, 900.0}, 0.1, 0.0}, {{0.04, 50.0, 1000.0}, 0.1, 20.0}};
  layers.back = GENERATE(Back{AdiabaticBack{}}, Back{FixedBack{285.0_K}},
                         Back{RoomBack{293.0_K, 0.0, 8.3}}, Back{RoomBack{{}, 5.0, 8.3}});
  model.weather = fine_weather(day, 3.0);
  model.settings.history_s = 2.5 * day_s;
  const auto scene = scene_of({surface(ground(), of_soil)});
  const HeatRecord record = HeatSolver{scene, model}.record(from_above(scene, 1.0, 2.0));
  REQUIRE(record.rows.size() == 360);
  double exchanged = 0.0;
  for (const auto& row : record.rows) exchanged += 600.0 * std::abs(row.conducted);
  CHECK(std::abs(record.stored_j_m2 - record.received_j_m2) < 1e-6 * exchanged);
}

TEST_CASE("a sun that never moves leads to the radiative equilibrium", "[thermal][heat_solver]") {
  HeatModel model = model_of({});
  model.weather = still_weather(250.0, 200.0);
  model.weather.direct_normal_w_m2.value = {400.0};
  for (Vec3& direction : model.sun.direction) direction = {0.0, 0.0, 1.0};
  model.materials[of_soil]->surface = {0.6, 0.9, FixedFilm{0.0}, 1.0, 0.0};
  model.settings.spin_up_k = 1e-3;
  const auto scene = scene_of({surface(ground(), of_soil)});
  const HeatSolver solver{scene, model};
  // a E = eps (sigma T^4 - L)
  const double expected = std::pow((200.0 + 0.6 * 400.0 / 0.9) / si::stefan_boltzmann, 0.25);
  CHECK(solver.at(from_above(scene, 1.0, 2.0)).value == Approx(expected).epsilon(0.0).margin(3e-3));
  CHECK(solver.counters().not_repeating == 0);
}

TEST_CASE("a wall towards a room takes the steady state of its layers", "[thermal][heat_solver]") {
  HeatModel model = model_of({});
  model.weather = still_weather(265.0, 220.0);
  LayerStack& layers = model.materials[of_soil]->layers;
  layers.layers = {{{0.9, 1800.0, 850.0}, 0.12, 0.0}, {{0.04, 30.0, 1000.0}, 0.05, 0.0}};
  // Of a temperature of its own, or 28 K above the air
  layers.back = GENERATE(Back{RoomBack{293.0_K, 0.0, 8.0}}, Back{RoomBack{{}, 28.0, 8.0}});
  model.materials[of_soil]->surface = {0.6, 0.9, FixedFilm{17.0}, 1.0, 0.0};
  model.settings.spin_up_k = 1e-4;
  const auto scene = scene_of({surface(ground(), of_soil)});
  const double resistance = 0.12 / 0.9 + 0.05 / 0.04 + 1.0 / 8.0;
  double low = 200.0, high = 300.0;
  while (high - low > 1e-9) {
    const double t = 0.5 * (low + high);
    const double into = 0.9 * (220.0 - si::stefan_boltzmann * std::pow(t, 4)) + 17.0 * (265.0 - t) +
                        (293.0 - t) / resistance;
    (into > 0.0 ? low : high) = t;
  }
  CHECK(HeatSolver(scene, model).at(from_above(scene, 1.0, 2.0)).value ==
        Approx(low).epsilon(0.0).margin(3e-4));
}

TEST_CASE("spin-up ends alike wherever it begins", "[thermal][heat_solver]") {
  const Day day{9.0};
  const HeatModel model = model_of(day);
  const HeatMaterial material = soil();
  const Column column{material.layers, {}, 600.0_s};
  std::vector<BalanceAt> stages;
  for (int i = 0; i < 144; ++i) {
    const double begin = 600.0 * i - day_s;
    stages.emplace_back(material.surface, open_load(model, day, begin + Column::gamma * 600.0));
    stages.emplace_back(material.surface, open_load(model, day, begin + 600.0));
  }
  const std::vector<double> no_room(stages.size(), 0.0);
  const ColumnRun run{&column, stages, no_room};
  const DayMap map{run, std::vector<double>(column.nodes(), 290.0)};
  std::vector<std::vector<double>> ends;
  for (const double start_k : {250.0, 290.0, 340.0}) {
    std::vector<double> nodes(column.nodes(), start_k), memory(2 * column.nodes());
    const SpinUp done = spin_up(run, map, {0.05, 30}, nodes, memory);
    CAPTURE(start_k, done.days);
    CHECK(done.repeats);
    CHECK(done.days <= 5);
    ends.push_back(nodes);
  }
  for (std::size_t i = 0; i < column.nodes(); ++i) {
    // The last step leaves a tenth of what it corrects, 0.05 K at most.
    CHECK(ends[0][i] == Approx(ends[1][i]).epsilon(0.0).margin(0.01));
    CHECK(ends[2][i] == Approx(ends[1][i]).epsilon(0.0).margin(0.01));
  }
}

TEST_CASE("a step that no day is a multiple of is shortened", "[thermal][heat_solver]") {
  const Day day{9.0};
  HeatModel model = model_of(day);
  model.settings.step_s = 700.0;
  model.settings.history_s = 1.01 * day_s;
  model.weather = fine_weather(day, 2.0);
  const auto scene = scene_of({surface(ground(), of_soil)});
  const HeatRecord record = HeatSolver{scene, model}.record(from_above(scene, 1.0, 2.0));
  // 124 steps of 696.77 s a day, and two more for the hundredth
  REQUIRE(record.rows.size() == 126);
  CHECK(record.rows[0].time_s == Approx(-125.0 * day_s / 124.0).epsilon(1e-12));
}

TEST_CASE("the forced film of every law is one of wind times one of tilt",
          "[thermal][heat_solver]") {
  // What lets the solver ask for films once a stage and once a cell instead of once a stage of
  // each cell.
  const Convection law =
      GENERATE(Convection{FixedFilm{7.0}}, Convection{McAdams{}},
               Convection{SimpleByRoughness{Roughness::rough}}, Convection{Tarp{}});
  for (const double wind : {0.3, 2.0, 4.9, 12.0, 50.0}) {
    for (const double up : {-1.0, -0.4, 0.0, 0.3, 0.97}) {
      const Film both = film(law, {wind, up});
      const double by_wind = film(law, {wind, 1.0}).forced_w_m2_k;
      const double by_tilt =
          film(law, {1.0, up}).forced_w_m2_k / film(law, {1.0, 1.0}).forced_w_m2_k;
      CHECK(both.forced_w_m2_k == Approx(by_wind * by_tilt).epsilon(1e-12));
      CHECK(both.natural_warm_w_m2_k43 == film(law, {1.0, up}).natural_warm_w_m2_k43);
      CHECK(both.natural_cold_w_m2_k43 == film(law, {1.0, up}).natural_cold_w_m2_k43);
    }
  }
}

TEST_CASE("a year of hourly weather is as good as a day", "[thermal][heat_solver]") {
  const Day day{9.0};
  HeatModel model = model_of(day);
  model.weather = fine_weather(day, 365.0);
  model.settings.step_s = 3600.0;
  const auto scene = scene_of({surface(ground(), of_soil)});
  const auto hit = from_above(scene, 1.0, 2.0);
  const double after_a_day = HeatSolver{scene, model}.at(hit).value;
  model.settings.history_s = 365.0 * day_s;
  const HeatSolver solver{scene, model};
  CHECK(solver.at(hit).value == Approx(after_a_day).epsilon(0.0).margin(0.05));  // spin_up_k
  CHECK(solver.counters().steps >= 365 * 24);
}

}  // namespace
}  // namespace nadir::thermal
