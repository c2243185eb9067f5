#include <cmath>

#include "geometry/scene_builder.hpp"
#include "scenario_support.hpp"
#include "sim/message_of.hpp"
#include "sim/run/load_maps.hpp"
#include "sim/run/load_materials.hpp"
#include "support/catch.hpp"

// Maps of materials and reliefs: from the scenario to what rays look up.

using namespace nadir;
using namespace nadir::sim;
using sim::support::message_of;
using test::minimal_text;
using test::mistake_lines;
using test::replaced;

namespace {

const std::string three =
    "<material name=\"a\" reflectance=\"0.1\"/>"
    "<material name=\"b\" reflectance=\"0.2\"/>"
    "<material name=\"c\" reflectance=\"0.3\"/>\n";
const std::string area = " west_m=\"0\" south_m=\"0\" east_m=\"30\" north_m=\"20\"";

/// The minimal scenario whose plane is made of the map "grey"; materials a, b, c in line 9.
std::string with_map(const std::string& map) {
  return replaced(minimal_text(), "    <material name=\"grey\" reflectance=\"0.5\"/>\n",
                  three + map + "\n");
}

std::string choices(const std::string& raster, const std::string& place) {
  return "<material_map name=\"grey\" raster=\"" + raster + "\"" + place +
         "><choice value=\"1\" material=\"a\"/><choice value=\"2\" material=\"b\"/>"
         "<choice value=\"7\" material=\"c\"/></material_map>";
}

const std::string grid_head =
    "ncols 3\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 10\n"
    "NODATA_value -9999\n";

/// A folder with a scenario that names rasters in it.
struct Work {
  test::TemporaryFolder folder;
  Diagnostics diagnostics;
  Scenario scenario;
  std::vector<materials::Material> materials;

  void write(const std::string& name, const std::string& text) const {
    std::ofstream{folder / name, std::ios::binary} << text;
  }
  std::vector<materials::MaterialMap> load(const std::string& text) {
    scenario = parse_scenario(text, folder / "test.xml", diagnostics);
    const geometry::LocalFrame frame{scenario.origin};
    InputFiles files;
    materials = load_materials(scenario, frame, files, diagnostics);
    return load_maps(scenario, materials, frame, files, diagnostics);
  }
};

}  // namespace

TEST_CASE("geometry may name a map, numbered after all materials", "[scenario][maps]") {
  Work work;
  work.write("classes.asc", grid_head + "1 2 7\n2 2 1\n");
  const auto maps = work.load(with_map(choices("classes.asc", area)));
  REQUIRE(maps.size() == 1);
  CHECK(std::get<ShapeInput>(std::get<ObjectInput>(work.scenario.geometry.at(0)).form).material ==
        3);
  CHECK(work.diagnostics.messages().empty());
  CHECK(maps[0].at({5.0, 15.0}, 0.0) == 0);
  CHECK(maps[0].at({15.0, 15.0}, 0.0) == 1);
  CHECK(maps[0].at({25.0, 15.0}, 0.0) == 2);
  CHECK(maps[0].at({25.0, 5.0}, 0.0) == 0);
  CHECK(maps[0].at({900.0, -5.0}, 0.0) == 0);
}

TEST_CASE("a raster value without a choice is an error at its pixel",
          "[scenario][maps][mistakes]") {
  Work work;
  work.write("classes.asc", grid_head + "1 2 7\n2 3 1\n");
  const auto file = (work.folder / "classes.asc").string();
  CHECK(message_of([&] { (void)work.load(with_map(choices("classes.asc", area))); }) ==
        file +
            ": error: the pixel in column 2, row 2 (the first is 1, 1) holds 3, for which map "
            "grey has no <choice>\n    hint: choices are: 1, 2, 7\n");
  work.write("classes.asc", grid_head + "1 2 -9999\n2 2 1\n");
  CHECK(message_of([&] {
          (void)work.load(with_map(choices("classes.asc", area)));
        }).find("column 3, row 1 (the first is 1, 1) has no value") != std::string::npos);
}

TEST_CASE("a band that the raster does not have is an error of the raster",
          "[scenario][maps][mistakes]") {
  Work work;
  work.write("classes.asc", grid_head + "1 2 7\n2 2 1\n");
  const auto message =
      message_of([&] { (void)work.load(with_map(choices("classes.asc", area + " band=\"2\""))); });
  CHECK(message.find("classes.asc: error: the raster has 1 bands, so there is no band 2") !=
        std::string::npos);
}

TEST_CASE("a raster without coordinate system needs edges", "[scenario][maps][mistakes]") {
  Work work;
  work.write("classes.asc", grid_head + "1 2 7\n2 2 1\n");
  const auto message = message_of([&] { (void)work.load(with_map(choices("classes.asc", ""))); });
  CHECK(message.find("the raster has no coordinate system") != std::string::npos);
}

TEST_CASE("a georeferenced raster lies where the earth has it", "[scenario][maps]") {
  Work work;
  // The minimal scenario's site is 36 N, 84 W: pixels of a thousandth of a degree about it.
  work.write("classes.asc",
             "ncols 4\nnrows 4\nxllcorner -84.002\nyllcorner 35.998\n"
             "cellsize 0.001\n1 1 1 1\n1 1 2 1\n1 7 1 1\n1 1 1 1\n");
  work.write("classes.prj",
             "GEOGCS[\"WGS 84\",DATUM[\"WGS_1984\",SPHEROID[\"WGS 84\",6378137,"
             "298.257223563]],PRIMEM[\"Greenwich\",0],UNIT[\"degree\","
             "0.0174532925199433]]");
  std::string text = with_map(choices("classes.asc", ""));
  const auto from = text.find("<site "), to = text.find("/>", from);
  text.replace(from, to - from, "<site latitude_deg=\"36\" longitude_deg=\"-84\" height_m=\"300\"");
  const auto maps = work.load(text);
  CHECK(work.diagnostics.messages().empty());
  const geometry::LocalFrame frame{work.scenario.origin};
  const auto at = [&](double latitude_deg, double longitude_deg) {
    const Vec3 place = frame.enu({latitude_deg, longitude_deg, 300.0});
    return maps.at(0).at({place.x, place.y}, 0.0);
  };
  CHECK(at(36.0005, -83.9995) == 1);
  CHECK(at(35.9995, -84.0005) == 2);
  CHECK(at(36.0005, -84.0005) == 0);
  // Pixel edges are found to a few thousandths of their width of 90 m.
  CHECK(at(36.000005, -83.999995) == 1);
  CHECK(at(35.999995, -84.000005) == 2);
  CHECK(at(36.000995, -83.999005) == 1);
}

TEST_CASE("fractions become chances, and must be shares of 1", "[scenario][maps]") {
  Work work;
  work.write("a.asc", grid_head + "0.25 1 0\n0 0.5 0.3334\n");
  work.write("b.asc", grid_head + "0.75 0 1\n0 0.5 0.6666\n");
  work.write("both.vrt", R"(<VRTDataset rasterXSize="3" rasterYSize="2">
<VRTRasterBand dataType="Float32" band="1"><SimpleSource><SourceFilename relativeToVRT="1">a.asc</SourceFilename></SimpleSource></VRTRasterBand>
<VRTRasterBand dataType="Float32" band="2"><SimpleSource><SourceFilename relativeToVRT="1">b.asc</SourceFilename></SimpleSource></VRTRasterBand>
</VRTDataset>)");
  const std::string map = "<material_map name=\"grey\" raster=\"both.vrt\"" + area +
                          "><fraction band=\"2\" material=\"b\"/>"
                          "<fraction band=\"1\" material=\"a\"/></material_map>";
  // The pixel below left has no material at all.
  const auto message = message_of([&] { (void)work.load(with_map(map)); });
  CHECK(message.find("both.vrt: error: the pixel in column 1, row 2 (the first is 1, 1) has "
                     "fractions that sum to 0, not to 1, in map grey") != std::string::npos);
  work.write("a.asc", grid_head + "0.25 1 0\n1 0.5 0.3334\n");
  const auto maps = work.load(with_map(map));
  CHECK(maps.at(0).at({5.0, 15.0}, 0.74) == 1);
  CHECK(maps[0].at({5.0, 15.0}, 0.76) == 0);
  CHECK(maps[0].at({15.0, 15.0}, 0.0) == 0);
  CHECK(maps[0].at({25.0, 15.0}, 0.9999999999) == 1);
  CHECK(maps[0].at({25.0, 5.0}, 0.6665) == 1);
  work.write("a.asc", grid_head + "0.25 1 0\n1 1.5 0.3334\n");
  CHECK(message_of([&] {
          (void)work.load(with_map(map));
        }).find("column 2, row 2 (the first is 1, 1) holds the fraction 1.5") != std::string::npos);
}

TEST_CASE("a contrast map makes a material of each spectrum and lays them out by contrast",
          "[scenario][maps]") {
  Work work;
  work.write("photo.asc", grid_head + "10 20 30\n30 20 10\n");
  work.write("two.csv", "wavelength_um,dark,bright\n0.4,0.05,0.15\n0.8,0.15,0.25\n");
  const auto maps = work.load(with_map(
      "<contrast_map name=\"grey\" raster=\"photo.asc\" material=\"c\" band_low_um=\"0.5\" "
      "band_high_um=\"0.7\"" +
      area +
      "><spectrum reflectance=\"two.csv#bright\"/><spectrum reflectance=\"two.csv#dark\"/>"
      "<spectrum reflectance=\"0.15\"/></contrast_map>"));
  REQUIRE(work.materials.size() == 6);
  CHECK(work.materials[3].name == "grey#1");
  CHECK(work.materials[4].reflectance->at(0.6_um) == Approx(0.1).epsilon(1e-12));
  CHECK(test::kelvin_of(work.scenario.materials[4]) == 300.0);
  CHECK(std::get<ShapeInput>(std::get<ObjectInput>(work.scenario.geometry.at(0)).form).material ==
        6);
  CHECK(maps.at(0).at({5.0, 15.0}, 0.0) == 4);
  CHECK(maps[0].at({15.0, 15.0}, 0.0) == 5);
  CHECK(maps[0].at({25.0, 15.0}, 0.0) == 3);
}

TEST_CASE("maps that contradict themselves are located", "[scenario][maps][mistakes]") {
  const auto told = [](const std::string& attributes, const std::string& children) {
    return mistake_lines(with_map("<material_map name=\"grey\" raster=\"ground.asc\" " +
                                  attributes + ">\n" + children + "</material_map>"));
  };
  const std::string one = "<choice value=\"1\" material=\"a\"/>";
  CHECK(told("", one + one) == "11:41: the value 1 has a choice already\n");
  CHECK(told("", one + "<fraction band=\"1\" material=\"b\"/>") ==
        "11:33: a map holds either choices or fractions, not both\n");
  CHECK(told("", "<choice value=\"1\" material=\"grey\"/>") ==
        "11:19: \"grey\" is a map: here only a material will do\n");
  CHECK(told("", "<choice value=\"1\" material=\"d\"/>")
            .find("11:19: material \"d\" is not declared in <materials>") == 0);
  CHECK(told("", "<fraction band=\"1\" material=\"a\"/><fraction band=\"1\" material=\"b\"/>") ==
        "11:44: band 1 has a material already\n");
  CHECK(told("band=\"1\"", "<fraction band=\"1\" material=\"a\"/>") ==
        "10:47: band is for choices; each fraction names its own\n");
  CHECK(told("west_m=\"0\"", one) ==
        "10:1: <material_map> lacks south_m: give all four edges or none\n");
  CHECK(told("west_m=\"0\" east_m=\"0\" south_m=\"0\" north_m=\"1\"", one) ==
        "10:58: east_m must be greater than west_m\n");
  CHECK(told("size_u=\"2\"", one) == "10:47: size_u is for maps with drape=\"texture\"\n");
  CHECK(told("drape=\"texture\" west_m=\"1\"", one) ==
        "10:63: west_m is for maps with drape=\"ground\"\n");
  CHECK(mistake_lines(with_map("<material_map name=\"grey\" raster=\"ground.asc\">" + one +
                               "</material_map>\n<material name=\"grey\" reflectance=\"1\"/>"))
            .find("11:11: material \"grey\" is there already, in line 10") != std::string::npos);
  CHECK(mistake_lines(
            with_map("<material name=\"glass\"><clear_sheet n=\"1.5\"/></material>\n"
                     "<contrast_map name=\"grey\" raster=\"ground.asc\" material=\"glass\" "
                     "band_low_um=\"0.7\" band_high_um=\"0.6\"><spectrum reflectance=\"0.1\"/>"
                     "<spectrum reflectance=\"0.2\"/></contrast_map>")) ==
        "11:47: the scattering model of this material brings its own spectra, so that there is "
        "none to choose\n11:82: band_high_um must be greater than band_low_um\n");
}

TEST_CASE("a height raster becomes slopes in the scene's axes", "[scenario][maps]") {
  Work work;
  work.write("bumps.asc", grid_head + "0 1 2\n0 1 2\n");
  const auto text = [&](const std::string& relief) {
    return replaced(minimal_text(), "<material name=\"grey\" reflectance=\"0.5\"/>",
                    "<material name=\"grey\" reflectance=\"0.5\">" + relief + "</material>");
  };
  CHECK(work.load(text("<relief file=\"bumps.asc\" kind=\"heights\" strength=\"2\"" + area + "/>"))
            .empty());
  const auto& relief = work.materials.at(0).relief;
  REQUIRE(relief != nullptr);
  CHECK(relief->slope.at(4).x == Approx(0.2).epsilon(1e-12));
  CHECK(relief->slope.at(4).y == Approx(0.0).margin(1e-12));
  work.write("bumps.asc", grid_head + "0 1 2\n0 -9999 2\n");
  CHECK(
      message_of([&] {
        (void)work.load(text("<relief file=\"bumps.asc\" kind=\"heights\"" + area + "/>"));
      }).find("bumps.asc: error: the pixel in column 2, row 2 (the first is 1, 1) has no value") !=
      std::string::npos);
  CHECK(message_of([&] {
          (void)work.load(text("<relief file=\"bumps.asc\" kind=\"normals\"" + area + "/>"));
        }).find("a normal map has three bands; this raster has 1") != std::string::npos);
}

TEST_CASE("a normal map of bytes gives the slopes that it was made from", "[scenario][maps]") {
  Work work;
  // One row of two pixels; plain PPM: (0.6, 0, 0.8) and (0, 0.6, 0.8) as 255 (n + 1) / 2.
  work.write("normals.ppm", "P6\n2 1\n255\n" + std::string{"\xCC\x80\xE6\x80\xCC\xE6", 6});
  (void)work.load(replaced(minimal_text(), "<material name=\"grey\" reflectance=\"0.5\"/>",
                           "<material name=\"grey\" reflectance=\"0.5\"><relief "
                           "file=\"normals.ppm\" kind=\"normals\" drape=\"texture\" size_u=\"2\"/>"
                           "</material>"));
  const auto& relief = work.materials.at(0).relief;
  REQUIRE(relief != nullptr);
  // 0.01: half a step of a byte, 0.004, on either number of the quotient
  const Vec3 first = relief->normal_at({0.5, 0.5}), second = relief->normal_at({1.5, 0.5});
  CHECK(length(first - Vec3{0.6, 0.0, 0.8}) < 0.01);
  CHECK(length(second - Vec3{0.0, 0.6, 0.8}) < 0.01);
}

TEST_CASE("a map that does not reach as far as its surface is told", "[scenario][maps]") {
  Work work;
  work.write("classes.asc", grid_head + "1 2 7\n2 2 1\n");
  const auto warnings_over = [&](const std::string& place, double size) {
    Work fresh;
    fresh.write("classes.asc", grid_head + "1 2 7\n2 2 1\n");
    auto maps = fresh.load(with_map(choices("classes.asc", place)));
    geometry::SceneBuilder builder;
    builder.add({geometry::Plane{{15.0, 10.0, 0.0}, size, size}, {3}}, {}, 0);
    const radiometry::SceneDescription described{
        builder.build(), fresh.materials, thermal::TemperatureField{{}}, {}, {}, {},
        std::move(maps)};
    check_cover(fresh.scenario, described, fresh.diagnostics);
    return fresh.diagnostics.messages();
  };
  CHECK(warnings_over(area, 20.0).empty());
  CHECK(warnings_over(area + " repeats=\"true\"", 60.0).empty());
  const auto beyond = warnings_over(area, 60.0);
  REQUIRE(beyond.size() == 1);
  CHECK(beyond[0].find("map grey does not reach as far as the surfaces that it lies on (8") == 0);
  const auto bare = warnings_over(" drape=\"texture\"", 20.0);
  REQUIRE(bare.size() == 1);
  CHECK(bare[0].find("map grey follows texture coordinates, but lies on a surface that has none") ==
        0);
}
