#include "sim/run/drop_effects.hpp"

#include <string>

#include "scenario_support.hpp"
#include "sim/run/load_light.hpp"
#include "support/catch.hpp"

using namespace nadir;
using namespace nadir::sim;
using radiometry::Effect;
using radiometry::EffectSet;

namespace {

Scenario of_day() {
  Scenario scenario;
  scenario.time = ephemeris::Instant::parse_utc("2026-06-21T18:00:00Z");
  scenario.origin = {33.2, -98.2, 300.0};
  scenario.illumination = ComputedSky{};
  scenario.air = LayeredAir{};
  return scenario;
}

std::size_t files_of_light(const Scenario& scenario) {
  InputFiles files;
  Diagnostics diagnostics;
  static_cast<void>(load_illumination(scenario, files, diagnostics));
  return files.all().size();
}

}  // namespace

TEST_CASE("a sun that no effect needs is not read, but keeps its place", "[effects][drop]") {
  Scenario scenario = of_day();
  CHECK(files_of_light(scenario) == 1);
  drop_effects(scenario, EffectSet{}.with(Effect::surface_emission));
  CHECK(files_of_light(scenario) == 0);
  InputFiles files;
  Diagnostics diagnostics;
  const auto bodies = load_illumination(scenario, files, diagnostics);
  REQUIRE(bodies.size() == 1);
  CHECK(bodies[0].irradiance.max_value() == 0.0);
  CHECK(bodies[0].direction_enu.z > 0.5);  // an hour before noon in June
}

TEST_CASE("the air's scattered light keeps the sun", "[effects][drop]") {
  Scenario scenario = of_day();
  drop_effects(scenario, EffectSet{}.with(Effect::path_scattering));
  CHECK(files_of_light(scenario) == 1);
  Scenario uniform = of_day();
  uniform.air = UniformAir{};  // shines by its figures, whatever the sun does
  drop_effects(uniform, EffectSet{}.with(Effect::path_scattering));
  CHECK(files_of_light(uniform) == 0);
}

TEST_CASE("air goes with all that needs it", "[effects][drop]") {
  Scenario scenario = of_day();
  drop_effects(scenario, EffectSet{}.with(Effect::surface_emission));
  CHECK(std::holds_alternative<NoAir>(scenario.air));
  Scenario lit = of_day();  // its light comes through the air
  drop_effects(lit, EffectSet{}.with(Effect::solar_reflection));
  REQUIRE(std::holds_alternative<LayeredAir>(lit.air));
  CHECK_FALSE(std::get<LayeredAir>(lit.air).night_sky);
}

TEST_CASE("lamps, volumes, point spreads and heat are taken out", "[effects][drop]") {
  Scenario scenario = of_day();
  scenario.lamps.resize(1);
  scenario.volumes.resize(1);
  scenario.camera.arrays.resize(1);
  scenario.camera.arrays[0].blur.table = "psf.txt";
  scenario.materials.resize(2);
  scenario.materials[0].temperature = HeatBalanceInput{};
  scenario.materials[1].temperature = AirTemperatureInput{-3.0};
  scenario.effects.states[radiometry::index_of(Effect::thermal_solve)] = EffectState::off;
  drop_effects(scenario, EffectSet::all()
                             .without(Effect::lamps)
                             .without(Effect::volumes)
                             .without(Effect::psf)
                             .without(Effect::thermal_solve));
  CHECK(scenario.lamps.empty());
  CHECK(scenario.volumes.empty());
  CHECK(scenario.camera.arrays[0].blur.is_none());
  // US standard atmosphere at the ground
  CHECK(test::kelvin_of(scenario.materials[0]) == 288.2);
  CHECK(test::kelvin_of(scenario.materials[1]) == Approx(285.2).epsilon(1e-12));
  ClearSkyInput day;
  day.air_low_k = 280.0;
  day.air_high_k = 300.0;
  scenario.heat.emplace().weather = day;
  CHECK(air_temperature_k(scenario) == 290.0);
}

TEST_CASE("a scenario that has all effects stays as it is", "[effects][drop]") {
  Scenario scenario = of_day();
  scenario.lamps.resize(1);
  scenario.volumes.resize(1);
  drop_effects(scenario, EffectSet::all());
  CHECK(scenario.lamps.size() == 1);
  CHECK(scenario.volumes.size() == 1);
  CHECK(std::get<LayeredAir>(scenario.air).night_sky);
  CHECK(std::get<ComputedSky>(scenario.illumination).sun_shines);
}

TEST_CASE("arrays of a camera lose what they do not have", "[effects][drop]") {
  Camera camera;
  camera.arrays.resize(2);
  sensor::Detector detector;
  detector.dead_share = 0.1;
  detector.element = sensor::PhotonDetector{.prnu = 0.01};
  camera.electronics = {{{detector, std::nullopt}}, {{detector, std::nullopt}}};
  drop_effects(camera, {EffectSet::all(), EffectSet{}});
  CHECK_FALSE(camera.arrays[0].timing.still);
  CHECK(camera.electronics[0][0].detector->noisy);
  CHECK(camera.arrays[1].timing.still);
  CHECK_FALSE(camera.electronics[1][0].detector->noisy);
  CHECK(camera.electronics[1][0].detector->dead_share == 0.0);
}
