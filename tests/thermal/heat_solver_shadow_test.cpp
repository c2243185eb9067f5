// What the sun has not reached stays cold for hours.
#include <cmath>
#include <numbers>

#include "core/constants.hpp"
#include "support/catch.hpp"
#include "thermal/heat_scene.hpp"
#include "thermal/solve/heat_solver.hpp"

namespace nadir::thermal {
namespace {

using namespace test;

/// Deep soil under a constant film: the half-space of the closed form.
HeatModel half_space_model(const Day& day) {
  HeatModel model = model_of(day);
  model.materials[of_soil]->layers.layers = {{{0.8, 1600.0, 1000.0}, 1.5, 0.0}};
  model.materials[of_soil]->surface = {0.8, 0.9, FixedFilm{12.0}, 1.0, 0.0};
  model.settings.resolution_m = 200.0 / 128;  // cells have their lower corners at round numbers
  return model;
}

/// What the surface of a half-space cooled through a film has left, a time after it got an impulse
/// of 1 J m^-2: K. Carslaw & Jaeger, "Conduction of Heat in Solids" (1959), 14.2 (III), z = 0.
double impulse_response(double effusivity, double film, double time_s) {
  const double x = film * std::sqrt(time_s) / effusivity;
  return (1.0 / std::sqrt(std::numbers::pi * time_s) -
          film / effusivity * std::exp(x * x) * std::erfc(x)) /
         effusivity;
}

TEST_CASE("a place that was in the shade is colder by what the sun withheld has left",
          "[thermal][heat_solver]") {
  const Day day{15.5};
  HeatModel model = half_space_model(day);
  // A plate of 24 m, 60 m above the ground, hides little of the sky (5 %) and all of the sun for a
  // while. At 13 h its shadow lies where the sun then throws it.
  const Vec3 then = day.sun(-2.5 * 3600.0);
  const Vec3 middle = (60.0 / then.z) * then;
  const Rectangle plate{middle - Vec3{12.0, 12.0, 0.0}, {24.0, 0.0, 0.0}, {0.0, 24.0, 0.0}};
  const auto scene = scene_of({surface(ground(100.0), of_soil), surface(plate, of_wall)});
  model.settings.exposure.sky_rays = 512;
  const HeatSolver solver{scene, model};

  const HeatRecord scar = solver.record(looking(scene, {0.1, 0.1, 1.0}, {0.1, 0.1, 0.0}));
  const HeatRecord lit = solver.record(looking(scene, {80.0, -80.0, 1.0}, {80.0, -80.0, 0.0}));
  double expected = 0.0, mean_k = 0.0;
  for (const auto& row : lit.rows) mean_k += row.surface_k / 144.0;
  const double film = 12.0 + 4.0 * 0.9 * si::stefan_boltzmann * std::pow(mean_k + 8.0, 3);
  const double effusivity = std::sqrt(0.8 * 1600.0 * 1000.0);
  double dark_s = 0.0;
  for (std::size_t i = 0; i < scar.rows.size(); ++i) {
    const double missing = lit.rows[i].terms.direct - scar.rows[i].terms.direct;
    dark_s += lit.rows[i].sun_cosine > 0.0 && scar.rows[i].sun_cosine == 0.0 ? 600.0 : 0.0;
    const double ago = -scar.rows[i].time_s;
    if (ago > 0.0) expected -= 600.0 * missing * impulse_response(effusivity, film, ago);
  }
  CHECK(dark_s > 3600.0);
  CHECK(dark_s < 3.0 * 3600.0);
  CHECK(scar.rows.back().sun_cosine > 0.3);  // it lies in the sun again
  const double colder = scar.rows.back().surface_k - lit.rows.back().surface_k;
  CAPTURE(colder, expected, film, dark_s);
  CHECK(expected < -1.0);
  // A film made linear about an afternoon's temperature, and a plate that takes the place of 5 % of
  // a colder sky: 10 % or so.
  CHECK(colder == Approx(expected).epsilon(0.15));
}

TEST_CASE("a wall leaves a cold scar where its shadow lay in the morning",
          "[thermal][heat_solver]") {
  const Day day{12.5};
  HeatModel model = model_of(day);
  // Black and as cold as the sky: nothing but its shadow tells.
  model.surroundings[of_wall] = {0.0, 1.0, FollowsAir{-18.0}};
  const auto scene =
      scene_of({surface(ground(), of_soil),
                surface({{0.0, -20.0, 0.0}, {0.0, 40.0, 0.0}, {0.0, 0.0, 6.0}}, of_wall)});
  const HeatSolver solver{scene, model};
  const auto at = [&](double x) { return solver.at(from_above(scene, x, 0.0)).value; };
  const double open = at(-40.0), scar = at(-2.5);
  CAPTURE(open, scar);
  CHECK(scar < open - 1.0);
  const HeatRecord record = solver.record(from_above(scene, -2.5, 0.0));
  // In the sun since (east component) / (height) of the sun fell below 2.5 / 6, about 10:40.
  for (const auto& row : record.rows) {
    const double hour = day.hour(row.time_s);
    CAPTURE(hour);
    if (hour > 0.0 && hour < 9.5) CHECK(row.sun_cosine == 0.0);
    if (hour > 11.6) CHECK(row.sun_cosine > 0.5);
  }
}

/// A van: a box so near to the ground that no sun gets under its middle.
geometry::Surface van(std::uint32_t epochs) {
  return {geometry::Box{{-2.0, -3.0, 0.1}, {2.0, 3.0, 2.5}}, {of_wall}, epochs};
}

TEST_CASE("a van that left leaves its footprint", "[thermal][heat_solver]") {
  const Day day{15.0};
  HeatModel model = model_of(day);
  constexpr std::uint32_t before = 2;
  for (std::size_t i = 0; i < model.sun.time_s.size(); ++i) {
    if (model.sun.time_s[i] < -3600.0) model.sun.epoch[i] = before;  // it left an hour ago
  }
  const auto scene = scene_of({surface(ground(), of_soil), van(before)});
  const HeatSolver solver{scene, model};
  const HeatRecord under = solver.record(from_above(scene, 0.1, 0.1));
  const HeatRecord far = solver.record(from_above(scene, 40.1, 0.1));
  CHECK(under.sky_fraction == 1.0);  // now
  for (const auto& row : under.rows) {
    CAPTURE(row.time_s);
    if (row.time_s < -4300.0) CHECK(row.sun_cosine < 0.3);
    if (row.time_s > -3600.0) CHECK(row.sun_cosine > 0.3);
  }
  CHECK(under.rows.back().surface_k < far.rows.back().surface_k - 3.0);

  // The same hour before dawn: what a roof kept from radiating to the sky is warmer.
  const Day dawn{5.0};
  HeatModel cold = model_of(dawn);
  for (std::size_t i = 0; i < cold.sun.time_s.size(); ++i) {
    if (cold.sun.time_s[i] < -3600.0 && cold.sun.time_s[i] > -9.0 * 3600.0) {
      cold.sun.epoch[i] = before;
    }
  }
  const HeatSolver night{scene, cold};
  CHECK(night.at(from_above(scene, 0.1, 0.1)).value >
        night.at(from_above(scene, 40.1, 0.1)).value + 0.5);
}

TEST_CASE("days before the sun's track have the shadows of its first day",
          "[thermal][heat_solver]") {
  const Day day{14.0};
  HeatModel model = model_of(day);
  const auto scene =
      scene_of({surface(ground(), of_soil),
                surface({{0.0, -20.0, 0.0}, {0.0, 40.0, 0.0}, {0.0, 0.0, 6.0}}, of_wall)});
  model.weather = fine_weather(day, 3.0);
  model.settings.history_s = 3.0 * day_s;
  const HeatRecord record = HeatSolver{scene, model}.record(from_above(scene, -4.0, 0.0));
  REQUIRE(record.rows.size() == 432);
  for (std::size_t i = 0; i < 144; ++i) {
    // The track's first moment and its last are a day apart: the same but for one ray's aim.
    if (i == 143) continue;
    CHECK(record.rows[i].sun_cosine == record.rows[i + 288].sun_cosine);
    CHECK(record.rows[i + 144].sun_cosine == record.rows[i + 288].sun_cosine);
  }
}

}  // namespace
}  // namespace nadir::thermal
