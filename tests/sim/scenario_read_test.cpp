#include <cmath>

#include "scenario_support.hpp"
#include "sim/scenario/material_library.hpp"
#include "support/catch.hpp"

using namespace nadir;
using namespace nadir::sim;
using nadir::test::data_folder;

namespace {

Scenario read_scenario_text(const char* name, Diagnostics& diagnostics) {
  return read_scenario(data_folder() / name, diagnostics);
}
Scenario read_scenario_text(const char* name) {
  Diagnostics diagnostics;
  return read_scenario_text(name, diagnostics);
}

std::string path_of(const SpectralInput& input) {
  return std::get<std::filesystem::path>(input.source).string();
}

}  // namespace

TEST_CASE("a minimal scenario gives its values and the defaults", "[scenario]") {
  Diagnostics diagnostics;
  const Scenario s = read_scenario_text("minimal.xml", diagnostics);
  CHECK(diagnostics.messages().empty());
  CHECK(s.file == data_folder() / "minimal.xml");
  CHECK(s.name == "minimal");
  CHECK(s.title.empty());
  CHECK(s.time.to_string() == "2026-06-21T16:00:00Z");
  CHECK(s.origin.latitude_deg == 36.0);
  CHECK(s.origin.longitude_deg == -84.0);
  CHECK(s.origin.height_m == 300.0);
  CHECK(std::get<FixedSky>(s.illumination).bodies.empty());
  CHECK(std::holds_alternative<NoAir>(s.air));
  CHECK(s.solver == materials::SolverSettings{});
  REQUIRE(s.materials.size() == 1);
  CHECK(s.materials[0].name == "grey");
  CHECK(std::get<double>(s.materials[0].reflectance->source) == 0.5);
  CHECK_FALSE(s.materials[0].emissivity);
  CHECK(test::kelvin_of(s.materials[0]) == 300.0);
  CHECK_FALSE(s.materials[0].solver);
  REQUIRE(s.geometry.size() == 1);
  const auto& object = std::get<ObjectInput>(s.geometry[0]);
  CHECK(object.name == "plane");
  CHECK(std::get<geometry::Plane>(std::get<ShapeInput>(object.form).shape).size_x == 100.0);
  CHECK(object.placement.scale == Vec3{1.0, 1.0, 1.0});
  CHECK_FALSE(object.placement.on_terrain);
  CHECK(std::get<Vec3>(s.platform.position) == Vec3{0.0, 0.0, 1000.0});
  CHECK(std::get<PlatformInput::Euler>(s.platform.attitude).pitch_deg == -90.0);
  CHECK(s.camera.orthographic);
  REQUIRE(s.camera.arrays.size() == 1);
  CHECK(s.camera.arrays[0].samples == 4);
  CHECK(s.camera.arrays[0].lines == 3);
  CHECK(s.camera.arrays[0].ground_pitch_m == 1.0);
  CHECK(std::get<BoxBand>(s.camera.arrays[0].bands[0].response).hi_um == 12.0);
  CHECK(s.sampling.replicates == SamplingInput{}.replicates);
  CHECK(s.products.envi);
  CHECK(s.products.quick_look_bands.empty());
}

TEST_CASE("light and air of a full scenario arrive in the plain data", "[scenario]") {
  const Scenario s = read_scenario_text("full.xml");
  CHECK(s.title == "Käse & bread");
  CHECK(s.time.to_string() == "2026-06-21T16:00:00.25Z");
  CHECK(s.time.ut1_utc().value == 0.1);
  const auto& sky = std::get<ComputedSky>(s.illumination);
  CHECK(path_of(*sky.solar_irradiance) == (data_folder() / "solar.csv").string());
  CHECK(std::get<double>(sky.lunar_irradiance->source) == 0.001);
  const auto& air = std::get<UniformAir>(s.air);
  CHECK(std::get<double>(air.sky_radiance.source) == 20.0);
  CHECK(air.sky_temperature_k == 250.0);
  CHECK(std::get<double>(air.solar_transmittance.source) == 0.7);
  CHECK(air.transmittance.column == "grass");
  CHECK(std::get<double>(air.path_radiance.source) == 3.0);
  CHECK(air.air_temperature_k == 280.0);
  CHECK(s.solver == materials::SolverSettings{100, 2.0, 4, 10, 20, 2});
}

TEST_CASE("fixed bodies keep their angles and irradiance", "[scenario]") {
  Diagnostics diagnostics;
  const Scenario s = parse_scenario(
      test::replaced(test::minimal_text(), "<fixed/>",
                     "<fixed><body name=\"sun\" azimuth_deg=\"120\" elevation_deg=\"40.5\" "
                     "irradiance=\"1800\"/></fixed>"),
      data_folder() / "test.xml", diagnostics);
  const auto& bodies = std::get<FixedSky>(s.illumination).bodies;
  REQUIRE(bodies.size() == 1);
  CHECK(bodies[0].name == "sun");
  CHECK(bodies[0].azimuth_deg == 120.0);
  CHECK(bodies[0].elevation_deg == 40.5);
  CHECK(bodies[0].angular_radius_deg == FixedBody{}.angular_radius_deg);
  CHECK(std::get<double>(bodies[0].irradiance.source) == 1800.0);
}

TEST_CASE("materials come from the scenario or from a library", "[scenario]") {
  const Scenario s = read_scenario_text("full.xml");
  CHECK(s.libraries == std::vector<std::filesystem::path>{data_folder() / "materials.xml"});
  REQUIRE(s.materials.size() == 5);
  CHECK(s.materials[0].name == "asphalt_road");  // by its own name
  CHECK(s.materials[0].description == "Road asphalt");
  CHECK(s.materials[0].reflectance->column == "asphalt");
  CHECK(test::kelvin_of(s.materials[0]) == 301.5);
  CHECK(s.materials[1].name == "ground");  // by another name
  CHECK(s.materials[1].description == "Grass on the hill");
  CHECK(s.materials[1].reflectance->column == "grass");
  CHECK(test::kelvin_of(s.materials[1]) == 290.0);
  CHECK(std::get<double>(s.materials[2].emissivity->source) == 0.9);
  // A material's solver starts from the scenario's settings, not from the program's.
  CHECK(s.materials[2].solver == materials::SolverSettings{100, 2.0, 1, 10, 20, 2});
  CHECK_FALSE(s.materials[3].reflectance);
  CHECK(std::get<double>(s.materials[4].emissivity->source) == 0.95);
}

TEST_CASE("objects keep their form, place and materials", "[scenario]") {
  const Scenario s = read_scenario_text("full.xml");
  REQUIRE(s.geometry.size() == 8);
  const auto& terrain = std::get<TerrainInput>(s.geometry[0]);
  CHECK(terrain.raster == data_folder() / "ground.asc");
  CHECK(terrain.height_offset_m == -30.5);
  CHECK(terrain.material == 1);
  const auto& hut = std::get<ObjectInput>(s.geometry[1]);
  CHECK(hut.name == "hut");
  CHECK(hut.placement.position_m == Vec3{10.0, -20.0, 0.5});
  CHECK(hut.placement.yaw_deg == 30.0);
  CHECK(hut.placement.pitch_deg == 1.0);
  CHECK(hut.placement.roll_deg == 2.0);
  CHECK(hut.placement.scale == Vec3{1.0, 2.0, 3.0});
  CHECK(hut.placement.on_terrain);
  const auto& parts = std::get<MeshInput>(hut.form).parts;
  REQUIRE(parts.size() == 2);
  CHECK(parts[0].part == "roof");
  CHECK(parts[0].material == 2);
  CHECK(parts[1].part.empty());
  CHECK(parts[1].material == 3);
  const auto shape = [&](std::size_t i) {
    return std::get<ShapeInput>(std::get<ObjectInput>(s.geometry[i]).form);
  };
  CHECK(std::get<geometry::Sphere>(shape(2).shape).radius == 2.0);
  CHECK(std::get<ObjectInput>(s.geometry[2]).placement.scale == Vec3{2.0, 2.0, 2.0});
  const Vec3 normal = std::get<geometry::Disc>(shape(3).shape).normal;
  CHECK(normal.y == Approx(std::sqrt(0.5)).epsilon(1e-15));  // 0 1 1, made a unit vector
  CHECK(std::get<geometry::Box>(shape(4).shape).lo == Vec3{-1.0, -2.0, 0.0});
  CHECK(std::get<geometry::Box>(shape(4).shape).hi == Vec3{1.0, 2.0, 3.0});
  CHECK(std::get<geometry::Plane>(shape(5).shape).size_y == 6.0);
  CHECK(std::get<geometry::Cylinder>(shape(6).shape).top == Vec3{0.0, 0.0, 8.0});
  CHECK(std::get<geometry::Cylinder>(shape(6).shape).capped);
}

TEST_CASE("lists of instances nest", "[scenario]") {
  const Scenario s = read_scenario_text("full.xml");
  const auto& forest = std::get<InstancesInput>(s.geometry[7]);
  CHECK(forest.name == "forest");
  CHECK(forest.list == data_folder() / "trees.csv");
  CHECK(forest.on_terrain);
  REQUIRE(forest.objects.size() == 2);
  CHECK(forest.objects[1].placement.position_m.z == 6.0);
  REQUIRE(forest.nested.size() == 1);
  CHECK_FALSE(forest.nested[0].on_terrain);
  REQUIRE(forest.nested[0].objects.size() == 1);
}

TEST_CASE("platform, camera and products arrive in the plain data", "[scenario]") {
  const Scenario s = read_scenario_text("full.xml");
  CHECK(std::get<geometry::Geodetic>(s.platform.position).height_m == 5000.0);
  const auto& look_at = std::get<PlatformInput::LookAt>(s.platform.attitude);
  CHECK(std::get<Vec3>(look_at.target) == Vec3{});
  CHECK(look_at.on_terrain);
  CHECK(look_at.roll_deg == 5.0);
  CHECK_FALSE(s.camera.orthographic);
  CHECK(s.camera.lens.focal_length_mm == 50.0);
  REQUIRE(s.camera.arrays.size() == 2);
  const ArrayInput& visible = s.camera.arrays[0];
  CHECK(visible.pitch_um == 5.5);
  CHECK(visible.offset_x_um == 100.0);
  CHECK(visible.offset_y_um == 0.0);
  REQUIRE(visible.bands.size() == 3);
  const auto& red = std::get<TabulatedBand>(visible.bands[0].response);
  CHECK(red.file == data_folder() / "responses.csv");
  CHECK(red.column == "Red");
  const auto& narrow = std::get<GaussianBand>(s.camera.arrays[1].bands[1].response);
  CHECK(narrow.centre_um == 10.9);
  CHECK(narrow.fwhm_um == 0.6);
  CHECK(s.sampling.replicates == 8);
  CHECK(s.sampling.samples_per_replicate == 3);
  CHECK(s.sampling.wavelengths_per_band == 5);
  CHECK(s.products.envi);
  CHECK_FALSE(s.products.exr);
  CHECK_FALSE(s.products.truth);
  CHECK(s.products.quick_look_bands == std::vector<std::string>{"Red", "Green", "Blue"});
}

TEST_CASE("the order of a scenario's parts does not matter", "[scenario]") {
  // The camera first and the materials last: names are resolved when everything is there.
  std::string text = test::full_text();
  const std::size_t begin = text.find("  <materials "), end = text.find("  <geometry>");
  const std::string materials = text.substr(begin, end - begin);
  text.erase(begin, end - begin);
  text = test::replaced(text, "</scenario>", materials + "</scenario>");
  CHECK(test::mistakes(text).empty());
}

TEST_CASE("a byte order mark and line ends of two bytes are accepted", "[scenario]") {
  std::string text = "\xEF\xBB\xBF" + test::minimal_text();
  CHECK(test::mistakes(text).empty());
  for (std::size_t at = text.find('\n'); at != std::string::npos; at = text.find('\n', at + 2)) {
    text.insert(at, "\r");
  }
  CHECK(test::mistakes(text).empty());
  // and positions still count from 1 after the mark, without the \r
  CHECK(test::mistakes(test::replaced(text, "samples=\"4\"", "samples=\"x\"")) ==
        "test.xml:20:26: error: attribute \"samples\" of <array>: \"x\", expected a whole number "
        "from 1 to 100000\n"
        "    20 |       <array name=\"main\" samples=\"x\" lines=\"3\" ground_pitch_m=\"1\">\n"
        "       |                          ^\n");
}

TEST_CASE("library: means the shipped library", "[scenario]") {
  Diagnostics diagnostics;
  const Scenario s = parse_scenario(
      test::replaced(test::minimal_text(), "<material name=\"grey\" reflectance=\"0.5\"/>",
                     "<library file=\"library:materials.xml\"/>"
                     "<material name=\"grey\" from=\"asphalt_road\"/>"),
      data_folder() / "test.xml", diagnostics);
  const auto expected =
      std::filesystem::path{NADIR_SOURCE_DIR} / "scenes/library/spectra/asphalt_road.csv";
  CHECK(path_of(*s.materials[0].reflectance) == expected.string());
}

TEST_CASE("a material that nothing is made of is a warning with its place", "[scenario]") {
  Diagnostics diagnostics;
  static_cast<void>(parse_scenario(
      test::replaced(test::minimal_text(), "</materials>",
                     "  <material name=\"spare\" emissivity=\"1\"/>\n  </materials>"),
      "somewhere/test.xml", diagnostics));
  CHECK(
      diagnostics.messages() ==
      std::vector<std::string>{"somewhere/test.xml:10:5: no object is made of material \"spare\""});
}

TEST_CASE("a material library lists its materials", "[scenario]") {
  const auto materials = read_material_library(data_folder() / "materials.xml");
  REQUIRE(materials.size() == 3);
  CHECK(materials[1].name == "meadow");
  CHECK(materials[1].description == "Green grass");
  CHECK(path_of(*materials[1].reflectance) == (data_folder() / "curves.csv").string());
  CHECK(is_material_library(data_folder() / "materials.xml"));
  CHECK_FALSE(is_material_library(data_folder() / "minimal.xml"));
}
