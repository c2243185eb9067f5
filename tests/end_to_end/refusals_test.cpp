#include <string>

#include "end_to_end/tiny_scenario.hpp"
#include "support/catch.hpp"

// Input that cannot be right is refused by the whole command: exit code 2, one error with its
// place, and no file written. (Materials begin in line 7 of a tiny scenario, what follows
// <geometry> in 10.)

namespace nadir::end_to_end {
namespace {

TEST_CASE("a mixture that gains energy is refused", "[end_to_end]") {
  const sim::support::ScratchFolder folder;
  TinyScenario scenario;
  scenario.materials = R"(<material name="white" reflectance="0.9"/>
<material name="grey"><mixture><part material="white" weight="0.9"/>)"
                       R"(<part material="white" weight="0.4"/></mixture></material>)";
  const std::string said = refusal(folder, scenario);
  CAPTURE(said);
  // 0.9 x (0.9 + 0.4), in the float of the spectra
  CHECK(said.find(
            "tiny.xml:8:1: error: material \"grey\": mixture: its parts together scatter 1.1") ==
        0);
  CHECK(said.find(" of the light at 0.55 um; more than 1 creates energy") != std::string::npos);
}

TEST_CASE("a measured table with a hole is refused", "[end_to_end]") {
  const sim::support::ScratchFolder folder;
  write_file(folder / "sand.csv",
             "# nadir-brdf: 1\n# title: test\n# quantity: brdf\n# zero-azimuth: backward\n"
             "# wavelength: um, vacuum\n# source: made up\n# licence: CC0-1.0\n"
             "incidence_deg,view_deg,relative_azimuth_deg,0.5,0.6\n"
             "0,0,0,0.1,0.2\n0,60,0,0.06,0.12\n60,0,0,0.06,0.12\n60,60,180,0.07,0.14\n");
  TinyScenario scenario;
  scenario.materials = R"(<material name="grey"><measured file="sand.csv"/></material>)";
  CHECK(refusal(folder, scenario) ==
        "sand.csv:12:1: error: before here a row is missing: incidence 60, view 60, relative "
        "azimuth 0");
}

TEST_CASE("a negative spectrum is refused", "[end_to_end]") {
  const sim::support::ScratchFolder folder;
  write_file(folder / "bad.csv", "wavelength_um,r\n0.4,0.1\n0.5,-0.1\n0.7,0.2\n");
  TinyScenario scenario;
  SECTION("as a reflectance") {
    scenario.materials = R"(<material name="grey" reflectance="bad.csv"/>)";
    CHECK(refusal(folder, scenario) == "bad.csv:3:5: error: r is -0.1; reflectance is from 0 to 1");
  }
  SECTION("as a volume's absorption") {
    scenario.extra =
        R"(<volumes><volume name="v" absorption_per_m="bad.csv"><sphere radius_m="2"/>)"
        R"(</volume></volumes>)";
    CHECK(refusal(folder, scenario) ==
          "bad.csv:3:5: error: r is -0.1; attenuation is never negative");
  }
  SECTION("as a lamp's flux") {
    scenario.extra = R"(<lamps><point_lamp up_m="4" flux_w_per_um="bad.csv"/></lamps>)";
    CHECK(refusal(folder, scenario) == "bad.csv:3:5: error: r is -0.1; flux is never negative");
  }
}

TEST_CASE("a volume's grid that is not as long as its header says is refused", "[end_to_end]") {
  const sim::support::ScratchFolder folder;
  write_file(folder / "plume.nrrd",
             "NRRD0004\ntype: uint8\ndimension: 3\nsizes: 2 2 2\nencoding: raw\n\n1234567");
  TinyScenario scenario;
  scenario.extra = R"(<volumes><volume name="v" absorption_per_m="1" density_grid="plume.nrrd">)"
                   R"(<box lo_m="0 0 0" hi_m="1 1 1"/></volume></volumes>)";
  CHECK(refusal(folder, scenario) ==
        "plume.nrrd: error: the header promises 2 x 2 x 2 = 8 values of 1 bytes, 8 in all; 7 bytes "
        "follow it");
}

TEST_CASE("a volume's grid in another shape than a box is refused", "[end_to_end]") {
  const sim::support::ScratchFolder folder;
  write_file(folder / "plume.nrrd",
             "NRRD0004\ntype: uint8\ndimension: 3\nsizes: 2 2 2\nencoding: raw\n\n12345678");
  TinyScenario scenario;
  scenario.extra = R"(<volumes><volume name="v" absorption_per_m="1" density_grid="plume.nrrd">)"
                   R"(<sphere radius_m="3"/></volume></volumes>)";
  CHECK(refusal(folder, scenario) ==
        "tiny.xml:10:48: error: density_grid needs a volume whose shape is a <box>");
}

TEST_CASE("a lamp inside a solid is refused", "[end_to_end]") {
  const sim::support::ScratchFolder folder;
  TinyScenario scenario;
  scenario.geometry += R"(<box material="grey" lo_m="-1 -1 3" hi_m="1 1 5"/>)";
  scenario.extra = R"(<lamps><point_lamp up_m="4" flux_w_per_um="1"/></lamps>)";
  CHECK(refusal(folder, scenario) ==
        "tiny.xml:10:8: error: lamp point_lamp is inside object \"box\", an opaque solid that "
        "shuts its light in");
}

TEST_CASE("a photometric file that is not there or not understood is refused", "[end_to_end]") {
  const sim::support::ScratchFolder folder;
  TinyScenario scenario;
  scenario.extra = R"(<lamps><point_lamp up_m="4" flux_w_per_um="1" ies="lamp.ies"/></lamps>)";
  SECTION("missing") {
    CHECK(refusal(folder, scenario) ==
          "tiny.xml:10:47: error: file \"lamp.ies\" does not exist (looked at " +
              (folder / "lamp.ies").string() + ")");
  }
  SECTION("photometric type B") {
    write_file(folder / "lamp.ies",
               "IESNA:LM-63-2002\nTILT=NONE\n1 -1 1 2 1 2 2 0 0 0\n1 1 100\n0 90\n0\n100 100\n");
    CHECK(refusal(folder, scenario) ==
          "lamp.ies:3:12: error: expected photometric type 1 (C), found 2");
  }
  SECTION("no photometric file at all") {
    write_file(folder / "lamp.ies", "wavelength_um,r\n0.4,0.1\n");
    CHECK(refusal(folder, scenario) ==
          "lamp.ies: error: no line begins with TILT=: not a photometric file of IES LM-63");
  }
}

TEST_CASE("a map whose raster holds a value without a choice is refused", "[end_to_end]") {
  const sim::support::ScratchFolder folder;
  write_file(folder / "map.asc", "ncols 2\nnrows 1\nxllcorner 0\nyllcorner 0\ncellsize 1\n1 7\n");
  TinyScenario scenario;
  scenario.materials = R"(<material name="dark" reflectance="0.1"/>
<material_map name="grey" raster="map.asc" west_m="-1" south_m="-1" east_m="1" north_m="1">
<choice value="1" material="dark"/></material_map>)";
  CHECK(refusal(folder, scenario) ==
        "map.asc: error: the pixel in column 2, row 1 (the first is 1, 1) holds 7, for which map "
        "grey has no <choice>");
}

}  // namespace
}  // namespace nadir::end_to_end
