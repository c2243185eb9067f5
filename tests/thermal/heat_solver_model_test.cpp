// What a model of the heat balance must not be.
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "support/catch.hpp"
#include "thermal/heat_scene.hpp"
#include "thermal/solve/time_grid.hpp"

namespace nadir::thermal {
namespace {

using namespace test;

std::string refusal(const std::function<void(HeatModel&)>& spoil) {
  HeatModel model = model_of({});
  spoil(model);
  try {
    check(model);
  } catch (const InputError& error) {
    return error.issues().front().message;
  }
  return "accepted";
}

TEST_CASE("a sound model is accepted", "[thermal][heat_solver]") {
  CHECK(refusal([](HeatModel&) {}) == "accepted");
}

TEST_CASE("settings out of range are named", "[thermal][heat_solver]") {
  CHECK(refusal([](HeatModel& m) { m.settings.step_s = 0.0; }) ==
        "heat balance: the step in seconds is 0, expected 1 to 21600");
  CHECK(refusal([](HeatModel& m) {
          m.settings.resolution_m = std::numeric_limits<double>::quiet_NaN();
        }) == "heat balance: the resolution in metres is nan, expected 0.001 to 1e+06");
  CHECK(refusal([](HeatModel& m) { m.settings.spin_up_days = 0; }) ==
        "heat balance: days of spin-up is 0, expected 1 to 1e+05");
  CHECK(refusal([](HeatModel& m) { m.settings.exposure.sky_rays = 0; }) ==
        "heat balance: rays to the sky is 0, expected 1 to 1e+06");
}

TEST_CASE("weather must reach from the begin of the history to the picture",
          "[thermal][heat_solver]") {
  CHECK(refusal([](HeatModel& m) { m.settings.history_s = 48.0 * 3600.0; }) ==
        "the weather begins 24 h before the picture, expected at least 48 h");
  CHECK(refusal([](HeatModel& m) {
          m.weather.air_temperature_k = {{-200000.0, -7200.0}, {280.0, 281.0}};
        }) == "the weather ends 2 h before the picture, expected weather up to the picture");
  CHECK(refusal([](HeatModel& m) { m.weather.wind_speed_m_s.value[3] = -1.0; }) != "accepted");
}

TEST_CASE("the sun's track must be even, a day long and end at the picture",
          "[thermal][heat_solver]") {
  CHECK(refusal([](HeatModel& m) { m.sun = sun_track({}, 600.0, 0.5); }) ==
        "the sun's track: its length in seconds is 43200, expected at least 86400");
  CHECK(refusal([](HeatModel& m) { m.sun.time_s.back() = 1.0; }) ==
        "the sun's track: its last moment in seconds is 1, expected 0, the picture");
  CHECK(refusal([](HeatModel& m) { m.sun.time_s[7] += 5.0; }) ==
        "the sun's track: moment 8 is -82195, expected -82200 s: even intervals up to the "
        "picture");
  CHECK(refusal([](HeatModel& m) {
          m.sun.direction[2] = {0.0, 0.0, 2.0};
        }) == "the sun's track: moment 3: length of the direction is 2, expected 1");
  CHECK(refusal([](HeatModel& m) { m.sun.epoch[0] = 6; }) ==
        "the sun's track: moment 1: epoch is 6, expected a single bit");
  CHECK(refusal([](HeatModel& m) { m.sun.epoch.clear(); }) ==
        "the sun's track: 145 times, 145 directions, 0 epochs, expected as many of each and at "
        "least 2");
}

TEST_CASE("materials and surroundings are checked by name", "[thermal][heat_solver]") {
  CHECK(refusal([](HeatModel& m) { m.materials[1]->surface.emissivity = 1.2; }) ==
        "material 1: emissivity is 1.2, expected 0 to 1");
  CHECK(refusal([](HeatModel& m) {
          m.materials[0]->layers.layers.clear();
        }).rfind("material 0: ", 0) == 0);
  CHECK(refusal([](HeatModel& m) {
          m.materials[0]->surface = {0.9, 0.0, FixedFilm{0.0}, 1.0, 0.0};
        }) ==
        "material 0: nothing takes heat away, expected an emissivity or a film above 0, or a "
        "back with a temperature");
  CHECK(refusal([](HeatModel& m) { m.surroundings.pop_back(); }) ==
        "heat balance: 3 materials, but only 2 as others see them");
  CHECK(refusal([](HeatModel& m) { m.surroundings[2].temperature = OfItsHeatBalance{}; }) ==
        "surroundings of material 2 has the temperature of the heat balance of material 2, which "
        "has none");
  CHECK(refusal([](HeatModel& m) {
          m.surroundings.push_back({0.2, 0.9, OfItsHeatBalance{1}});
        }) == "accepted");
  CHECK(refusal([](HeatModel& m) { m.ground_about.temperature = OfItsHeatBalance{}; }) ==
        "the ground about the scene cannot have a heat balance, expected a temperature or an "
        "offset to the air");
}

TEST_CASE("places between moments: whole days later before the first, the last at the end",
          "[thermal][heat_solver]") {
  const EvenMoments moments{-86400.0, 3600.0, 25};
  const Between half = moments.find(-86400.0 + 1800.0);
  CHECK(half.index == 0);
  CHECK(half.share == 0.5F);
  const Between before = moments.find(-86400.0 - 3.0 * 86400.0 - 900.0);  // 0.75 of the last hour
  CHECK(before.index == 23);
  CHECK(before.share == 0.75F);
  const Between last = moments.find(0.0);
  CHECK(last.index == 23);
  CHECK(last.share == 1.0F);
  const std::vector<float> series{1.0F, 3.0F};
  CHECK(interpolated(series, {0, 0.25F}) == 1.5);
  CHECK(interpolated(series, {7, 0.25F}) == 3.0);
  CHECK(interpolated(std::vector<float>{}, {0, 0.25F}) == 0.0);
}

}  // namespace
}  // namespace nadir::thermal
