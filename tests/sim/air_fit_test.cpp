#include <cstddef>
#include <string>

#include "atmosphere/table/air_table.hpp"
#include "scenario_support.hpp"
#include "sim/air_table_support.hpp"
#include "sim/message_of.hpp"
#include "sim/run/air_memory.hpp"
#include "sim/run/check_air_bodies.hpp"
#include "sim/run/world.hpp"
#include "support/catch.hpp"

// Whether air, scene and machine go together, as told before the work.

namespace nadir::sim::test {
namespace {

using atmosphere::AirTable;
using ephemeris::Illumination;
using ephemeris::LightSource;
using support::message_of;

const SourceLocation place{"day.xml", 5, 13};
const WavelengthRange visible{Micrometres{0.5}, Micrometres{0.6}};

/// Made for a sun in the zenith with that irradiance.
AirTable table_of_sun(std::vector<float> irradiance) {
  AirTable table;
  table.lanes = {{0.5, {}, 1.0}, {0.6, {}, 1.0}, {0.7, {}, 1.0}, {10.0, {}, 1.0}};
  table.bodies = {{"sun", 0.0, 0.0, std::move(irradiance), {}, {}}};
  return table;
}

LightSource sun_of(double irradiance) {
  return {"sun", {0.0, 0.0, 1.0}, degrees(0.27), spectral::Curve::constant(irradiance)};
}

std::string said(const AirTable& table, const Illumination& bodies) {
  return message_of([&] { check_air_bodies(table, bodies, visible, place); });
}

/// The air of a scenario, and what was told while it was read.
struct Loaded {
  LayeredTask task;
  std::vector<std::string> warnings;
};
Loaded loaded(const std::string& air) {
  Diagnostics diagnostics;
  InputFiles files;
  const Scenario scenario =
      parse_scenario(nadir::test::replaced(nadir::test::minimal_text(), "<none/>", air),
                     nadir::test::data_folder() / "test.xml", diagnostics);
  auto task = *load_air_task(scenario, files, diagnostics)->layered;
  return {std::move(task), diagnostics.messages()};
}

std::size_t floats_of(const AirTable::View& view) {
  return view.extinction.size() + view.first.size() + view.smooth.size() + view.even.size() +
         view.ground.size();
}

std::size_t floats_of(const AirTable& table) {
  std::size_t floats = table.phase.size() + floats_of(table.sky) + table.spherical_albedo.size() +
                       table.even_ground_irradiance.size() + table.night_top.size();
  for (const AirTable::View& view : table.views) floats += floats_of(view);
  for (const AirTable::Body& body : table.bodies) {
    floats += body.irradiance.size() + body.transmittance.size() + body.ground_irradiance.size();
  }
  return floats;
}

}  // namespace

TEST_CASE("a table of the air serves the sun that it was made for", "[sim][air]") {
  const std::string fits = "(nothing thrown)";
  const AirTable table = table_of_sun({1000.0F, 1000.0F, 1000.0F, 0.0F});
  // 1 % apart is as good as the same. Beyond the camera's bands nothing is seen of it.
  CHECK(said(table, {sun_of(1000.0)}) == fits);
  CHECK(said(table, {sun_of(1009.0)}) == fits);
  CHECK(said(table, {sun_of(991.0)}) == fits);
  CHECK(said(table, {sun_of(2000.0)}) ==
        "day.xml:5:13: error: the table of the air was made for a sun of 1000 W m^-2 um^-1 at 0.5 "
        "um outside the air; the scene's sun has 2000\n"
        "    hint: the scene's irradiance must be the one that the table was made with\n");
  CHECK(said(table, {sun_of(988.0)}).find("day.xml:5:13: error: ") == 0);
  // The lane that is off the most is told; the next one beyond the bands counts, lanes lie between.
  CHECK(said(table_of_sun({1000.0F, 1000.0F, 500.0F, 0.0F}), {sun_of(1000.0)})
            .find("of 500 W m^-2 um^-1 at 0.7 um") != std::string::npos);
}

TEST_CASE("a table of the air does not bring light that the scene has not", "[sim][air]") {
  const AirTable table = table_of_sun({1000.0F, 1000.0F, 1000.0F, 0.0F});
  const std::string error =
      "day.xml:5:13: error: the table of the air holds the light of a sun at elevation 90.00, "
      "azimuth 0.00 deg, where the scene has no body that shines\n";
  CHECK(said(table, {}) == error);
  CHECK(said(table, {sun_of(0.0)}) == error);
  CHECK(said(table_of_sun({0.0F, 0.0F, 0.0F, 0.0F}), {}) == "(nothing thrown)");
  // A sun that has set still makes twilight: it is there, and need not be in a table.
  AirTable twilight = table;
  twilight.bodies[0].zenith_rad = degrees(94.0).value;
  LightSource set = sun_of(1000.0);
  set.direction_enu = {0.0, std::sin(degrees(94.0).value), std::cos(degrees(94.0).value)};
  CHECK(said(twilight, {set}) == "(nothing thrown)");
  CHECK(said(twilight, {}).find("elevation -4.00") != std::string::npos);
  CHECK(said(AirTable{}, {set}) == "(nothing thrown)");
}

TEST_CASE("the memory of a table is known before it is made", "[sim][air]") {
  for (const char* text :
       {R"(<layered mode="fast"/>)",
        R"(<layered mode="fast"><aerosol type="none"/>)"
        R"(<cloud type="cirrus" base_m="8000" top_m="9000" optical_depth_550="1"/></layered>)"}) {
    LayeredTask task = loaded(text).task;
    task.settings.zenith_nodes = 6;
    task.settings.azimuth_nodes = 4;
    task.settings.share_nodes = 5;
    task.settings.observer_height_m = 3000.0;
    const std::vector<Micrometres> wavelengths{Micrometres{0.55}};
    const auto lanes = split_lanes(task.air, task.settings, wavelengths, {});
    const AirTable table =
        make_air_table(task.air, task.settings, lanes, wavelengths, {sun_of(1000.0)});
    const double bytes = 2.0 * sizeof(float) * static_cast<double>(floats_of(table));
    CAPTURE(text, bytes);
    const double estimate = air_table_memory(task, lanes.size(), 1);
    CHECK(estimate >= bytes);
    CHECK(estimate <= 1.2 * bytes);
    CHECK(air_table_memory(task, 1000 * lanes.size(), 1) ==
          Approx(1000.0 * estimate).epsilon(1e-9));
  }
}

TEST_CASE("a table of the air that does not fit is refused", "[sim][air]") {
  const Camera camera;
  CHECK_NOTHROW(check_memory(camera, {10, 1e6}));
  CHECK(message_of([&] {
          check_memory(camera, {123456, 1e15});
        })
            .find("error: the images and the table of the air's 123456 lanes need 1000000.0 GB of "
                  "memory, this machine has ") == 0);
}

TEST_CASE("haze that lets nothing through is told of at its element", "[sim][air]") {
  const auto warnings = [](const std::string& aerosol) {
    return loaded("<layered>" + aerosol + "</layered>").warnings;
  };
  // 3.912 / 0.1 km of extinction over a kilometre or two.
  const auto dense = warnings(R"(<aerosol type="fog_advection" visibility_km="0.1"/>)");
  REQUIRE(dense.size() == 1);
  CHECK(dense[0].find("test.xml:7:24: the haze of the lowest 2 km has an optical depth") !=
        std::string::npos);
  CHECK(dense[0].find("<cloud> at the ground") != std::string::npos);
  CHECK(warnings(R"(<aerosol visibility_km="1"/>)").empty());
  CHECK(warnings(R"(<aerosol optical_depth_550="15"/>)").empty());
  CHECK(warnings(R"(<aerosol type="none"/>)").empty());
}

TEST_CASE("air with clouds has 16 streams unless it says otherwise", "[sim][air]") {
  const std::string cloud =
      R"(<cloud type="stratus" base_m="500" top_m="900" optical_depth_550="9"/></layered>)";
  CHECK(loaded("<layered/>").task.settings.streams == 8);
  CHECK(loaded("<layered>" + cloud).task.settings.streams == 16);
  CHECK(loaded("<layered streams=\"8\">" + cloud).task.settings.streams == 8);
}

}  // namespace nadir::sim::test
