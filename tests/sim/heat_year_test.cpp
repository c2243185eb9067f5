#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <string>

#include "sim/run/world.hpp"
#include "sim/scenario/read_scenario.hpp"
#include "sim/scratch_folder.hpp"
#include "support/catch.hpp"

// Two summer days at Greensboro (TMY3, 5 and 6 August) over five of the library's materials, as
// they ship. docs/heat-year.md has the whole year.

namespace nadir::sim {
namespace {

constexpr std::array<const char*, 5> surfaces{"meadow_grass", "asphalt_road", "concrete_weathered",
                                              "galvanised_steel", "water"};

/// The five side by side, level and open; the picture is of 23 h on the second day.
std::string scenario_text() {
  std::string materials, planes;
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    const std::string name = surfaces[i];
    materials += "<material name=\"" + name + "\" solve=\"true\"/>\n";
    planes += "<plane material=\"" + name + "\" size_x_m=\"40\" size_y_m=\"40\" east_m=\"" +
              std::to_string(100 * i) + "\"/>\n";
  }
  const std::string weather =
      std::string{NADIR_SOURCE_DIR} + "/tests/sim/data/greensboro_two_days.csv";
  return R"(<scenario name="two_days">
<time utc="2026-08-07T04:00:00Z"/>
<site latitude_deg="36.1" longitude_deg="-79.95" height_m="273"/>
<illumination><ephemeris/></illumination><atmosphere><none/></atmosphere>
<heat history_h="46" shadow_interval_min="60"><weather_file file=")" +
         weather + R"("/></heat>
<materials><library file="library:materials.xml"/>)" +
         materials + "</materials>\n<geometry>" + planes + R"(</geometry>
<platform><position><local east_m="0" north_m="0" up_m="50"/></position>
<attitude><euler yaw_deg="0" pitch_deg="-90"/></attitude></platform>
<camera><orthographic><array name="a" samples="1" lines="1" ground_pitch_m="1">
<band_box name="t" lo_um="10" hi_um="11"/></array></orthographic></camera>
</scenario>)";
}

/// Degrees Celsius of the five and of the air about them.
struct Moment {
  double grass, asphalt, concrete, roof, water, air;
};

World loaded_world() {
  const support::ScratchFolder folder;
  const auto file = folder / "two_days.xml";
  std::ofstream{file} << scenario_text();
  Diagnostics diagnostics;
  InputFiles files;
  const Scenario scenario = read_scenario(file, diagnostics);
  return load_world(scenario, files, diagnostics);
}

using Records = std::array<thermal::HeatRecord, surfaces.size()>;
/// Solved once for all tests.
const Records& records() {
  static const Records solved = [] {
    const World world = loaded_world();
    Records result;
    for (std::size_t i = 0; i < surfaces.size(); ++i) {
      const Vec3 above{100.0 * static_cast<double>(i), 0.0, 10.0};
      const auto hit = world.scene.geometry.intersect({above, {0.0, 0.0, -1.0}});
      REQUIRE(hit);
      result[i] = world.heat->record(*hit);
    }
    return result;
  }();
  return solved;
}

/// @param hours  before the picture
Moment ahead_of_picture(std::size_t hours) {
  const auto row = [hours](const thermal::HeatRecord& record) {
    return record.rows[record.rows.size() - 1 - 6 * hours];  // steps of 10 min
  };
  const auto celsius = [&](std::size_t i) { return row(records()[i]).surface_k - 273.15; };
  return {celsius(0), celsius(1), celsius(2),
          celsius(3), celsius(4), row(records()[0]).weather.air_temperature_k - 273.15};
}

}  // namespace

TEST_CASE("by day asphalt is warmer than concrete, concrete than grass, grass than water",
          "[sim][heat]") {
  const Moment t = ahead_of_picture(9);  // 14 h, half clear, wind 2 m/s
  CHECK(t.asphalt > t.concrete + 4.0);   // absorptances 0.91 and 0.71
  CHECK(t.concrete > t.grass + 6.0);
  CHECK(t.grass > t.water + 3.0);
  // The Superpave rule has a road's highest temperature 24.6 K above the air's at this latitude.
  CHECK(t.asphalt - t.air > 20.0);
  CHECK(t.asphalt - t.air < 30.0);
  // Turf of lawns and greens stays within 7 to 8 K of the air (docs/heat-year.md).
  CHECK(t.grass - t.air > 1.0);
  CHECK(t.grass - t.air < 8.0);
  CHECK(t.roof - t.air > 20.0);
  CHECK(t.roof - t.air < 40.0);
  CHECK(std::abs(t.water - t.air) < 4.0);
}

TEST_CASE("before dawn grass and a metal roof are colder than the air, water is warmest",
          "[sim][heat]") {
  const Moment t = ahead_of_picture(18);  // 5 h, half an hour before sunrise
  CHECK(t.grass < t.air - 0.5);
  CHECK(t.roof < t.air - 0.5);
  CHECK(t.grass > t.air - 6.0);
  CHECK(t.roof > t.air - 6.0);
  CHECK(t.asphalt > t.air + 1.0);
  CHECK(t.concrete > t.air + 1.0);
  CHECK(t.water > t.asphalt + 1.0);
  CHECK(t.water > t.concrete + 1.0);
}

TEST_CASE("a pond follows the day by a few kelvin, a metal roof by forty", "[sim][heat]") {
  const auto range = [](const thermal::HeatRecord& record) {
    double low = 1e3, high = 0.0;
    for (const auto& row : record.rows) {
      low = std::min(low, row.surface_k);
      high = std::max(high, row.surface_k);
    }
    return high - low;
  };
  const auto& [grass, asphalt, concrete, roof, water] = records();
  CHECK(range(water) > 1.0);
  CHECK(range(water) < 5.0);
  CHECK(range(roof) > 30.0);
  CHECK(range(roof) < 50.0);
  CHECK(range(grass) < range(asphalt) - 5.0);
  CHECK(range(concrete) < range(asphalt) - 5.0);
  CHECK(range(asphalt) < range(roof) - 2.0);
}

}  // namespace nadir::sim
