// What a model of the heat balance must not be.
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "core/constants.hpp"
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

TEST_CASE("a material alone is checked without its number, grid included",
          "[thermal][heat_solver]") {
  const auto refused = [](HeatMaterial material, const GridSettings& grid) -> std::string {
    try {
      check(material, grid);
    } catch (const InputError& error) {
      return error.issues().front().message;
    }
    return "accepted";
  };
  HeatMaterial material = soil();
  CHECK(refused(material, {}) == "accepted");
  CHECK(refused(material, {0.001, 1.0, 1}).rfind("the layers would have more than 128 nodes", 0) ==
        0);
  material.surface.wetness = 2.0;
  CHECK(refused(material, {}) == "wetness is 2, expected 0 to 1");
  material.surface = {0.9, 0.0, FixedFilm{0.0}, 1.0, 0.0};
  CHECK(refused(material, {}).rfind("nothing takes heat away", 0) == 0);
  material.surface.convection = FixedFilm{-1.0};
  CHECK(refused(material, {}) == "film of air in W m^-2 K^-1 is -1, expected 0 to 1e+06");
  // Many thin layers: a hundred and thirty joints
  material = soil();
  material.layers.layers.assign(130, {{0.8, 1600.0, 1000.0}, 0.001, 0.0});
  CHECK(refused(material, {}).rfind("the layers would have more than 128 nodes", 0) == 0);
  CHECK(refusal([&](HeatModel& m) {
          m.materials[1] = material;
        }).rfind("material 1: the layers would have more than 128 nodes", 0) == 0);
}

TEST_CASE("a surface is no warmer than sun, sources and what is behind it allow",
          "[thermal][heat_solver]") {
  // Closed forms, rounding only; 400 K is what the sun may do.
  HeatMaterial material = soil();
  CHECK(warmest_of(material).value == Approx(400.0).epsilon(1e-14));
  material.layers.back = FixedBack{350.0_K};
  CHECK(warmest_of(material).value == Approx(400.0).epsilon(1e-14));
  material.layers.back = FixedBack{900.0_K};
  CHECK(warmest_of(material).value == 900.0);
  material.layers.back = RoomBack{1200.0_K, 0.0, 8.3};
  CHECK(warmest_of(material).value == 1200.0);
  material.layers.back = RoomBack{{}, 100.0, 8.3};  // of the warmest air there may be: 350 K
  CHECK(warmest_of(material).value == 450.0);

  material = soil();
  material.layers.layers.assign(2, {{0.8, 1600.0, 1000.0}, 0.1, 2500.0});
  material.layers.layers.push_back({{0.8, 1600.0, 1000.0}, 0.1, -500.0});  // helps nobody above
  material.surface.emissivity = 0.8;
  CHECK(warmest_of(material).value ==
        Approx(std::pow(std::pow(400.0, 4) + 5000.0 / (0.8 * si::stefan_boltzmann), 0.25))
            .epsilon(1e-13));
  material.layers.layers[0].heat_w_m2 = 1e6;
  CHECK(warmest_of(material).value == 2000.0);
  material.layers.layers[0].heat_w_m2 = 1.0;
  material.surface.emissivity = 0.0;  // sheds it by the air alone
  CHECK(warmest_of(material).value == 2000.0);

  material = soil();  // bright metal, with nothing but its own radiation to cool it
  material.surface = {0.4, 0.1, FixedFilm{0.0}, 1.0, 0.0};
  CHECK(warmest_of(material).value == Approx(400.0 * std::sqrt(2.0)).epsilon(1e-13));
  material.surface.convection = FixedFilm{10.0};
  CHECK(warmest_of(material).value == Approx(400.0).epsilon(1e-14));
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
