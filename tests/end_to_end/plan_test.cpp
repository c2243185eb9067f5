#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <string>

#include "end_to_end/command.hpp"
#include "end_to_end/tiny_scenario.hpp"
#include "radiometry/effect.hpp"
#include "support/catch.hpp"

namespace nadir::end_to_end {
namespace {

using Json = nlohmann::json;

std::string plan_of(const sim::support::ScratchFolder& folder, const std::string& options) {
  TinyScenario scenario;
  scenario.bodies = sun_overhead;
  scenario.array = R"(samples="4" lines="4" ground_pitch_m="0.01")";
  scenario.solver = path_method;
  write_file(folder / "tiny.xml", scenario.text());
  const auto result = run_nadir("plan " + (folder / "tiny.xml").string() + " " + options);
  CAPTURE(result.err);
  REQUIRE(result.exit_code == 0);
  return result.out;
}

TEST_CASE("the JSON of nadir plan has what programs need", "[end_to_end][plan]") {
  const Json plan = Json::parse(plan_of(sim::support::ScratchFolder{}, "--format json"));
  std::set<std::string> names;
  for (const Json& effect : plan.at("effects")) {
    names.insert(effect.at("name").get<std::string>());
    const auto state = effect.at("state").get<std::string>();
    CAPTURE(state);
    const bool on = state.rfind("on", 0) == 0, off = state.rfind("off", 0) == 0;
    CHECK(on != off);
    const Json& bound = effect.at("bound").at("a").at("b");
    CHECK((bound.is_null() || bound.get<double>() >= 0.0));
    CHECK_FALSE(effect.at("reason").get<std::string>().empty());
    CHECK(effect.at("seconds").get<double>() >= 0.0);
    CHECK(effect.at("seconds_if_on").get<double>() >= 0.0);
    if (effect.at("name") == "solar_reflection") CHECK(on);
    if (effect.at("name") == "lamps") CHECK(state == "off (absent)");
  }
  CHECK(names.size() == radiometry::effect_count);
  for (const auto name : radiometry::effect_names) CHECK(names.count(std::string{name}) == 1);
  CHECK(plan.at("prediction").at("seconds").get<double>() > 0.0);
  CHECK(plan.at("prediction").at("memory_bytes").get<double>() > 1e6);
  CHECK(plan.at("prediction").at("error").at("a").at("b").contains("p95"));
  CHECK(plan.at("budget").at("relative").get<double>() == 0.01);
  CHECK(plan.at("budget").at("floor_radiance_w_m2_sr_um").at("a").at("b").get<double>() > 0.0);
  CHECK(plan.at("settings").contains("solver"));
}

TEST_CASE("the table of nadir plan names every effect in 120 columns", "[end_to_end][plan]") {
  const std::string text = plan_of(sim::support::ScratchFolder{}, "--accuracy 2%");
  for (const auto name : radiometry::effect_names) {
    CHECK(text.find(std::string{name}) != std::string::npos);
  }
  CHECK(text.find("2 %") != std::string::npos);
  std::istringstream lines{text};
  for (std::string line; std::getline(lines, line);) {
    CAPTURE(line);
    CHECK(line.size() <= 120);
  }
}

TEST_CASE("without a pilot nothing is foretold", "[end_to_end][plan]") {
  const Json plan = Json::parse(plan_of(sim::support::ScratchFolder{}, "--no-pilot --format json"));
  CHECK(plan.at("prediction").is_null());
  CHECK(plan.at("effects").size() == radiometry::effect_count);
}

TEST_CASE("wrong accuracies and times end with exit code 2", "[end_to_end][plan]") {
  const std::string scenario = data_file("yard.xml");
  const char* wrong = GENERATE("--accuracy 0%", "--accuracy 2", "--time 5m", "--time -1s",
                               "--format xml", "--threads -1");
  CAPTURE(wrong);
  const auto result = run_nadir("plan " + scenario + " " + wrong);
  CHECK(result.exit_code == 2);
  CHECK_FALSE(result.err.empty());
  CHECK(result.out.empty());
}

}  // namespace
}  // namespace nadir::end_to_end
