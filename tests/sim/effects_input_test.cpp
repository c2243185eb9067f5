#include "scenario_support.hpp"
#include "support/catch.hpp"

using namespace nadir;
using namespace nadir::sim;
using radiometry::Effect;

namespace {

std::string with_elements(const std::string& elements) {
  return test::replaced(test::minimal_text(), "</scenario>", elements + "</scenario>");
}

Scenario read(const std::string& elements) {
  Diagnostics diagnostics;
  return parse_scenario(with_elements(elements), test::data_folder() / "test.xml", diagnostics);
}

/// The only mistake, without its place.
std::string mistake_of(const std::string& elements) {
  const std::string lines = test::mistake_lines(with_elements(elements));
  return lines.substr(std::min(lines.find(": "), lines.size()));
}

}  // namespace

TEST_CASE("every effect is automatic unless the scenario says otherwise", "[scenario][effects]") {
  for (const char* text : {"", "<effects/>"}) {
    const Scenario scenario = read(text);
    for (const EffectState state : scenario.effects.states) CHECK(state == EffectState::automatic);
  }
}

TEST_CASE("each effect of the list can be on, off and auto", "[scenario][effects]") {
  for (std::size_t i = 0; i < radiometry::effect_count; ++i) {
    const std::string name{radiometry::effect_names[i]};
    CAPTURE(name);
    const auto state = [&](const std::string& value) {
      return read("<effects " + name + "=\"" + value + "\"/>").effects.states[i];
    };
    CHECK(state("on") == EffectState::on);
    CHECK(state("off") == EffectState::off);
    CHECK(state("auto") == EffectState::automatic);
  }
  const Scenario scenario = read("\n  <effects psf=\"off\"/>");
  CHECK(scenario.effects.of(Effect::psf) == EffectState::off);
  CHECK(scenario.effects.of(Effect::lamps) == EffectState::automatic);
  CHECK(scenario.effects.where.line > 0);
}

TEST_CASE("the defaults of the accuracy are those of the plain data", "[scenario][effects]") {
  for (const char* text : {"", "<accuracy/>"}) {
    const AccuracyInput accuracy = read(text).accuracy;
    CHECK(accuracy.relative == Approx(AccuracyInput{}.relative).epsilon(1e-15));
    CHECK_FALSE(accuracy.floor_radiance.has_value());
    CHECK(accuracy.noise_fraction == AccuracyInput{}.noise_fraction);
    CHECK(accuracy.effects_share == AccuracyInput{}.effects_share);
  }
  const AccuracyInput stated =
      read(
          "<accuracy relative_percent=\"2\" floor_radiance=\"0.5\" noise_fraction=\"0.1\" "
          "effects_share=\"0\"/>")
          .accuracy;
  CHECK(stated.relative == Approx(0.02).epsilon(1e-15));
  CHECK(stated.floor_radiance == 0.5);
  CHECK(stated.noise_fraction == 0.1);
  CHECK(stated.effects_share == 0.0);
}

TEST_CASE("mistakes in effects and accuracy are told with the nearest name",
          "[scenario][effects]") {
  CHECK(mistake_of("<effects solar_reflexion=\"on\"/>").find("solar_reflection") !=
        std::string::npos);
  CHECK(mistake_of("<effects psf=\"yes\"/>").find("auto or on or off") != std::string::npos);
  CHECK_FALSE(mistake_of("<effects/><effects/>").empty());
  CHECK_FALSE(mistake_of("<accuracy relative_percent=\"0\"/>").empty());
  CHECK_FALSE(mistake_of("<accuracy relative_percent=\"101\"/>").empty());
  CHECK_FALSE(mistake_of("<accuracy effects_share=\"1\"/>").empty());
  CHECK_FALSE(mistake_of("<accuracy floor_radiance=\"-1\"/>").empty());
}
