#include "sim/run/load_lamps.hpp"

#include <fstream>
#include <memory>
#include <numbers>
#include <string>

#include "geometry/scene_builder.hpp"
#include "scenario_support.hpp"
#include "support/catch.hpp"

using namespace nadir;
using namespace nadir::sim;
using test::minimal_text;
using test::mistake_lines;
using test::replaced;

namespace {

/// The minimal scenario with these lamps; they begin in line 14.
std::string with_lamps(const std::string& lamps) {
  return replaced(minimal_text(), "  <platform>", "<lamps>\n" + lamps + "\n</lamps>\n  <platform>");
}

LoadedLamps load_lamps(const std::string& lamps, const std::filesystem::path& folder = "/tmp") {
  Diagnostics diagnostics;
  InputFiles files;
  return load_lamps(parse_scenario(with_lamps(lamps), folder / "test.xml", diagnostics), {}, 7,
                    files);
}

std::string load_error(const std::string& lamps, const std::filesystem::path& folder) {
  try {
    (void)load_lamps(lamps, folder);
    return {};
  } catch (const InputError& error) {
    std::string lines;
    for (const InputIssue& issue : error.issues()) {
      lines += issue.where.file.substr(issue.where.file.rfind('/') + 1) + ":" +
               std::to_string(issue.where.line) + ": " + issue.message + "\n";
    }
    return lines;
  }
}

void write_lamps(const std::filesystem::path& file, const std::string& text) {
  std::ofstream{file} << text;
}

bool close(Vec3 a, Vec3 b) { return length(a - b) < 1e-12; }

const std::string even_ies =
    "IESNA:LM-63-2002\nTILT=NONE\n1 1000 1 2 1 1 2 0 0 0\n1 1 60\n0 90\n0\n100 100\n";

}  // namespace

TEST_CASE("lamps of all kinds are read and placed", "[sim][lamps]") {
  const LoadedLamps loaded = load_lamps(
      R"(<point_lamp name="bulb" east_m="1" north_m="2" up_m="3" flux_w_per_um="40"/>
<spot_lamp up_m="8" axis="0 1 -1" half_angle_deg="60" cosine_power="2" lumens="5000" colour_temperature_k="3000"/>
<area_lamp material="grey" up_m="5" yaw_deg="90" flux_w_per_um="9"><plane size_x_m="2" size_y_m="1"/></area_lamp>
<area_lamp material="grey" up_m="2" aim_m="5 0 2" flux_w_per_um="9"><disc radius_m="0.5"/></area_lamp>)");
  REQUIRE(loaded.lamps.size() == 4);
  const auto& bulb = std::get<radiometry::PointLamp>(loaded.lamps[0].form);
  CHECK(loaded.lamps[0].name == "bulb");
  CHECK(loaded.lamps[0].where.line == 15);
  CHECK(bulb.position == Vec3{1.0, 2.0, 3.0});
  CHECK(loaded.lamps[0].flux.curve->at(Micrometres{10.0}) == 40.0);
  const auto& spot = std::get<radiometry::PointLamp>(loaded.lamps[1].form);
  CHECK(close(spot.axis, normalised({0.0, 1.0, -1.0})));
  CHECK(close(spot.side, normalised({0.0, 1.0, 1.0})));  // north, tilted with the axis
  CHECK(std::get<radiometry::CosinePower>(spot.shape).half_angle_rad ==
        Approx(std::numbers::pi / 3).epsilon(1e-14));
  CHECK(loaded.lamps[1].flux.factor == 5000.0);
  REQUIRE(loaded.surfaces.size() == 2);
  const auto& plane = std::get<radiometry::AreaLamp>(loaded.lamps[2].form);
  CHECK(plane.object == 7);
  CHECK(close(plane.axis_x, {1.0, 0.0, 0.0}));  // azimuth 90 degrees
  CHECK(close(cross(plane.axis_x, plane.axis_y), {0.0, 0.0, -1.0}));
  CHECK(loaded.surfaces[0].object == 7);
  CHECK(close(loaded.surfaces[0].placement.vector({0.0, 0.0, 1.0}), {0.0, 0.0, -1.0}));
  CHECK(close(loaded.surfaces[0].placement.origin, {0.0, 0.0, 5.0}));
  CHECK(loaded.surfaces[1].object == 8);
  CHECK(close(loaded.surfaces[1].placement.vector({0.0, 0.0, 1.0}), {1.0, 0.0, 0.0}));
}

TEST_CASE("a photometric file brings its shape and, unless told otherwise, its lumens",
          "[sim][lamps]") {
  const test::TemporaryFolder folder;
  write_lamps(folder / "a.ies", even_ies);
  const LoadedLamps loaded =
      load_lamps(R"(<point_lamp up_m="9" ies="a.ies" colour_temperature_k="4000"/>
<point_lamp up_m="9" ies="a.ies" axis="1 0 0" lumens="77" colour_temperature_k="4000"/>)",
                 folder / "");
  CHECK(loaded.lamps[0].flux.factor == Approx(200.0 * std::numbers::pi).epsilon(1e-14));
  CHECK(loaded.lamps[1].flux.factor == 77.0);
  CHECK(loaded.lamps[0].flux.curve == loaded.lamps[1].flux.curve);  // shared
  const auto table = [&](std::size_t i) {
    return std::get<std::shared_ptr<const radiometry::IntensityTable>>(
        std::get<radiometry::PointLamp>(loaded.lamps[i].form).shape);
  };
  CHECK(table(0) == table(1));
}

TEST_CASE("a list places its lamp by every row, turned and with the row's light", "[sim][lamps]") {
  const test::TemporaryFolder folder;
  write_lamps(folder / "s.csv",
              "east_m,north_m,up_m,yaw_deg,lumens\n10,0,0,90,100\n20,0,1,0,200\n");
  const LoadedLamps loaded = load_lamps(
      R"(<lamps_list file="s.csv" name="street">
<spot_lamp north_m="1" up_m="8" axis="0 1 -1" half_angle_deg="70" colour_temperature_k="3000"/>
</lamps_list>)",
      folder / "");
  REQUIRE(loaded.lamps.size() == 2);
  const auto& first = std::get<radiometry::PointLamp>(loaded.lamps[0].form);
  CHECK(close(first.position, {11.0, 0.0, 8.0}));  // an arm to the north, turned east
  CHECK(close(first.axis, normalised({1.0, 0.0, -1.0})));
  CHECK(loaded.lamps[0].name == "street, line 2");
  CHECK(loaded.lamps[0].flux.factor == 100.0);
  CHECK(loaded.lamps[1].flux.factor == 200.0);
  CHECK(close(std::get<radiometry::PointLamp>(loaded.lamps[1].form).position, {20.0, 1.0, 9.0}));
}

TEST_CASE("mistakes of lamps in a scenario are told where they are", "[sim][lamps]") {
  const auto lines = [](const std::string& lamp) { return mistake_lines(with_lamps(lamp)); };
  const std::string light = "flux_w_per_um=\"1\" ";
  CHECK(lines("<point_lamp flux_w_per_um=\"-1\"/>") ==
        "15:13: attribute \"flux_w_per_um\" of <point_lamp>: \"-1\", expected a number from 0 to "
        "1e12, or a spectrum file *.csv or *.csv#column [W um^-1]\n");
  CHECK(lines("<point_lamp/>") ==
        "15:1: <point_lamp> needs flux_w_per_um, or lumens and colour_temperature_k\n");
  CHECK(lines("<point_lamp lumens=\"5\"/>") ==
        "15:1: <point_lamp> lacks colour_temperature_k, which says how its lumens are spread over "
        "wavelengths\n");
  CHECK(lines("<point_lamp colour_temperature_k=\"3000\"/>") ==
        "15:1: <point_lamp> needs lumens\n");
  CHECK(lines("<point_lamp flux_w_per_um=\"1\" lumens=\"5\" colour_temperature_k=\"3000\"/>") ==
        "15:13: give either flux_w_per_um, or lumens and colour_temperature_k, not both\n");
  CHECK(lines("<spot_lamp " + light + "half_angle_deg=\"9\" axis=\"0 0 0\"/>") ==
        "15:49: the axis of <spot_lamp> has no length\n");
  CHECK(lines("<spot_lamp " + light + "half_angle_deg=\"9\" aim_m=\"0 0 0\"/>") ==
        "15:49: <spot_lamp> is aimed at its own place\n");
  CHECK(lines("<point_lamp " + light + "ies=\"nowhere.ies\"/>")
            .starts_with("15:31: file \"nowhere.ies\" does not exist"));
  CHECK(lines("<point_lamp " + light + "axis=\"0 0 1\"/>") ==
        "15:31: <point_lamp> without ies shines alike in all directions: axis would do nothing\n");
  CHECK(lines("<point_lamp " + light + "on_terrain=\"true\"/>") ==
        "15:31: <point_lamp> stands on the terrain, but <geometry> has no <terrain>\n");
  CHECK(lines("<area_lamp " + light + "material=\"gray\"><disc radius_m=\"1\"/></area_lamp>") ==
        "15:30: material \"gray\" is not declared in <materials> (did you mean \"grey\"?)\n");
  CHECK(lines("<area_lamp " + light + "material=\"grey\"/>") ==
        "15:1: <area_lamp> needs <disc> or <plane> or <sphere>\n");
}

TEST_CASE("mistakes that a list of lamps brings to light name its line", "[sim][lamps]") {
  const test::TemporaryFolder folder;
  write_lamps(folder / "s.csv", "east_m,north_m\n10,0\n");
  write_lamps(folder / "l.csv", "east_m,north_m,lumens\n10,0,9\n");
  const auto error = [&](const std::string& list, const std::string& lamp) {
    return load_error("<lamps_list file=\"" + list + "\">" + lamp + "</lamps_list>", folder / "");
  };
  CHECK(error("s.csv", "<point_lamp colour_temperature_k=\"3000\"/>") ==
        "s.csv:2: lamp point_lamp: neither the list nor the lamp gives flux_w_per_um or lumens\n");
  CHECK(error("l.csv", "<point_lamp/>") ==
        "l.csv:2: lamp point_lamp: neither the list nor the lamp gives colour_temperature_k\n");
  CHECK(error("l.csv", "<point_lamp flux_w_per_um=\"1\"/>") ==
        "l.csv:2: lamp point_lamp: the list gives lumens or a colour temperature, but the lamp has "
        "flux_w_per_um\n");
}

TEST_CASE("a lamp inside a solid is an error, beside it and in an open box it is not",
          "[sim][lamps]") {
  geometry::SceneBuilder builder;
  builder.add({geometry::Shape{geometry::Box{{-1, -1, 0}, {1, 1, 2}}}, {0}}, Affine{}, 0);
  const geometry::Scene scene = builder.build();
  Diagnostics diagnostics;
  const auto checked = [&](const std::string& lamp, const std::string& material) {
    InputFiles files;
    const Scenario scenario = parse_scenario(
        replaced(with_lamps(lamp), "<material name=\"grey\" reflectance=\"0.5\"/>", material),
        "/t.xml", diagnostics);
    try {
      check_lamps(scene, scenario, load_lamps(scenario, {}, 1, files).lamps, diagnostics);
      return std::string{};
    } catch (const InputError& error) {
      const InputIssue& issue = error.issues().front();
      return std::to_string(issue.where.line) + ": " + issue.message;
    }
  };
  const std::string grey = "<material name=\"grey\" reflectance=\"0.5\"/>";
  const std::string inside = "<point_lamp name=\"a\" up_m=\"1\" flux_w_per_um=\"1\"/>";
  const std::string told =
      "15: lamp a is inside object \"plane\", an opaque solid that shuts its light in";
  CHECK(checked(inside, grey) == told);
  CHECK(checked(R"(<point_lamp name="a" up_m="2.1" flux_w_per_um="1"/>)", grey).empty());
  CHECK(checked(R"(<area_lamp name="a" material="grey" up_m="1" flux_w_per_um="1">)"
                R"(<sphere radius_m="0.2"/></area_lamp>)",
                grey) == told);
  CHECK(checked(R"(<area_lamp name="a" material="grey" up_m="1" flux_w_per_um="1">)"
                R"(<disc radius_m="0.2"/></area_lamp>)",
                grey) == told);
  // Glass lets its light out.
  CHECK(checked(inside,
                "<material name=\"grey\" reflectance=\"0.1\" transmittance=\"0.9\">"
                "<clear_sheet/></material>")
            .empty());
  CHECK(diagnostics.messages().empty());
}

TEST_CASE("a lamp that sees only backs on one side gets a warning", "[sim][lamps]") {
  geometry::SceneBuilder builder;  // a roof: its upper side is its front
  builder.add({geometry::Shape{geometry::Plane{{0, 0, 3}, 100, 100}}, {0}}, Affine{}, 0);
  const geometry::Scene scene = builder.build();
  Diagnostics diagnostics;
  InputFiles files;
  const Scenario scenario = parse_scenario(
      with_lamps(R"(<point_lamp name="a" up_m="1" flux_w_per_um="1"/>)"), "/t.xml", diagnostics);
  CHECK_NOTHROW(
      check_lamps(scene, scenario, load_lamps(scenario, {}, 1, files).lamps, diagnostics));
  REQUIRE(diagnostics.messages().size() == 1);
  CHECK(diagnostics.messages()[0] ==
        "lamp a sees only the back of object \"plane\": does it stand inside?");
}
