#include "sim/products/plan_sheet.hpp"

#include <algorithm>
#include <limits>
#include <sstream>

#include "sim/products/promises.hpp"
#include "sim/products/text_table.hpp"
#include "support/catch.hpp"

using namespace nadir;
using namespace nadir::sim;
using radiometry::Effect;

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

const CameraNames plan_sheet_two_arrays{{"vis", {"blue", "red"}}, {"thermal", {"T"}}};

/// All effects absent in two arrays, but what a test sets.
EffectPlan plan_of_nothing() {
  EffectPlan plan;
  for (std::size_t i = 0; i < radiometry::effect_count; ++i) {
    plan.decisions[i].effect = static_cast<Effect>(i);
    plan.decisions[i].on = {false, false};
    plan.decisions[i].bound = {{0.0, 0.0}, {0.0}};
    plan.decisions[i].reason = "the scene has none";
  }
  plan.by_array.resize(2);
  plan.floor_radiance = {{1.0, 2.0}, {3.0}};
  plan.dropped = {{0.0, 0.0}, {0.0}};
  return plan;
}

EffectDecision& of(EffectPlan& plan, Effect effect) {
  return plan.decisions[radiometry::index_of(effect)];
}

std::string state(const EffectPlan& plan, Effect effect) {
  return effect_sheets(plan, plan_sheet_two_arrays)[radiometry::index_of(effect)].state;
}

PlanSheet sheet_of(const EffectPlan& plan) {
  PlanSheet sheet;
  sheet.scenario = "test";
  sheet.wanted = "1 %";
  sheet.names = plan_sheet_two_arrays;
  sheet.pixels = {100, 50};
  sheet.bands = {{{0.48, 4, 1.0, 0.0, {}}, {0.65, 2, 2.0, 0.001, {}}}, {{10.9, 3, 3.0, 0.0, {}}}};
  sheet.effects = effect_sheets(plan, plan_sheet_two_arrays);
  sheet.solver = "path solver";
  return sheet;
}

Prediction some_prediction() {
  Prediction p;
  p.seconds = 12.0;
  p.render_s = 10.0;
  p.memory_bytes = 2e8;
  p.bands = {{{0.001, 0.004, 1.0}, {0.002, 0.02, 0.9}}, {{0.0, 0.0, 1.0}}};
  p.reachable = 0.02;
  p.pilot_pixels = 64;
  return p;
}

std::size_t widest_line(const std::string& text) {
  std::istringstream lines{text};
  std::size_t widest = 0;
  for (std::string line; std::getline(lines, line);) widest = std::max(widest, line.size());
  return widest;
}

}  // namespace

TEST_CASE("the state of an effect begins with on or off and says why", "[sim][plan]") {
  EffectPlan plan = plan_of_nothing();
  of(plan, Effect::solar_reflection).on = {true, true};
  of(plan, Effect::sky_emission).on = {false, true};
  of(plan, Effect::lamps).asked = EffectState::on;
  of(plan, Effect::lamps).on = {true, true};
  of(plan, Effect::volumes).asked = EffectState::off;
  of(plan, Effect::path_emission).bound = {{1e-5, 1e-4}, {0.0}};
  CHECK(state(plan, Effect::solar_reflection) == "on");
  CHECK(state(plan, Effect::sky_emission) == "on in 1 of 2 arrays: thermal");
  CHECK(state(plan, Effect::lamps) == "on (stated)");
  CHECK(state(plan, Effect::volumes) == "off (stated)");
  CHECK(state(plan, Effect::path_emission) == "off (auto)");
  CHECK(state(plan, Effect::eclipse) == "off (absent)");
}

TEST_CASE("the table of a plan has every effect, its worst band and at most 120 columns",
          "[sim][plan]") {
  EffectPlan plan = plan_of_nothing();
  of(plan, Effect::path_emission).bound = {{1e-5, 1.23e-3}, {0.0}};
  of(plan, Effect::path_emission).reason =
      "adds at most 0.12 % in a band, which is less than what all effects that are left out may "
      "add up to in this scenario";
  of(plan, Effect::volumes).bound = {{infinite, 0.0}, {0.0}};
  PlanSheet sheet = sheet_of(plan);
  sheet.solver_reason = std::string(300, 'x').replace(100, 1, " ").replace(200, 1, " ");
  SECTION("without a pilot") {}
  SECTION("with a pilot") { sheet.prediction = some_prediction(); }
  const std::string text = plan_text(sheet);
  for (const std::string_view name : radiometry::effect_names) {
    CHECK(text.find(std::string{name}) != std::string::npos);
  }
  CHECK(text.find("0.123 %") != std::string::npos);
  CHECK(text.find("vis/red") != std::string::npos);
  CHECK(text.find("unknown") != std::string::npos);
  CHECK(widest_line(text) <= 120);
  CHECK((text.find("12.00 s") != std::string::npos) == sheet.prediction.has_value());
}

TEST_CASE("a plan with hundreds of bands stays a page and says what it does not show",
          "[sim][plan]") {
  EffectPlan plan = plan_of_nothing();
  PlanSheet sheet = sheet_of(plan);
  sheet.names = {{"imager", {}}};
  sheet.bands = {{}};
  sheet.pixels = {10};
  for (int i = 0; i < 224; ++i) {
    sheet.names[0].bands.push_back("band number " + std::to_string(i));
    sheet.bands[0].push_back({0.4 + 0.01 * i, 1, 1.0, 0.0, {}});
  }
  const std::string text = plan_text(sheet);
  CHECK(text.find("imager: 208 more bands") != std::string::npos);
  CHECK(std::count(text.begin(), text.end(), '\n') < 60);
}

TEST_CASE("the JSON of a plan has bounds by array and band, and null for infinity", "[sim][plan]") {
  EffectPlan plan = plan_of_nothing();
  of(plan, Effect::volumes).bound = {{infinite, 0.5}, {0.0}};
  PlanSheet sheet = sheet_of(plan);
  sheet.prediction = some_prediction();
  const std::string json = plan_json(sheet);
  const auto has = [&](const std::string& part) { return json.find(part) != std::string::npos; };
  CHECK(has(R"("format": "nadir plan 1")"));
  CHECK(has(R"("name": "solar_reflection")"));
  CHECK(has("\"blue\": null,\n          \"red\": 0.5"));
  CHECK(has(R"("seconds_if_on": 0.0)"));
  CHECK(has(R"("reachable_accuracy": 0.02)"));
  CHECK_FALSE(has("inf"));
  CHECK_FALSE(has("nan"));
}

TEST_CASE("a report shows of its promises what there is, in their order", "[sim][plan]") {
  Promises promises;
  CHECK(promises_json(promises) == "{}");
  promises.names = plan_sheet_two_arrays;
  promises.effects = effect_sheets(plan_of_nothing(), plan_sheet_two_arrays);
  promises.settings_reason = "stated";
  promises.prediction = some_prediction();
  promises.fact = RunFact{};
  promises.audit = AuditReport{};
  promises.goal = GoalReport{};
  promises.bias = {{{0.1, 0.2, 0.0, 0.0, 0.0}, {}}, {{}}};
  const std::string json = promises_json(promises);
  std::size_t at = 0;
  for (const char* key : {"\"effects\":", "\"settings_reason\":", "\"prediction\":", "\"fact\":",
                          "\"audit\":", "\"goal\":", "\"bias\":"}) {
    CAPTURE(key);
    const auto found = json.find(key, at);
    REQUIRE(found != std::string::npos);
    at = found;
  }
  CHECK(json.find(R"("bounce_limit":0.2)") != std::string::npos);
  CHECK(json.find(R"("fact":{"seconds":null)") != std::string::npos);
}

TEST_CASE("the report of a goal weights arrays by their pixels", "[sim][plan]") {
  Promises promises;
  promises.names = plan_sheet_two_arrays;
  GoalReport goal;
  goal.accuracy = 0.01;
  ArrayOutcome vis, thermal;
  vis.pixels = 300;
  vis.met = 0.5;
  vis.bands = {{0.5, 0.03, 0.02}, {0.9, 0.01, 0.01}};
  thermal.pixels = 100;
  thermal.met = 1.0;
  thermal.bands = {{1.0, 0.005, 0.004}};
  goal.outcome.arrays = {vis, thermal};
  promises.goal = goal;
  const std::string json = promises_json(promises);
  CHECK(json.find(R"("share_met":0.625)") != std::string::npos);  // (150 + 100) / 400
  CHECK(json.find(R"("worst":0.03,)") != std::string::npos);
  CHECK(json.find(R"("wanted":{"accuracy":0.01})") != std::string::npos);
  CHECK(json.find(R"("kept":false)") != std::string::npos);
}

TEST_CASE("text is broken at spaces, and words are kept whole", "[sim][plan]") {
  CHECK(broken_at_spaces("", 5) == std::vector<std::string>{""});
  CHECK(broken_at_spaces("one two three", 7) == std::vector<std::string>{"one two", "three"});
  CHECK(broken_at_spaces("enormously", 4) == std::vector<std::string>{"enormously"});
  CHECK(text_table({{"a"}, {"b", true}, {"c"}}, {{"x", "1", "long words here"}, {"yy", "22", "z"}},
                   27) ==
        "a    b  c\n"
        "x    1  long words here\n"
        "yy  22  z\n");
}
