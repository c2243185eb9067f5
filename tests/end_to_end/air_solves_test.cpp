#include <string>

#include "end_to_end/air_run.hpp"
#include "support/catch.hpp"

// Only what is called for is solved: told by the report's counts of solves over lanes.

namespace nadir::end_to_end {
namespace {

std::string sun_at(const std::string& elevation_deg) {
  return R"(<body name="sun" azimuth_deg="180" elevation_deg=")" + elevation_deg +
         R"(" irradiance="library:illumination/solar.csv"/>)";
}

int lanes_of(const AirFolder& folder, TinyScenario scenario, const std::string& band) {
  scenario.band = band;
  return run_air(folder, scenario.text()).number("lanes");
}

}  // namespace

TEST_CASE("each lane of visible and infrared is solved for its own light", "[end_to_end][air]") {
  const AirFolder folder;
  TinyScenario scenario = day();
  const int visible = lanes_of(folder, scenario, blue_and_red);
  const int infrared = lanes_of(folder, scenario, window);
  scenario.band = blue_and_red + window;
  const AirRun both = run_air(folder, scenario.text());
  REQUIRE(both.number("lanes") == visible + infrared);
  CHECK(both.number("thermal_solves") == infrared);
  // At 10.7 um haze scatters sunlight of 0.2 W m^-2 um^-1 weakly: some of its lanes may need it.
  CHECK(both.number("beam_solves") >= visible);
  CHECK(both.number("beam_solves") <= visible + infrared);
}

TEST_CASE("a sun far below the horizon is not solved for", "[end_to_end][air]") {
  const AirFolder folder;
  TinyScenario scenario = day();
  scenario.band = blue_and_red + window;
  scenario.bodies = sun_at("-19");
  const AirRun night = run_air(folder, looking_up(scenario));
  CHECK(night.number("beam_solves") == 0);
  CHECK(night.number("bodies") == 0);
  CHECK(night.number("thermal_solves") < night.number("lanes"));
  CHECK(night.number("thermal_solves") > 0);
  // The night sky: some 1e-6 W m^-2 sr^-1 um^-1, 1e-8 of the day's.
  CHECK(night.radiance(1) > 1e-7);
  CHECK(night.radiance(1) < 1e-4);
  scenario.bodies = sun_at("-6");
  const AirRun dusk = run_air(folder, looking_up(scenario));
  CHECK(dusk.number("beam_solves") > 0);
  CHECK(dusk.radiance(0) > 10.0 * night.radiance(0));
}

TEST_CASE("air without a sun solves nothing but what it must", "[end_to_end][air]") {
  // No body, no night sky, the visible: columns are made, nothing is solved, all is black.
  const AirFolder folder;
  TinyScenario scenario = day();
  scenario.bodies = "";
  scenario.atmosphere = R"(<layered mode="fast" night_sky="false"/>)";
  const AirRun dark = run_air(folder, looking_up(scenario));
  CHECK(dark.number("beam_solves") == 0);
  CHECK(dark.radiance(0) == Approx(0.0).margin(1e-12));
  CHECK(dark.radiance(1) == Approx(0.0).margin(1e-12));
}

}  // namespace nadir::end_to_end
