#include "sim/run/check_view.hpp"

#include <fstream>

#include "core/text.hpp"
#include "sim/scenario/read_scenario.hpp"
#include "sim/scratch_folder.hpp"
#include "support/catch.hpp"

using namespace nadir;
using namespace nadir::sim;

namespace {

/// What is warned of a camera with one array of 1 m on the ground, 500 m above a plate.
std::vector<std::string> warnings(const std::string& platform, const std::string& array) {
  const support::ScratchFolder folder;
  std::ofstream{folder / "scenario.xml"} << R"(<scenario name="test">
  <time utc="2026-06-21T16:00:00Z"/>
  <site latitude_deg="36.4" longitude_deg="-84.2" height_m="300"/>
  <illumination><fixed/></illumination><atmosphere><none/></atmosphere>
  <materials default_temperature_k="300"><material name="m" reflectance="0.4"/></materials>
  <geometry><plane material="m" size_x_m="5000" size_y_m="5000"/></geometry>
  <platform>)" + platform + R"(</platform>
  <camera><perspective focal_length_mm="500"><array name="a" pitch_um="1000" )" +
                                                array + R"(
  <band_box name="t" lo_um="10" hi_um="11"/></array></perspective></camera>
</scenario>)";
  Diagnostics diagnostics;
  InputFiles files;
  const Scenario scenario = read_scenario(folder / "scenario.xml", diagnostics);
  const World world = load_world(scenario, files, diagnostics);
  Diagnostics viewing;
  check_view(world, viewing);
  return viewing.messages();
}
using Warnings = std::vector<std::string>;

std::string northward(double speed_m_s, const std::string& attitude) {
  return R"(<position><straight azimuth_deg="0" climb_m_s="0" speed_m_s=")" +
         number_text(speed_m_s) +
         R"("><local east_m="0" north_m="0" up_m="500"/></straight></position><attitude>)" +
         attitude + "</attitude>";
}
// 1 m a line at 100 m/s.
const std::string ahead = "<nadir/>", backwards = R"(<nadir yaw_deg="180"/>)";
const std::string still =
    R"(<position><local east_m="0" north_m="0" up_m="500"/></position>
    <attitude><euler yaw_deg="0" pitch_deg="-90"/></attitude>)";
const std::string lines = R"(samples="10" lines="20"><pushbroom line_period_ms="10"/>)";
const std::string whisk = R"(samples="100" lines="20"><whiskbroom sample_period_us="100"
    scan_period_ms="100" lines_per_scan="10"/>)";

std::string stages(const std::string& tdi) {
  return R"(samples="10" lines="20"><pushbroom line_period_ms="10" exposure_ms="10" )" + tdi + "/>";
}

}  // namespace

TEST_CASE("lines and samples that do not move over the ground are told", "[sim][check_view]") {
  CHECK(warnings(northward(100.0, ahead), lines).empty());
  const Warnings same_lines{"array a: all lines see the same ground; does the platform move?"};
  CHECK(warnings(still, lines) == same_lines);
  // Moves, but a mount holds the line of sight.
  CHECK(warnings(northward(100.0, ahead) + R"(<mounts><mount><stare><local east_m="0" north_m="0"
                 up_m="0"/></stare></mount></mounts>)",
                 lines) == same_lines);
  const Warnings same_samples{
      "array a: all samples of a sweep see the same ground; does a mount swing it?"};
  CHECK(warnings(still, whisk) == same_samples);
  CHECK(warnings(northward(100.0, ahead), whisk) == same_samples);
  CHECK(warnings(still, R"(samples="10" lines="20"><global_shutter/>)").empty());
}

TEST_CASE("charge that does not follow the ground's image is told", "[sim][check_view]") {
  const auto told = [](double speed_m_s, const std::string& attitude, const std::string& tdi) {
    const Warnings all = warnings(northward(speed_m_s, attitude), stages(tdi));
    return all.empty() ? std::string{} : all.front();
  };
  CHECK(told(100.0, ahead, R"(tdi_stages="16")").empty());
  CHECK(told(104.0, ahead, R"(tdi_stages="16")").empty());  // 0.64 rows
  CHECK(told(108.0, ahead, R"(tdi_stages="16")") ==
        "array a: the charge of its 16 stages does not follow the ground, whose image moves by "
        "1.08 rows in a line period with it: a blur of 1.28 rows; line_period_ms should fit speed "
        "and height");
  const std::string wrong =
      "array a: the charge of its 16 stages does not follow the ground, whose image moves by -1 "
      "rows in a line period with it: a blur of 32 rows; it moves against the charge: "
      "tdi_direction should be the other one";
  CHECK(told(100.0, ahead, R"(tdi_stages="16" tdi_direction="behind")") == wrong);
  CHECK(told(100.0, backwards, R"(tdi_stages="16")") == wrong);
  CHECK(told(100.0, backwards, R"(tdi_stages="16" tdi_direction="behind")").empty());
}
