#include <array>
#include <cstdint>
#include <set>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "radiometry/lit_scene.hpp"
#include "scenario_support.hpp"
#include "sim/run/air_stage.hpp"
#include "support/catch.hpp"

// For which sources air in layers is solved, by what the arrays leave out.

namespace nadir::test {
namespace {

using atmosphere::AirParts;
using radiometry::Effect;
using radiometry::EffectSet;

sensor::DetectorArray box_array(double lo_um, double hi_um) {
  sensor::DetectorArray array;
  array.bands.push_back({"b", spectral::BoxResponse{Micrometres{lo_um}, Micrometres{hi_um}}});
  return array;
}

/// A plate under fast layered air and the sun, seen by a visible and a thermal array.
sim::Scenario effect_switches_two_arrays() {
  std::string text = replaced(minimal_text(), "<none/>", "<layered mode=\"fast\"/>");
  text = replaced(text, "<fixed/>",
                  "<fixed><body name=\"sun\" azimuth_deg=\"180\" elevation_deg=\"45\" "
                  "angular_radius_deg=\"0.27\" irradiance=\"1000\"/></fixed>");
  text = replaced(text, "</array>",
                  "</array><array name=\"visible\" samples=\"4\" lines=\"3\" ground_pitch_m=\"1\">"
                  "<band_box name=\"green\" lo_um=\"0.55\" hi_um=\"0.56\"/></array>");
  Diagnostics diagnostics;
  sim::Scenario scenario = sim::parse_scenario(text, data_folder() / "test.xml", diagnostics);
  scenario.effects.states.fill(sim::EffectState::on);
  scenario.sampling.wavelengths_per_band = 1;
  return scenario;
}

struct Solved {
  std::int64_t beams = 0, thermal = 0;
  std::string model;
  atmosphere::Atmosphere air;
};
/// @param effects  of the thermal array, then of the visible one
Solved solved(const std::vector<EffectSet>& effects) {
  Diagnostics diagnostics;
  sim::InputFiles files;
  const sim::Scenario scenario = effect_switches_two_arrays();
  sim::World world = sim::load_world(scenario, files, diagnostics);
  const sim::ReportValues values =
      sim::finish_air(world, scenario.sampling, diagnostics, {false, {}}, effects);
  Solved result;
  for (const auto& [name, value] : values) {
    if (name == "beam_solves") result.beams = std::get<std::int64_t>(value);
    if (name == "thermal_solves") result.thermal = std::get<std::int64_t>(value);
    if (name == "model") result.model = std::get<std::string>(value);
  }
  result.air = world.scene.atmosphere;
  return result;
}

const EffectSet all = EffectSet::all();
const EffectSet no_scattering =
    all.without(Effect::sky_scattering).without(Effect::path_scattering);
const EffectSet no_emission = all.without(Effect::sky_emission).without(Effect::path_emission);

}  // namespace

TEST_CASE("what an array wants of the air is wanted at its own wavelengths", "[sim][effect]") {
  const std::vector<sensor::DetectorArray> arrays{box_array(0.5, 0.6), box_array(10.0, 11.0),
                                                  box_array(0.5, 0.6)};
  const std::array effects{no_emission, no_scattering,
                           EffectSet{}.with(Effect::path_transmittance)};
  const auto wanted = sim::wanted_of_air(arrays, 1, effects);
  REQUIRE(wanted.size() == 2);
  CHECK(wanted[0] == AirParts{true, false, true, false, true});  // of both that have it
  CHECK(wanted[1] == AirParts{false, true, false, true, true});
  for (const AirParts& parts : sim::wanted_of_air(arrays, 1, {})) CHECK(parts == AirParts{});
}

TEST_CASE("numbers of nodes that differ by band are each array's own", "[sim][effect]") {
  sim::BandNodes nodes;
  nodes.by_array = {{1}, {2}};
  const std::vector<sensor::DetectorArray> arrays{box_array(0.5, 0.6), box_array(10.0, 11.0)};
  const auto wanted = sim::wanted_of_air(arrays, nodes, std::array{no_emission, no_scattering});
  REQUIRE(wanted.size() == 3);
  CHECK(wanted[0].scattering());
  CHECK_FALSE(wanted[1].scattering());
  CHECK_FALSE(wanted[2].scattering());
}

TEST_CASE("air in layers is solved for the sources that its arrays want", "[sim][effect]") {
  const Solved whole = solved({});
  CHECK(whole.beams > 0);
  CHECK(whole.thermal > 0);
  const Solved by_array = solved({no_scattering, no_emission});
  CHECK(by_array.beams > 0);    // of the visible array
  CHECK(by_array.thermal > 0);  // of the thermal one
  CHECK(by_array.beams <= whole.beams);
  CHECK(solved({no_scattering, no_scattering}).beams == 0);
  CHECK(solved({no_emission, no_emission}).thermal == 0);
  // The visible array's air does not emit: to solve the thermal lanes for scattering alone costs
  // no thermal solve either.
  CHECK(solved({no_emission, all}).thermal == 0);
}

TEST_CASE("where no array needs the air there is none", "[sim][effect]") {
  const EffectSet lamps = EffectSet{}.with(Effect::lamps).with(Effect::surface_emission);
  const Solved none = solved({lamps, lamps});
  CHECK(std::holds_alternative<atmosphere::None>(none.air));
  CHECK(none.model.find("no effect") != std::string::npos);
  // Sunlight comes through it: its transmittance is found, and nothing is solved.
  const Solved sunlit = solved({lamps, EffectSet{}.with(Effect::solar_reflection)});
  CHECK(sunlit.beams + sunlit.thermal == 0);
  const auto& table = *std::get<atmosphere::Tabulated>(sunlit.air).table;
  REQUIRE(table.bodies.size() == 1);
  CHECK(table.bodies[0].transmittance[0] > 0.5F);
  CHECK(table.bodies[0].transmittance[0] < 0.99F);
  CHECK(table.views.empty());
}

TEST_CASE("what is left out is part of the key of the air's table", "[sim][effect]") {
  Diagnostics diagnostics;
  sim::InputFiles files;
  const sim::LayeredTask task =
      *sim::load_air_task(effect_switches_two_arrays(), files, diagnostics)->layered;
  const std::vector<sensor::DetectorArray> arrays{box_array(0.5, 0.6)};
  const sim::AirLanes nodes = sim::air_nodes(arrays, 1);
  std::set<std::string> keys;
  for (const EffectSet effects :
       {all, no_scattering, no_emission, all.without(Effect::sky_scattering),
        all.without(Effect::path_scattering), all.without(Effect::path_transmittance)}) {
    const auto wanted = sim::wanted_of_air(arrays, 1, std::array{effects});
    keys.insert(sim::air_key(task.air, task.settings, nodes, {}, "f", wanted));
  }
  CHECK(keys.size() == 6);
  // Everything wanted is what a key says without any effects.
  CHECK(keys.contains(sim::air_key(task.air, task.settings, nodes, {}, "f")));
}

}  // namespace nadir::test
