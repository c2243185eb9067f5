#include <cstring>
#include <fstream>
#include <string>
#include <variant>

#include "scenario_support.hpp"
#include "sim/run/load_volumes.hpp"
#include "support/catch.hpp"

namespace nadir::test {
namespace {

namespace fs = std::filesystem;

/// The minimal scenario with these volumes in it.
std::string with_volumes(const std::string& volumes) {
  return replaced(minimal_text(), "<platform>", "<volumes>" + volumes + "</volumes>\n  <platform>");
}
/// What is said of these volumes, without its place.
std::string said_volumes(const std::string& volumes) {
  std::string all = mistake_lines(with_volumes(volumes));
  std::string text;
  while (!all.empty()) {
    const std::string line = all.substr(0, all.find('\n') + 1);
    all.erase(0, line.size());
    text += line.substr(line.find(": ") + 2);
  }
  return text;
}

sim::Scenario parsed_volumes(const std::string& volumes, const fs::path& file) {
  Diagnostics diagnostics;
  return sim::parse_scenario(with_volumes(volumes), file, diagnostics);
}

void write_volumes(const fs::path& file, const std::string& text) {
  std::ofstream{file, std::ios::binary} << text;
}

TEST_CASE("volumes are read with shape, medium, phase and place", "[sim][volumes]") {
  const auto scenario = parsed_volumes(
      "<volume name=\"fog\" scattering_per_m=\"0.01\" east_m=\"5\" yaw_deg=\"90\">"
      "<box lo_m=\"-1 -2 0\" hi_m=\"1 2 3\"/><henyey_greenstein g=\"0.85\"/></volume>"
      "<volume name=\"plume\" absorption_per_m=\"2\" temperature_k=\"500\">"
      "<cylinder radius_m=\"2\" top_m=\"0 0 40\"/></volume>"
      "<volume name=\"haze\" scattering_per_m=\"1e-5\"><sphere "
      "radius_m=\"9\"/><rayleigh/></volume>",
      data_folder() / "test.xml");
  REQUIRE(scenario.volumes.size() == 3);
  sim::InputFiles files;
  const auto volumes = sim::load_volumes(scenario, sim::TerrainProbe{}, files);
  REQUIRE(volumes.size() == 3);
  CHECK(volumes[0].name == "fog");
  // Turned clockwise by 90 degrees, then 5 m to the east: y becomes x.
  CHECK(volumes[0].region.contains({6.9, 0.9, 1.0}));
  CHECK_FALSE(volumes[0].region.contains({5.0, 1.1, 1.0}));
  const auto& hg = std::get<materials::HenyeyGreenstein>(volumes[0].medium.phase);
  CHECK(hg.g.at(Micrometres{1.0}) == 0.85);
  CHECK(volumes[0].medium.scattering.at(Micrometres{1.0}) == 0.01);
  CHECK(std::get<Kelvin>(volumes[1].temperature) == Kelvin{500.0});
  CHECK(volumes[1].region.contains({0.0, 0.0, 39.0}));  // closed
  CHECK(std::holds_alternative<materials::RayleighPhase>(volumes[2].medium.phase));
  CHECK(volumes[2].where.line > 1);
}

TEST_CASE("a volume's grids, spectra and tables are read from their files", "[sim][volumes]") {
  const TemporaryFolder folder;
  const float values[] = {1.0F, 2.0F};
  std::string grid =
      "NRRD0004\ntype: float\ndimension: 3\nsizes: 1 1 2\nendian: little\n"
      "encoding: raw\n\n";
  grid.append(reinterpret_cast<const char*>(values), sizeof values);
  write_volumes(folder / "plume.nrrd", grid);
  write_volumes(folder / "haze.csv", "angle_deg,0.55\n0,3\n180,1\n");
  write_volumes(folder / "soot.csv", "wavelength_um,soot\n1,0.5\n20,0.1\n");
  const auto scenario = parsed_volumes(
      "<volume name=\"plume\" absorption_per_m=\"soot.csv\" density_grid=\"plume.nrrd\" "
      "temperature_grid=\"plume.nrrd\"><box lo_m=\"0 0 0\" hi_m=\"1 1 1\"/>"
      "<phase_table file=\"haze.csv\"/></volume>",
      folder / "scene.xml");
  sim::InputFiles files;
  const auto volumes = sim::load_volumes(scenario, sim::TerrainProbe{}, files);
  REQUIRE(volumes.size() == 1);
  CHECK(volumes[0].density->value == std::vector<float>{1.0F, 2.0F});
  CHECK(std::get<1>(volumes[0].temperature) == volumes[0].density);  // read once
  CHECK(volumes[0].medium.absorption.at(Micrometres{1.0}) == 0.5);
  CHECK(std::get<materials::TabulatedPhase>(volumes[0].medium.phase).value.size() == 2);
  CHECK(files.all().size() == 3);
}

TEST_CASE("mistakes of volumes are told where they stand", "[sim][volumes]") {
  const std::string box = "<box lo_m=\"0 0 0\" hi_m=\"1 1 1\"/>";
  const std::string fog = "<volume name=\"fog\" scattering_per_m=\"1\">";
  CHECK(said_volumes(fog + box + "</volume>").empty());
  CHECK(said_volumes(fog + "</volume>") ==
        "<volume> has no shape (write <box lo_m=\"...\" hi_m=\"...\"/>, <sphere> or <cylinder> in "
        "it)\n");
  CHECK(said_volumes(fog + box + "<sphere radius_m=\"1\"/></volume>") ==
        "<volume> has two shapes: <box> and <sphere>\n");
  CHECK(said_volumes(fog + box + "<rayleigh/><henyey_greenstein g=\"0\"/></volume>") ==
        "<volume> has two phase functions: <rayleigh> and <henyey_greenstein>\n");
  CHECK(said_volumes(fog + box + "<henyey_greenstein g=\"1\"/></volume>").find("g") !=
        std::string::npos);
  CHECK(said_volumes("<volume name=\"fog\">" + box + "</volume>") ==
        "<volume> neither absorbs nor scatters: give absorption_per_m or scattering_per_m\n");
  CHECK(said_volumes(fog + box + "</volume>" + fog + box + "</volume>")
            .find("volume \"fog\" is there already") != std::string::npos);
  CHECK(said_volumes("<volume name=\"fog\" scattering_per_m=\"1\" on_terrain=\"true\">" + box +
                     "</volume>") ==
        "<volume> stands on the terrain, but <geometry> has no <terrain>\n");
  const TemporaryFolder folder;
  write_volumes(folder / "a.nrrd", "");
  const std::string grid = (folder / "a.nrrd").string();
  CHECK(said_volumes("<volume name=\"fog\" scattering_per_m=\"1\" density_grid=\"" + grid +
                     "\"><sphere radius_m=\"1\"/></volume>") ==
        "density_grid needs a volume whose shape is a <box>\n");
  CHECK(said_volumes(
            "<volume name=\"fog\" scattering_per_m=\"1\" temperature_k=\"3\" temperature_grid=\"" +
            grid + "\">" + box + "</volume>") ==
        "give either temperature_k or temperature_grid, not both\n");
}

}  // namespace
}  // namespace nadir::test
