#include <cmath>

#include "scenario_support.hpp"
#include "support/catch.hpp"

// Sources of temperature in scenarios: which counts where, and what contradicts itself.

using namespace nadir;
using namespace nadir::sim;
using test::kelvin_of;
using test::minimal_text;
using test::mistake_lines;
using test::replaced;

namespace {

/// What parse_scenario says of a text besides mistakes.
std::string warnings_of(const std::string& text) {
  Diagnostics diagnostics;
  static_cast<void>(parse_scenario(text, test::data_folder() / "test.xml", diagnostics));
  std::string all;
  for (const std::string& message : diagnostics.messages()) {
    all += message.substr(message.rfind("test.xml") + 8) + "\n";
  }
  return all;
}

Scenario read_temperature(const std::string& text) {
  Diagnostics diagnostics;
  return parse_scenario(text, test::data_folder() / "test.xml", diagnostics);
}
Scenario warm() { return read_temperature(test::warm_text()); }

/// The minimal scenario with other materials in line 9; "grey" must be among them.
std::string with_temperature_materials(const std::string& materials) {
  return replaced(minimal_text(), "    <material name=\"grey\" reflectance=\"0.5\"/>", materials);
}
/// The same with one material whose source of temperature is `source`.
std::string with_source(const std::string& source, const std::string& attributes = "") {
  return with_temperature_materials("<material name=\"grey\" reflectance=\"0.5\"" + attributes +
                                    ">\n" + source + "</material>");
}
std::string told_temperature(const std::string& source, const std::string& attributes = "") {
  return mistake_lines(with_source(source, attributes));
}
/// The minimal scenario with other geometry in line 12.
std::string with_geometry(const std::string& geometry) {
  return replaced(minimal_text(),
                  "    <plane material=\"grey\" size_x_m=\"100\" size_y_m=\"100\"/>", geometry);
}

int shape_material(const Scenario& scenario, std::size_t object) {
  return std::get<ShapeInput>(std::get<ObjectInput>(scenario.geometry.at(object)).form).material;
}
const MaterialInput& material_of(const Scenario& scenario, int index) {
  return scenario.materials.at(static_cast<std::size_t>(index));
}

// Kelvin and degrees Celsius differ by 273.15, which no decimal fraction of a degree hits exactly.
Approx about_temperature(double kelvin) { return Approx(kelvin).epsilon(1e-15); }

}  // namespace

TEST_CASE("temperatures are given in kelvin or in degrees Celsius", "[scenario][temperature]") {
  const Scenario s = warm();
  REQUIRE(s.materials.size() > 10);
  CHECK(kelvin_of(s.materials[0]) == 310.5);
  CHECK(kelvin_of(s.materials[1]) == about_temperature(270.0));
  CHECK(kelvin_of(s.materials[2]) == about_temperature(288.15));
  CHECK(kelvin_of(read_temperature(minimal_text()).materials.at(0)) == 300.0);
  const auto said = [](const std::string& temperature) {
    return mistake_lines(replaced(minimal_text(), "default_temperature_k=\"300\"", temperature));
  };
  CHECK(said("default_temperature_k=\"300\" default_temperature_c=\"27\"") ==
        "8:42: give either default_temperature_k or default_temperature_c, not both\n");
  CHECK(said("default_temperature_c=\"-273.16\"") ==
        "8:14: attribute \"default_temperature_c\" of <materials>: \"-273.16\", expected a number "
        "from -273.15 to 5726.85 [deg C]\n");
  CHECK(said("default_temperature=\"300\"") ==
        "8:14: <materials> has no attribute \"default_temperature\" (did you mean "
        "\"default_temperature_k\"?)\n");
}

TEST_CASE("only materials that all have a source need no default", "[scenario][temperature]") {
  const auto said = [](const std::string& materials) {
    return mistake_lines(
        replaced(with_temperature_materials(materials), " default_temperature_k=\"300\"", ""));
  };
  CHECK(said("<material name=\"grey\" reflectance=\"0.5\" temperature_c=\"5\"/>").empty());
  CHECK(said("<material name=\"grey\" reflectance=\"0.5\"/>") ==
        "8:3: <materials> has no default temperature, and one material has no source of it: grey "
        "(write default_temperature_k=\"288.15\" or default_temperature_c=\"15\")\n");
  CHECK(said("<material name=\"grey\" reflectance=\"0.5\"/><material name=\"b\" emissivity=\"1\" "
             "temperature_k=\"4\"/><material name=\"c\" emissivity=\"1\" solve=\"false\"/>") ==
        "8:3: <materials> has no default temperature, and some materials have no source of it: "
        "grey, c (write default_temperature_k=\"288.15\" or default_temperature_c=\"15\")\n");
}

TEST_CASE("a raster of temperatures has a place, a unit and perhaps slices over time",
          "[scenario][temperature]") {
  const Scenario s = warm();
  const auto& field = std::get<TemperatureRasterInput>(s.materials.at(5).temperature);
  REQUIRE(field.slices.size() == 1);
  CHECK(field.slices[0].file == test::data_folder() / "ground.asc");
  CHECK(field.slices[0].band == 1);
  CHECK_FALSE(field.slices[0].time);
  CHECK(field.gain == 0.1);
  CHECK(field.offset_k == about_temperature(275.15));
  CHECK(field.place.repeats);
  CHECK(std::get<GroundDrape>(field.place.drape).area->west_m == -50.0);
  CHECK(field.where.line == 29);
  const auto& car = std::get<TemperatureRasterInput>(s.materials.at(6).temperature);
  REQUIRE(car.slices.size() == 2);  // by time
  CHECK(car.slices[0].time->to_string() == "2026-06-21T15:00:00Z");
  CHECK(car.slices[0].band == 1);
  CHECK(car.slices[1].time->to_string() == "2026-06-21T17:00:00Z");
  CHECK(car.slices[1].band == 2);
  CHECK(car.offset_k == 0.0);
  CHECK(std::get<TextureDrape>(car.place.drape).size_u == 2.0);
}

TEST_CASE("rasters of temperatures that contradict themselves are located",
          "[scenario][temperature][mistakes]") {
  const std::string slice = "<slice utc=\"2026-06-21T15:00:00Z\" file=\"ground.asc\"/>";
  CHECK(told_temperature("<temperature_raster/>") ==
        "10:1: <temperature_raster> has neither a file nor a <slice> (write file=\"...\", or a "
        "<slice utc=\"...\" file=\"...\"/> for each time)\n");
  CHECK(told_temperature("<temperature_raster file=\"ground.asc\" band=\"2\">" + slice +
                         "</temperature_raster>") ==
        "10:21: file is for a raster without slices, which name their own\n"
        "10:39: band is for a raster without slices, which name their own\n");
  CHECK(told_temperature("<temperature_raster>" + slice + "\n" + slice + "</temperature_raster>") ==
        "11:8: a slice of 2026-06-21T15:00:00Z is there already, in line 10\n");
  CHECK(told_temperature("<temperature_raster><slice file=\"ground.asc\"/></temperature_raster>") ==
        "10:21: <slice> lacks its attribute \"utc\" (it is a time in UTC such as "
        "2026-06-21T16:00:00Z)\n");
  CHECK(told_temperature("<temperature_raster file=\"ground.asc\" unit=\"F\"/>") ==
        "10:39: attribute \"unit\" of <temperature_raster>: \"F\", expected K or C\n");
  CHECK(told_temperature("<temperature_raster file=\"ground.asc\" size_u=\"2\"/>") ==
        "10:39: size_u is for maps with drape=\"texture\"\n");
  CHECK(told_temperature("<temperature_raster file=\"ground.asc\" west_m=\"2\"/>") ==
        "10:1: <temperature_raster> lacks south_m: give all four edges or none\n");
  CHECK(told_temperature("<temperature_raster file=\"none.asc\"/>")
            .find("10:21: file \"none.asc\" does not") == 0);
}

TEST_CASE("tables, vertices and the air are sources of temperature", "[scenario][temperature]") {
  const Scenario s = warm();
  const auto& engine = std::get<TemperatureTableInput>(s.materials.at(7).temperature);
  CHECK(engine.file == test::data_folder() / "weather.csv");
  CHECK(engine.column == "engine_c");
  CHECK(engine.where.line == 39);
  const auto& statue = std::get<VertexTemperatureInput>(s.materials.at(8).temperature);
  CHECK(statue.gain == 0.5);
  CHECK(statue.offset_k == about_temperature(273.15));
  CHECK(std::get<AirTemperatureInput>(s.materials.at(9).temperature).offset_k == -1.5);
  CHECK(told_temperature("<temperature_table/>") ==
        "10:1: <temperature_table> lacks its attribute \"file\" (it is a file *.csv)\n");
  CHECK(told_temperature("<vertex_temperatures/>")
            .find("10:1: <material> may not hold <vertex_temperatures> "
                  "(did you mean \"vertex_temperature\"?)") == 0);
}

TEST_CASE("a material has one source of temperature", "[scenario][temperature][mistakes]") {
  CHECK(told_temperature("", " temperature_k=\"300\" temperature_c=\"27\"") ==
        "9:61: a material has one source of temperature; temperature_k stands in line 9 already\n");
  CHECK(told_temperature("<vertex_temperature/>", " temperature_k=\"300\"")
            .find("10:1: a material has one source of temperature; temperature_k stands in line 9 "
                  "already\n") == 0);
  CHECK(told_temperature("<temperature_table file=\"weather.csv\"/>\n<temperature_raster/>") ==
        "11:1: a material has one source of temperature; <temperature_table> stands in line 10 "
        "already\n"
        "11:1: <temperature_raster> has neither a file nor a <slice> (write file=\"...\", or a "
        "<slice utc=\"...\" file=\"...\"/> for each time)\n");
}

TEST_CASE("solve asks a library's material for its heat balance",
          "[scenario][temperature][mistakes]") {
  const Scenario s = warm();
  const auto& balance = std::get<HeatBalanceInput>(s.materials.at(3).temperature);
  REQUIRE(balance.layers.size() == 2);
  CHECK(balance.layers[0].substance == "asphalt_pavement");
  CHECK(balance.where.file == (test::data_folder() / "warm_library.xml").string());
  CHECK(balance.where.line == 4);
  const std::string library = "<library file=\"warm_library.xml\"/>";
  const std::string hint =
      " (in place of solve put <heat_balance><layer substance=\"...\"/></heat_balance> into it)\n";
  // Without solve the library's heat balance is not used.
  CHECK(kelvin_of(read_temperature(with_temperature_materials(
                                       library + "<material name=\"grey\" from=\"asphalt\"/>"))
                      .materials.at(0)) == 300.0);
  CHECK(told_temperature("", " solve=\"true\"") ==
        "9:41: solve asks for the heat balance of a library's material, but \"grey\" is not from a "
        "library" +
            hint);
  CHECK(mistake_lines(with_temperature_materials(
            library + "<material name=\"grey\" from=\"meadow\" solve=\"true\"/>")) ==
        "9:71: the library's material \"meadow\" has no heat balance" + hint);
  CHECK(mistake_lines(with_temperature_materials(
                          library + "<material name=\"grey\" from=\"lawn\" solve=\"true\"/>"))
            .find("heat balance") == std::string::npos);
}

TEST_CASE("a library's mistakes in heat balances are told with its own lines",
          "[scenario][temperature][mistakes]") {
  const test::TemporaryFolder folder;
  std::ofstream{folder / "own.xml"} << "<materials>\n<material name=\"grey\" emissivity=\"1\">\n"
                                       "<heat_balance><layer/></heat_balance></material>\n"
                                       "</materials>\n";
  CHECK(
      mistake_lines(with_temperature_materials("<library file=\"" + (folder / "own.xml").string() +
                                               "\"/><material name=\"grey\"/>")) ==
      "3:15: <layer> says not what it is made of (write substance=\"...\", or "
      "conductivity_w_m_k, density_kg_m3 and specific_heat_j_kg_k)\n");
}

TEST_CASE("a part's temperature goes before its object's, and that before its material's",
          "[scenario][temperature]") {
  const Scenario s = warm();
  const auto& hut = std::get<MeshInput>(std::get<ObjectInput>(s.geometry.at(1)).form);
  REQUIRE(hut.parts.size() == 3);
  const MaterialInput& roof = material_of(s, hut.parts[0].material);
  CHECK(roof.name == "car@engine");
  CHECK(roof.variant_of == 6);
  CHECK(std::get<TemperatureTableInput>(roof.temperature).column == "engine_c");
  const MaterialInput& walls = material_of(s, hut.parts[1].material);
  CHECK(walls.name == "roof@303.15 K");
  CHECK(walls.variant_of == 4);
  CHECK(kelvin_of(walls) == about_temperature(303.15));
  CHECK(std::get<double>(walls.reflectance->source) == 0.6);
  const MaterialInput& rest = material_of(s, hut.parts[2].material);
  CHECK(rest.name == "car@303.15 K");
  CHECK(rest.variant_of == 6);
}

TEST_CASE("each pair of material and temperature is one variant, numbered before the maps",
          "[scenario][temperature]") {
  const Scenario s = warm();
  const int first = shape_material(s, 4);
  CHECK(material_of(s, first).name == "given_k@400 K");
  CHECK(shape_material(s, 6) == first);
  CHECK(material_of(s, shape_material(s, 5)).name == "given_c@400 K");
  CHECK(shape_material(s, 7) == 2);  // its own source: no variant
  CHECK(shape_material(s, 3) == 5);
  const auto& forest = std::get<InstancesInput>(s.geometry.at(8));
  const MaterialInput& trunk =
      material_of(s, std::get<ShapeInput>(forest.objects.at(0).form).material);
  CHECK(trunk.name == "leaves@roof");
  CHECK(std::get<HeatBalanceInput>(trunk.temperature).layers.size() == 2);
  // 10 materials of the file, 6 variants; the map comes after all of them.
  CHECK(s.materials.size() == 16);
  CHECK(shape_material(s, 0) == 16);
  for (std::size_t i = 0; i < 10; ++i) CHECK_FALSE(s.materials[i].variant_of);
  for (std::size_t i = 10; i < 16; ++i) CHECK(s.materials[i].variant_of);
}

TEST_CASE("variants come after the materials of contrast maps", "[scenario][temperature]") {
  const std::string map =
      "<contrast_map name=\"field\" raster=\"ground.asc\" material=\"grey\" band_low_um=\"0.5\" "
      "band_high_um=\"0.7\"><spectrum reflectance=\"0.1\"/><spectrum reflectance=\"0.2\"/>"
      "</contrast_map>";
  const std::string geometry =
      "<plane material=\"field\" size_x_m=\"9\" size_y_m=\"9\"/>"
      "<sphere radius_m=\"1\" material=\"grey\" temperature_k=\"280\"/>"
      "<sphere radius_m=\"1\" material=\"grey\"/>";
  const Scenario s = read_temperature(
      replaced(with_geometry(geometry), "<material name=\"grey\" reflectance=\"0.5\"/>",
               "<material name=\"grey\" reflectance=\"0.5\"/>" + map));
  REQUIRE(s.materials.size() == 4);
  CHECK(std::get<ContrastInput>(s.maps.at(0).rule).materials == std::vector<int>{1, 2});
  CHECK(shape_material(s, 0) == 4);
  CHECK(shape_material(s, 1) == 3);
  CHECK(s.materials[3].variant_of == 0);
  CHECK(shape_material(s, 2) == 0);
}

TEST_CASE("temperatures of objects and parts that contradict themselves are located",
          "[scenario][temperature][mistakes]") {
  const auto object = [](const std::string& attributes) {
    return mistake_lines(
        with_geometry("<sphere radius_m=\"1\" material=\"grey\" " + attributes + "/>"));
  };
  CHECK(object("temperature_k=\"300\" temperature_of=\"grey\"") ==
        "12:58: <sphere> has one temperature of its own; temperature_k gives it already\n");
  CHECK(object("temperature_c=\"30\" temperature_k=\"300\"") ==
        "12:57: <sphere> has one temperature of its own; temperature_c gives it already\n");
  CHECK(object("temperature_of=\"gray\"") ==
        "12:38: material \"gray\" is not declared in <materials> (did you mean \"grey\"?)\n");
  CHECK(object("temperature_k=\"-1\"").find("12:38: attribute \"temperature_k\" of <sphere>") == 0);
  const auto mapped = [](const std::string& geometry) {
    return mistake_lines(
        replaced(with_geometry(geometry), "<material name=\"grey\" reflectance=\"0.5\"/>",
                 "<material name=\"grey\" reflectance=\"0.5\"/><material_map name=\"field\" "
                 "raster=\"ground.asc\"><choice value=\"1\" material=\"grey\"/></material_map>"));
  };
  CHECK(mapped("<sphere radius_m=\"1\" material=\"field\" temperature_k=\"300\"/>") ==
        "12:39: \"field\" is a map, whose materials have temperatures of their own\n");
  CHECK(mapped("<terrain raster=\"ground.asc\" material=\"field\" temperature_c=\"3\"/>") ==
        "12:47: \"field\" is a map, whose materials have temperatures of their own\n");
  CHECK(mapped("<mesh file=\"hut.obj\" material=\"grey\" temperature_k=\"300\">\n"
               "<part name=\"roof\" material=\"field\"/></mesh>") ==
        "13:19: \"field\" is a map, whose materials have temperatures of their own\n");
  CHECK(mapped("<sphere radius_m=\"1\" material=\"grey\" temperature_of=\"field\"/>") ==
        "12:38: \"field\" is a map: here only a material will do\n");
}

TEST_CASE("temperatures of vertices need a mesh that may have them",
          "[scenario][temperature][mistakes]") {
  const auto said = [](const std::string& geometry) {
    return mistake_lines(replaced(
        with_geometry(geometry), "<material name=\"grey\" reflectance=\"0.5\"/>",
        "<material name=\"grey\" reflectance=\"0.5\"><vertex_temperature/></material><material_map "
        "name=\"field\" raster=\"ground.asc\"><choice value=\"1\" material=\"grey\"/>"
        "</material_map>"));
  };
  const std::string of_vertices =
      "material \"grey\" takes its temperatures from a mesh's vertices, which ";
  const std::string hint = " does not have (a <mesh> from a PLY file may have them)\n";
  CHECK(said("<mesh file=\"statue.ply\" material=\"grey\"/>").empty());
  CHECK(said("<sphere radius_m=\"1\" material=\"grey\"/>") ==
        "12:22: " + of_vertices + "<sphere>" + hint);
  CHECK(said("<sphere radius_m=\"1\" material=\"field\"/>") ==
        "12:22: " + of_vertices + "<sphere>" + hint);
  CHECK(said("<mesh file=\"hut.obj\" material=\"grey\"/>") ==
        "12:22: " + of_vertices + "<mesh>" + hint);
  CHECK(said("<mesh file=\"hut.obj\"><part name=\"roof\" material=\"grey\"/></mesh>") ==
        "12:40: " + of_vertices + "<part>" + hint);
  CHECK(said("<sphere radius_m=\"1\" material=\"grey\" temperature_k=\"300\"/>").empty());
}

TEST_CASE("objects and lists come and go at stated times", "[scenario][temperature]") {
  const Scenario s = warm();
  const auto& hut = std::get<ObjectInput>(s.geometry.at(1)).presence;
  CHECK_FALSE(hut.from);
  CHECK(hut.until->to_string() == "2026-06-21T15:30:00Z");
  const auto& statue = std::get<ObjectInput>(s.geometry.at(2)).presence;
  CHECK(statue.from->to_string() == "2026-06-21T10:00:00Z");
  CHECK(std::get<InstancesInput>(s.geometry.at(8)).presence.from->to_string() ==
        "2026-06-20T00:00:00Z");
  CHECK_FALSE(std::get<ObjectInput>(s.geometry.at(0)).presence.until);
}

TEST_CASE("presence that cannot be is located", "[scenario][temperature][mistakes]") {
  const auto sphere = [](const std::string& attributes) {
    return with_geometry("<sphere radius_m=\"1\" material=\"grey\" " + attributes + "/>");
  };
  CHECK(mistake_lines(sphere("present_from=\"2026-06-21T10:00:00Z\" "
                             "present_until=\"2026-06-21T10:00:00Z\"")) ==
        "12:74: present_until of <sphere> must be later than present_from\n");
  CHECK(mistake_lines(sphere("present_from=\"2026-06-21\"")) ==
        "12:38: attribute \"present_from\" of <sphere>: time \"2026-06-21\": expected ISO 8601 in "
        "UTC, such as 2026-06-21T16:00:00Z\n");
  CHECK(warnings_of(sphere("present_from=\"2026-06-21T16:00:01Z\"")) ==
        ":12:38: <sphere> comes after the moment of the image: it is never there\n");
  CHECK(warnings_of(sphere("present_from=\"2026-06-21T16:00:00Z\"")).empty());
  CHECK(mistake_lines(with_geometry("<terrain raster=\"ground.asc\" material=\"grey\" "
                                    "present_until=\"2026-06-21T10:00:00Z\"/>"))
            .find("12:46: <terrain> has no attribute \"present_until\"") == 0);
  CHECK(mistake_lines(with_geometry("<instances list=\"trees.csv\"><sphere radius_m=\"1\" "
                                    "material=\"grey\" present_until=\"2026-06-21T10:00:00Z\"/>"
                                    "</instances>"))
            .find("12:66: <sphere> has no attribute \"present_until\"") == 0);
}

TEST_CASE("rays tell 32 spans of time apart and no more", "[scenario][temperature][mistakes]") {
  const auto leaving = [](int count) {
    std::string all;
    for (int i = 0; i < count; ++i) {
      const std::string minute = (i < 10 ? "0" : "") + std::to_string(i);
      all += "<sphere radius_m=\"1\" material=\"grey\" present_until=\"2026-06-21T15:" + minute +
             ":00Z\"/>\n";
    }
    // The same time again, and one after the image, count for nothing.
    return with_geometry(all +
                         "<sphere radius_m=\"1\" material=\"grey\" present_from="
                         "\"2026-06-21T15:00:00Z\" present_until=\"2026-06-21T16:00:01Z\"/>");
  };
  CHECK(mistake_lines(leaving(31)).empty());
  CHECK(mistake_lines(leaving(33)) ==
        "43:38: objects come and go at more than 31 different times up to the image\n");
}
