#include <string>

#include "end_to_end/air_run.hpp"
#include "sim/files/air_table_file.hpp"

// Tables of the air that were made for another scene are refused, or told of.

namespace nadir::end_to_end {
namespace {

void replace(std::string& text, const std::string& from, const std::string& to) {
  const auto at = text.find(from);
  REQUIRE(at != std::string::npos);
  text.replace(at, from.size(), to);
}

/// A scenario that takes its air from the table that a run of `day` left, changed or not.
TinyScenario with_table_of_day(const AirFolder& folder, double interpolation_error) {
  TinyScenario scenario = day();
  scenario.bodies = R"(<body name="sun" azimuth_deg="180" elevation_deg="45" irradiance="1000"/>)";
  run_air(folder, looking_up(scenario));
  sim::AirTableFile file = sim::read_air_table(folder.table());
  file.table.interpolation_error = interpolation_error;
  sim::write_air_table(folder.folder() / "day.air", file);
  fs::remove_all(folder.folder() / "out");
  scenario.atmosphere = R"(<table file="day.air"/>)";
  return scenario;
}

}  // namespace

TEST_CASE("a table of the air is refused under another light", "[end_to_end][air]") {
  const AirFolder folder;
  TinyScenario scenario = with_table_of_day(folder, 0.01);
  SECTION("a brighter sun") {
    replace(scenario.bodies, "1000", "2000");
    CHECK(refusal(folder.folder(), scenario)
              .find("tiny.xml:5:13: error: the table of the air was made for a sun of 1000 W m^-2 "
                    "um^-1 at 0.45 um outside the air; the scene's sun has 2000") == 0);
  }
  SECTION("no sun") {
    scenario.bodies.clear();
    CHECK(refusal(folder.folder(), scenario)
              .find("tiny.xml:5:13: error: the table of the air holds the light of a sun at "
                    "elevation 45.00, azimuth 180.00 deg, where the scene has no body") == 0);
  }
}

TEST_CASE("a table of the air for another height, or a coarse one, is told of",
          "[end_to_end][air]") {
  const AirFolder folder;
  const TinyScenario scenario = with_table_of_day(folder, 0.2);
  const std::string height =
      "tiny.xml:5:13: the table of the air was made for a camera "
      "350 m above the sea; this one at 1800 m gets";
  const std::string error =
      "tiny.xml:5:13: the light of the air is interpolated to within 20 % at worst";
  const AirRun same = run_air(folder, scenario.text());
  CHECK_FALSE(same.says(height));
  CHECK(same.says(error));
  std::string text = scenario.text();
  replace(text, "up_m=\"50\"", "up_m=\"1500\"");
  CHECK(run_air(folder, text).says(height));
  // Within 5 % there is nothing to tell.
  CHECK_FALSE(run_air(folder, with_table_of_day(folder, 0.049).text()).says("interpolated to"));
}

}  // namespace nadir::end_to_end
