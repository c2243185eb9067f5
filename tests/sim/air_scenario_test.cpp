#include <cstdlib>
#include <fstream>
#include <string>
#include <variant>
#include <vector>

#include "scenario_support.hpp"
#include "support/catch.hpp"

namespace nadir::test {
namespace {

using sim::LayeredAir;

/// The minimal scenario with this air; its line is the seventh.
std::string with_scenario_air(const std::string& air) {
  return replaced(minimal_text(), "<none/>", air);
}

sim::AirInput air_of(const std::string& air) {
  Diagnostics diagnostics;
  return sim::parse_scenario(with_scenario_air(air), data_folder() / "test.xml", diagnostics).air;
}

LayeredAir layered(const std::string& air) { return std::get<LayeredAir>(air_of(air)); }

}  // namespace

TEST_CASE("layered air without any attribute is a clear standard day", "[scenario][air]") {
  const LayeredAir air = layered("<layered/>");
  CHECK(air.profile == "us_standard_1976");
  CHECK_FALSE(air.sounding.has_value());
  CHECK(air.mode == atmosphere::AirMode::accurate);
  CHECK(air.streams == 8);
  CHECK_FALSE(air.water_vapour.amount.has_value());
  CHECK(air.water_vapour.factor == 1.0);
  CHECK(air.ozone.factor == 1.0);
  CHECK(air.co2_ppm == 420.0);
  CHECK_FALSE(air.ground.reflectance.has_value());
  CHECK_FALSE(air.ground.temperature_k.has_value());
  CHECK_FALSE(air.refraction);
  CHECK(air.night_sky);
  CHECK(air.aerosol.type == atmosphere::AerosolType::rural);
  CHECK(air.aerosol.visibility_km == 23.0);
  CHECK(air.aerosol.relative_humidity == 0.7);
  CHECK(air.clouds.empty());
  CHECK_FALSE(air.urban_glow.has_value());
  CHECK(air.where.line == 7);
  CHECK(air.where.column == 15);
}

TEST_CASE("an aerosol without attributes is the one that no element means", "[scenario][air]") {
  const auto said = layered("<layered><aerosol/></layered>").aerosol;
  const auto meant = layered("<layered/>").aerosol;
  CHECK(said.type == meant.type);
  CHECK(said.visibility_km == meant.visibility_km);
  CHECK(said.optical_depth_550 == meant.optical_depth_550);
  CHECK(said.relative_humidity == meant.relative_humidity);
  CHECK(said.season == meant.season);
  CHECK(said.volcanic == meant.volcanic);
}

TEST_CASE("all that can be said of layered air is read", "[scenario][air]") {
  const LayeredAir air = layered(
      "<layered profile=\"subarctic_winter\" sounding=\"curves.csv\" mode=\"fast\" "
      "water_vapour_g_cm2=\"0.4\" ozone_factor=\"1.1\" co2_ppm=\"280\" "
      "ground_reflectance=\"curves.csv#asphalt\" ground_temperature_k=\"270\" "
      "refraction=\"true\" night_sky=\"false\">"
      "<cloud type=\"cirrus\" base_m=\"9000\" top_m=\"10000\" optical_depth_550=\"0.3\"/>"
      "<aerosol type=\"maritime\" optical_depth_550=\"0.2\" relative_humidity_percent=\"85\" "
      "season=\"autumn_winter\" volcanic=\"high\"/>"
      "<cloud type=\"stratus\" base_m=\"500\" top_m=\"800\" optical_depth_550=\"12\"/>"
      "<urban_glow radiance=\"1e-6\"/></layered>");
  CHECK(air.profile == "subarctic_winter");
  CHECK(air.sounding == data_folder() / "curves.csv");
  CHECK(air.mode == atmosphere::AirMode::fast);
  CHECK(air.water_vapour.amount == 0.4);
  CHECK_FALSE(air.ozone.amount.has_value());
  CHECK(air.ozone.factor == 1.1);
  CHECK(air.co2_ppm == 280.0);
  CHECK(air.ground.reflectance->column == "asphalt");
  CHECK(air.ground.temperature_k == 270.0);
  CHECK(air.refraction);
  CHECK_FALSE(air.night_sky);
  CHECK(air.aerosol.type == atmosphere::AerosolType::maritime);
  CHECK(air.aerosol.optical_depth_550 == 0.2);
  CHECK(air.aerosol.relative_humidity == 0.85);
  CHECK(air.aerosol.season == atmosphere::Season::autumn_winter);
  CHECK(air.aerosol.volcanic == atmosphere::Volcanic::high);
  REQUIRE(air.clouds.size() == 2);
  CHECK(air.clouds[0].type == "cirrus");
  CHECK(air.clouds[1].base_m == 500.0);
  CHECK(air.clouds[1].top_m == 800.0);
  CHECK(air.clouds[1].optical_depth_550 == 12.0);
  CHECK(std::get<double>(air.urban_glow->source) == 1e-6);
}

TEST_CASE("every name of the aerosol's choices means its own", "[scenario][air]") {
  using atmosphere::AerosolType;
  const std::vector<std::pair<std::string, AerosolType>> types = {
      {"none", AerosolType::none},
      {"rural", AerosolType::rural},
      {"urban", AerosolType::urban},
      {"maritime", AerosolType::maritime},
      {"tropospheric", AerosolType::tropospheric},
      {"fog_advection", AerosolType::fog_advection},
      {"fog_radiation", AerosolType::fog_radiation}};
  for (const auto& [name, type] : types) {
    CAPTURE(name);
    CHECK(layered("<layered><aerosol type=\"" + name + "\"/></layered>").aerosol.type == type);
  }
  using atmosphere::Volcanic;
  const std::vector<std::pair<std::string, Volcanic>> states = {
      {"background", Volcanic::background},
      {"moderate", Volcanic::moderate},
      {"high", Volcanic::high},
      {"extreme", Volcanic::extreme}};
  for (const auto& [name, state] : states) {
    CAPTURE(name);
    CHECK(layered("<layered><aerosol volcanic=\"" + name + "\"/></layered>").aerosol.volcanic ==
          state);
  }
}

TEST_CASE("a table of the air from elsewhere is named with its ground", "[scenario][air]") {
  const TemporaryFolder folder;
  std::ofstream{folder / "day.air"} << "x";
  Diagnostics diagnostics;
  const auto scenario =
      sim::parse_scenario(with_scenario_air("<table file=\"day.air\" ground_reflectance=\"0.2\"/>"),
                          folder / "s.xml", diagnostics);
  const auto& air = std::get<sim::TableAir>(scenario.air);
  CHECK(air.file == folder / "day.air");
  CHECK(std::get<double>(air.ground.reflectance->source) == 0.2);
  CHECK(air.where.line == 7);
}

TEST_CASE("mistakes in the air are told where they stand", "[scenario][air]") {
  const std::vector<std::pair<std::string, std::string>> mistakes = {
      {"<layerd/>", "7:15: <atmosphere> may not hold <layerd> (did you mean \"layered\"?)\n"},
      {"<layered profile=\"tropcal\"/>",
       "7:24: attribute \"profile\" of <layered>: \"tropcal\", expected us_standard_1976 or "
       "tropical or midlatitude_summer or midlatitude_winter or subarctic_summer or "
       "subarctic_winter (did you mean \"tropical\"?)\n"},
      {"<layered water_vapour_g_cm2=\"2\" water_vapour_factor=\"1.5\"/>",
       "7:47: give either water_vapour_g_cm2 or water_vapour_factor, not both\n"},
      {"<layered ozone_factor=\"1.5\" ozone_du=\"300\"/>",
       "7:24: give either ozone_du or ozone_factor, not both\n"},
      {"<layered streams=\"7\"/>", "7:24: streams is 7, expected an even number\n"},
      {"<layered mode=\"fast\" streams=\"8\"/>",
       "7:36: the fast mode has two streams: streams would do nothing\n"},
      {"<layered sounding=\"curvs.csv\"/>", "7:24: file \"curvs.csv\" does not exist (looked at " +
                                                (data_folder() / "curvs.csv").string() +
                                                ") (that folder holds \"curves.csv\")\n"},
      {"<layered><aerosol visibility_km=\"0\"/></layered>",
       "7:33: attribute \"visibility_km\" of <aerosol>: \"0\", expected a number above 0 and at "
       "most 336 [km]\n"},
      {"<layered><aerosol visibility_km=\"5\" optical_depth_550=\"0.2\"/></layered>",
       "7:51: give either visibility_km or optical_depth_550, not both\n"},
      {"<layered><aerosol relative_humidity_percent=\"101\"/></layered>",
       "7:33: attribute \"relative_humidity_percent\" of <aerosol>: \"101\", expected a number "
       "from 0 to 99 [%]\n"},
      {"<layered><aerosol type=\"none\" visibility_km=\"5\"/></layered>",
       "7:45: <aerosol type=\"none\"> holds no particles: visibility_km would do nothing\n"},
      {"<layered><aerosol/><aerosol/></layered>",
       "7:34: <layered> holds only one <aerosol>; one stands in line 7 already\n"},
      {"<layered><cloud type=\"cumulus\" base_m=\"900\" top_m=\"800\" "
       "optical_depth_550=\"5\"/></layered>",
       "7:59: the top of the cloud at 800 m does not lie above its base at 900 m\n"},
      {"<layered><cloud type=\"cumulos\" base_m=\"900\" top_m=\"1800\" "
       "optical_depth_550=\"5\"/></layered>",
       "7:31: attribute \"type\" of <cloud>: \"cumulos\", expected cumulus or altostratus or "
       "stratus or stratocumulus or nimbostratus or cirrus or cirrus_thin or fog_advection or "
       "fog_radiation (did you mean \"cumulus\"?)\n"},
      {"<layered><urban_glow/></layered>",
       "7:24: <urban_glow> lacks its attribute \"radiance\" (it is a number from 0 to 1e9, or a "
       "spectrum file *.csv or *.csv#column [W m^-2 sr^-1 um^-1])\n"},
      {"<table file=\"day.air\"/>", "7:22: file \"day.air\" does not exist (looked at " +
                                        (data_folder() / "day.air").string() + ")\n"},
      {"<table file=\"curves.csv\"/>",
       "7:22: attribute \"file\" of <table>: \"curves.csv\", expected a file *.air\n"},
  };
  for (const auto& [air, message] : mistakes) {
    CAPTURE(air);
    CHECK(mistake_lines(with_scenario_air(air)) == message);
  }
}

TEST_CASE("several mistakes in the air are told at once", "[scenario][air]") {
  CHECK(mistake_lines(with_scenario_air("<layered streams=\"5\" ozone_du=\"1\" ozone_factor=\"1\">"
                                        "<urban_glow radiance=\"0\"/><urban_glow radiance=\"0\"/>"
                                        "</layered>")) ==
        "7:24: streams is 5, expected an even number\n"
        "7:49: give either ozone_du or ozone_factor, not both\n"
        "7:92: <layered> holds only one <urban_glow>; one stands in line 7 already\n");
}

TEST_CASE("the XML schema takes the forms of air that the reader takes", "[scenario][air]") {
  if (std::system("xmllint --version >/dev/null 2>&1") != 0) return;  // scenario_schema_test warns
  const std::string cloud =
      "<cloud type=\"cirrus\" base_m=\"9000\" top_m=\"10000\" optical_depth_550=\"0.3\"/>";
  const std::vector<std::pair<std::string, bool>> airs = {
      {"<layered/>", true},
      {"<layered>" + cloud + "<aerosol/>" + cloud + "<urban_glow radiance=\"0\"/></layered>", true},
      {"<layered profile=\"tropical\" mode=\"fast\" co2_ppm=\"300\"/>", true},
      {"<layered profile=\"tropic\"/>", false},
      {"<layered co2_ppm=\"-1\"/>", false},
      {"<layered><aerosol visibility_km=\"0\"/></layered>", false},
      {"<layered><aerosol visibility_km=\"1e-3\"/></layered>", true},
      {"<layered><none/></layered>", false},
      {"<layered/><layered/>", false},
      {"<table/>", false},
      {"<table file=\"curves.csv\"/>", false}};
  const TemporaryFolder folder;
  for (const auto& [air, good] : airs) {
    CAPTURE(air);
    const auto file = folder / "s.xml";
    std::ofstream{file, std::ios::binary} << with_scenario_air(air);
    const std::string xsd = std::string{NADIR_SOURCE_DIR} + "/scenes/schema/nadir.xsd";
    CHECK((std::system(("xmllint --noout --schema " + xsd + " " + file.string() + " 2>/dev/null")
                           .c_str()) == 0) == good);
    CHECK(mistake_lines(with_scenario_air(air)).empty() == good);
  }
}

}  // namespace nadir::test
