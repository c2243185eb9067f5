#include "sim/files/therm_values.hpp"

#include "core/error.hpp"
#include "sim/message_of.hpp"
#include "support/catch.hpp"

using namespace nadir;
using namespace nadir::sim;

namespace {

const std::string three_figures =
    "SPECIFIC_HEAT = 0.2\nTHERMAL_CONDUCTIVITY = 10\nMASS_DENSITY = 2\n";

std::string therm_message(const std::string& text) {
  return support::message_of([&] { (void)parse_therm(text, "yard.mat"); });
}

const std::string yard = R"(# A yard
MATERIAL_ENTRY {
  NAME = Asphalt, old
  ID = 1
  EDITOR_COLOR = #303030
  SURFACE_PROPERTIES {
    REFLECTANCE_PROP { FILE = /a//b.nmf }
    REFLECTANCE_PROP {
      FILE = /a//b.nmf
    }
  }
  TEMP_SOLVER_NAME = Therm
  TEMP_SOLVER
  {
    SPECIFIC_HEAT = 0.22       // cal/(g C)
    THERMAL_CONDUCTIVITY = 6.45
    MASS_DENSITY = 2110
    THICKNESS = 10
    SOLAR_ABSORPTION = 0.9
    THERMAL_EMISSIVITY = 0.95
    EXPOSED_AREA = 0.4
  }
}
MATERIAL_ENTRY {
  NAME = painted
  TEMP_SOLVER_NAME = DataDriven
  TEMP_SOLVER {
    FILE = roof.csv
  }
}
MATERIAL_ENTRY {
  NAME = Asphalt old
  TEMP_SOLVER_NAME = THERM
  TEMP_SOLVER {
    specific_heat = 0.22
    thermal_conductivity = 6.45
    mass_density = 2.11
    VISIBLE_EMISSIVITY = 0.8
    SKY_EXPOSURE = 1
    SPECULARITY = 0.1
  }
}
)";

}  // namespace

// The thermochemical calorie is 4.184 J exactly (NIST SP 811). Water defines the old units: 1 cal
// warms 1 g by 1 C, and 0.57 W/(m K) (Oke 1987) is 1.36e-3 cal/(cm s C) in books of that time.
TEST_CASE("calories become joules by the factors of NIST", "[sim][therm]") {
  const auto water = parse_therm(
      "SPECIFIC_HEAT = 1\nTHERMAL_CONDUCTIVITY = 4.9\nMASS_DENSITY = 1\nTHICKNESS = 100\n",
      "w.mat");
  REQUIRE(water.materials.size() == 1);
  const ThermMaterial& found = water.materials.front();
  CHECK(found.substance.specific_heat_j_kg_k == Approx(4184.0).epsilon(1e-14));
  CHECK(found.substance.density_kg_m3 == Approx(1000.0).epsilon(1e-14));
  CHECK(found.substance.conductivity_w_m_k == Approx(0.57).epsilon(2e-3));  // two digits given
  REQUIRE(found.thickness_m);
  CHECK(*found.thickness_m == Approx(1.0).epsilon(1e-14));
  // Diffusivity has no calories in it: cm^2/h to m^2/s. Its product with the heat capacity is k.
  CHECK(found.substance.diffusivity_m2_s() == Approx(4.9 * 1e-4 / 3600.0).epsilon(1e-12));
}

TEST_CASE("the converter of thermal values says what it did line by line", "[sim][therm]") {
  CHECK(therm_report(parse_therm(yard, "yard.mat")) ==
        R"(yard.mat: 2 materials; 1 cal = 4.184 J (thermochemical)
  yard.mat:27: TEMP_SOLVER passed over: its values are for "DataDriven", not for THERM
  yard.mat:24: material "painted" has no values for THERM

asphalt_old, in the file "Asphalt, old"
  yard.mat:6: block SURFACE_PROPERTIES passed over: it says nothing of heat
  yard.mat:15: SPECIFIC_HEAT = 0.22 cal/(g C) x 4184 = 920.48 J/(kg K)
  yard.mat:16: THERMAL_CONDUCTIVITY = 6.45 cal/(cm h C) x 0.116222 = 0.749633 W/(m K)
  yard.mat:17: MASS_DENSITY = 2110 g/cm3 x 1000 = 2.11e+06 kg/m3
  yard.mat:17: warning: 2.11e+06 kg/m3 is more than common materials have; 2110 kg/m3 would be common: is the file in SI units?
  yard.mat:18: THICKNESS = 10 cm x 0.01 = 0.1 m
  yard.mat:19: SOLAR_ABSORPTION = 0.9: taken over as solar_absorptance
  yard.mat:20: THERMAL_EMISSIVITY = 0.95: taken over as emissivity
  yard.mat:21: EXPOSED_AREA = 0.4: no counterpart; what a surface loses at its other side is said by the layers and by back
  yard.mat:2: warning: density x specific heat = 1.942e+09 J/(m3 K): water, which holds most, has 4.18e+06, foam 2e+04
<heat_balance solar_absorptance="0.9" emissivity="0.95">
  <layer conductivity_w_m_k="0.749633" density_kg_m3="2110000" specific_heat_j_kg_k="920.48" thickness_m="0.1"/>
</heat_balance>

asphalt_old_2, in the file "Asphalt old"
  yard.mat:35: SPECIFIC_HEAT = 0.22 cal/(g C) x 4184 = 920.48 J/(kg K)
  yard.mat:36: THERMAL_CONDUCTIVITY = 6.45 cal/(cm h C) x 0.116222 = 0.749633 W/(m K)
  yard.mat:37: MASS_DENSITY = 2.11 g/cm3 x 1000 = 2110 kg/m3
  yard.mat:38: VISIBLE_EMISSIVITY = 0.8: taken over as solar_absorptance
  yard.mat:39: SKY_EXPOSURE = 1: no counterpart; how much sky a surface sees is found from the geometry
  yard.mat:40: SPECULARITY = 0.1: no counterpart; how a surface reflects is said by its material's scattering
  yard.mat:31: no THICKNESS: the layer goes as deep as the day's wave
<heat_balance solar_absorptance="0.8">
  <layer conductivity_w_m_k="0.749633" density_kg_m3="2110" specific_heat_j_kg_k="920.48"/>
</heat_balance>
)");
}

TEST_CASE("converted thermal values make a table of substances", "[sim][therm]") {
  const std::string text = "NAME = Tree, trunk\n" + three_figures + "THERMAL_EMISSIVITY = 0.9\n" +
                           "NAME = soil\n" + three_figures;
  const std::string csv = therm_csv(parse_therm(text, "/somewhere/yard.mat"));
  CHECK(csv ==
        "# title: Thermal properties converted from calorie units\n"
        "# made-by: nadir materials therm\n"
        "substance,conductivity_w_m_k,density_kg_m3,specific_heat_j_kg_k,solar_absorptance,"
        "emissivity,checked,source\n"
        "soil,1.16222,2000,836.8,,,no,\"yard.mat line 6, soil\"\n"
        "tree_trunk,1.16222,2000,836.8,,0.9,no,\"yard.mat line 1, Tree, trunk\"\n");
  const SubstanceTable table = parse_substances(csv, "yard.csv");
  CHECK(table.at("soil").substance.specific_heat_j_kg_k == 836.8);
  CHECK(table.at("tree_trunk").emissivity == 0.9);
}

TEST_CASE("thermal values that are unknown, wrong or missing are mistakes", "[sim][therm]") {
  CHECK(therm_message("TEMP_SOLVER {\n  SPECIFIC_HEET = 0.2\n  MASS_DENSITY = -2\n"
                      "  THERMAL_CONDUCTIVITY = 1,5\n  THERMAL_EMISSIVITY = 1.2\n"
                      "  SOLAR_ABSORPTION = 0.5\n  VISIBLE_EMISSIVITY = 0.5\n  NAME = a\n}\n") ==
        R"(yard.mat:2:3: error: unknown key "SPECIFIC_HEET"
    2 |   SPECIFIC_HEET = 0.2
      |   ^
    hint: did you mean "SPECIFIC_HEAT"?
yard.mat:3:18: error: expected a number above 0 for MASS_DENSITY, found "-2"
    3 |   MASS_DENSITY = -2
      |                  ^
yard.mat:4:26: error: expected a number above 0 for THERMAL_CONDUCTIVITY, found "1,5"
    4 |   THERMAL_CONDUCTIVITY = 1,5
      |                          ^
yard.mat:5:24: error: expected a number from 0 to 1 for THERMAL_EMISSIVITY, found "1.2"
    5 |   THERMAL_EMISSIVITY = 1.2
      |                        ^
yard.mat:7:3: error: this is given twice for one material
    7 |   VISIBLE_EMISSIVITY = 0.5
      |   ^
yard.mat:8:3: error: unknown key "NAME"
    8 |   NAME = a
      |   ^
    hint: known are: SPECIFIC_HEAT, THERMAL_CONDUCTIVITY, MASS_DENSITY, THICKNESS, )"
        R"(SOLAR_ABSORPTION, VISIBLE_EMISSIVITY, THERMAL_EMISSIVITY, EXPOSED_AREA, SKY_EXPOSURE, )"
        R"(SPECULARITY
yard.mat:1:1: error: SPECIFIC_HEAT is missing
    1 | TEMP_SOLVER {
      | ^
)");
  CHECK(therm_message("MATERIAL_ENTRI {\n" + three_figures + "}\n")
            .find("yard.mat:1:1: error: unknown block \"MATERIAL_ENTRI\"\n") == 0);
  CHECK(therm_message("MATERIAL_ENTRY {\n" + three_figures)
            .find("yard.mat:1:1: error: the block \"MATERIAL_ENTRY\" is not closed\n") == 0);
  CHECK(therm_message(three_figures + "}\n")
            .find("yard.mat:4:1: error: there is no block to close\n") == 0);
  CHECK(therm_message(three_figures + "emits\n")
            .find("yard.mat:4:1: error: expected KEY = VALUE, the name of a block and {, or }\n") ==
        0);
  CHECK(therm_message("# nothing\n") ==
        "yard.mat: error: the file has no thermal values: expected lines such as SPECIFIC_HEAT = "
        "0.2\n");
  CHECK_THROWS_AS(read_therm("/nowhere/yard.mat"), InputError);
}

TEST_CASE("figures already in SI units are suspected", "[sim][therm]") {
  const std::string report = therm_report(parse_therm(
      "SPECIFIC_HEAT = 920\nTHERMAL_CONDUCTIVITY = 0.75\nMASS_DENSITY = 2110\n", "yard.mat"));
  CHECK(report.find("yard.mat:1: warning: 3.84928e+06 J/(kg K) is more than common materials have; "
                    "920 J/(kg K) would be common: is the file in SI units?") != std::string::npos);
  CHECK(report.find("yard.mat:3: warning: ") != std::string::npos);
}
