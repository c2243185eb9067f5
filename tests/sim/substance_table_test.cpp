#include "sim/files/substance_table.hpp"

#include <cmath>
#include <filesystem>

#include "sim/message_of.hpp"
#include "sim/scenario/material_library.hpp"
#include "support/catch.hpp"

using namespace nadir;
using namespace nadir::sim;

namespace {

namespace fs = std::filesystem;
const fs::path substances_file = fs::path{NADIR_SOURCE_DIR} / "scenes" / "library" / "thermal.csv";

const std::string substance_columns_text =
    "substance,conductivity_w_m_k,density_kg_m3,specific_heat_j_kg_k\n";

std::string substance_message(const std::string& text) {
  return support::message_of([&] { (void)parse_substances(text, "own.csv"); });
}

}  // namespace

TEST_CASE("a table of substances needs three figures and takes what else it is given",
          "[sim][substances]") {
  const auto plain = parse_substances(
      "# mine\n\n" + substance_columns_text + "clay-brick.1, 0.9 ,1900,800\r\n", "own.csv");
  REQUIRE(plain.size() == 1);
  const ListedSubstance& brick = plain.at("clay-brick.1");
  CHECK(brick.substance.conductivity_w_m_k == 0.9);
  CHECK(brick.substance.density_kg_m3 == 1900.0);
  CHECK(brick.substance.specific_heat_j_kg_k == 800.0);
  CHECK_FALSE(brick.solar_absorptance);
  const auto full = parse_substances(
      "source,emissivity,checked,substance,specific_heat_j_kg_k,solar_absorptance,density_kg_m3,"
      "conductivity_w_m_k\n"
      "\"Oke, \"\"Climates\"\"\" ,0.9,no,peat,1920,,300,0.06\n",
      "own.csv");
  const ListedSubstance& peat = full.at("peat");
  CHECK(peat.source == "Oke, \"Climates\"");
  CHECK(peat.checked == "no");
  CHECK(peat.emissivity == 0.9);
  CHECK_FALSE(peat.solar_absorptance);
  CHECK(peat.substance.heat_capacity_j_m3_k() == 576000.0);
}

TEST_CASE("all mistakes in a table of substances have their places", "[sim][substances]") {
  CHECK(substance_message(substance_columns_text +
                          "foam,0,30,1400\nfoil,nan,2700,900\nbare,1,2\nice cube,2,917,2100\n"
                          "ash,1,1,1000\nash,1,1,1000\n") ==
        "own.csv:2:6: error: conductivity_w_m_k must lie from 0.001 to 5000\n"
        "    2 | foam,0,30,1400\n"
        "      |      ^\n"
        "own.csv:3:6: error: expected a finite number for conductivity_w_m_k, found \"nan\"\n"
        "    3 | foil,nan,2700,900\n"
        "      |      ^\n"
        "own.csv:4:1: error: expected 4 cells, found 3\n"
        "    4 | bare,1,2\n"
        "      | ^\n"
        "own.csv:5:1: error: expected the name of a substance: letters, digits, \"_\", \"-\", "
        "\".\"\n"
        "    5 | ice cube,2,917,2100\n"
        "      | ^\n"
        "own.csv:7:1: error: the substance \"ash\" is there twice\n"
        "    7 | ash,1,1,1000\n"
        "      | ^\n");
  CHECK(substance_message("substance,conductivity_w_mk,density_kg_m3,density_kg_m3\na,1,1,1\n") ==
        "own.csv:1:11: error: unknown column \"conductivity_w_mk\"\n"
        "    1 | substance,conductivity_w_mk,density_kg_m3,density_kg_m3\n"
        "      |           ^\n"
        "    hint: did you mean \"conductivity_w_m_k\"?\n"
        "own.csv:1:43: error: the column \"density_kg_m3\" is there twice\n"
        "    1 | substance,conductivity_w_mk,density_kg_m3,density_kg_m3\n"
        "      |                                           ^\n"
        "own.csv:1:1: error: the column \"conductivity_w_m_k\" is missing\n"
        "    1 | substance,conductivity_w_mk,density_kg_m3,density_kg_m3\n"
        "      | ^\n"
        "own.csv:1:1: error: the column \"specific_heat_j_kg_k\" is missing\n"
        "    1 | substance,conductivity_w_mk,density_kg_m3,density_kg_m3\n"
        "      | ^\n");
  CHECK(substance_message(substance_columns_text + "\"a,1,1,1000\n")
            .find("own.csv:2:1: error: the quotation mark is not closed on its line") == 0);
  CHECK(substance_message(substance_columns_text + "\"a\"b,1,1,1000\n")
            .find("own.csv:2:4: error: expected a comma after the quotation mark") == 0);
  CHECK(substance_message("# nothing\n") ==
        "own.csv: error: the table is empty: its first row names the columns\n");
  CHECK(substance_message(substance_columns_text) == "own.csv: error: the table has no rows\n");
  CHECK_THROWS_AS(read_substances("/nowhere/thermal.csv"), InputError);
}

TEST_CASE("an unknown substance is told with the nearest name, or with all", "[sim][substances]") {
  const auto table = parse_substances(
      substance_columns_text + "brick_red,1,1900,800\nwater,1,1000,4180\n", "own.csv");
  CHECK(find_substance(table, "water").substance.density_kg_m3 == 1000.0);
  const SourceLocation where{"yard.xml", 12, 7};
  CHECK(support::message_of([&] { (void)find_substance(table, "brick_rad", where); }) ==
        "yard.xml:12:7: error: there is no substance \"brick_rad\" in the table\n"
        "    hint: did you mean \"brick_red\"?\n");
  CHECK(support::message_of([&] { (void)find_substance(table, "unobtainium", where); }) ==
        "yard.xml:12:7: error: there is no substance \"unobtainium\" in the table\n"
        "    hint: known are: brick_red, water\n");
}

TEST_CASE("a table of substances that was written reads back", "[sim][substances]") {
  SubstanceTable table;
  table["tar"] = {{0.17, 1050.0, 1340.0}, std::nullopt, 0.93, "no", "a \"book\", page 1"};
  table["air"] = {{0.1 + 0.2, 1.2, 1005.0}, 0.0, std::nullopt, "", ""};
  const auto again = parse_substances(substances_text(table, {"title: two"}), "own.csv");
  REQUIRE(again.size() == 2);
  CHECK(again.at("air").substance.conductivity_w_m_k == 0.1 + 0.2);
  CHECK(again.at("air").solar_absorptance == 0.0);
  CHECK_FALSE(again.at("air").emissivity);
  CHECK(again.at("tar").source == "a \"book\", page 1");
  CHECK(again.at("tar").emissivity == 0.93);
}

TEST_CASE("the substances that ship are plausible and say where they come from",
          "[sim][substances][library]") {
  const SubstanceTable table = read_substances(substances_file);
  CHECK(table.size() == 38);
  for (const auto& [name, row] : table) {
    CAPTURE(name);
    // Snow holds least, water most; nothing common conducts worse than foam or better than copper.
    CHECK(row.substance.heat_capacity_j_m3_k() > 4e4);
    CHECK(row.substance.heat_capacity_j_m3_k() < 4.3e6);
    CHECK(row.substance.conductivity_w_m_k >= 0.03);
    CHECK(row.substance.conductivity_w_m_k <= 420.0);
    CHECK(row.source.size() > 10);
    CHECK((row.checked == "yes" || row.checked == "partly" || row.checked == "no" ||
           row.checked == "derived"));
    CHECK(row.solar_absorptance.has_value());
    CHECK(row.emissivity.has_value());
  }
  // ASHRAE HOF 2005 chapter 30, item M01, as EnergyPlus' data set has it.
  const thermal::Substance& brick = table.at("brick_red").substance;
  CHECK(brick.conductivity_w_m_k == 0.89);
  CHECK(brick.density_kg_m3 == 1920.0);
  CHECK(brick.specific_heat_j_kg_k == 790.0);
}

// Water in the pores adds its own heat: half of what saturation adds. Conductivity rises faster
// (Johansen 1975): 70 % of the way for fine grains, 79 % for coarse. 1 %: three digits are kept.
TEST_CASE("moist soils lie between dry and saturated ones as water fills pores",
          "[sim][substances][library]") {
  const SubstanceTable table = read_substances(substances_file);
  for (const auto& [kind, share] : {std::pair{"soil_clay_", 0.699}, {"soil_sandy_", 0.789}}) {
    CAPTURE(kind);
    const std::string name = kind;  // clang 14 does not capture the binding itself
    const auto of = [&](const char* state) { return table.at(name + state).substance; };
    const auto dry = of("dry"), moist = of("moist"), wet = of("saturated");
    CHECK(moist.density_kg_m3 ==
          Approx(0.5 * (dry.density_kg_m3 + wet.density_kg_m3)).epsilon(0.01));
    CHECK(moist.heat_capacity_j_m3_k() ==
          Approx(0.5 * (dry.heat_capacity_j_m3_k() + wet.heat_capacity_j_m3_k())).epsilon(0.01));
    CHECK(moist.conductivity_w_m_k ==
          Approx(dry.conductivity_w_m_k + share * (wet.conductivity_w_m_k - dry.conductivity_w_m_k))
              .epsilon(0.01));
  }
}

TEST_CASE("what lies beneath the library's materials is made of substances that ship",
          "[sim][substances][library]") {
  const SubstanceTable table = read_substances(substances_file);
  const auto materials = read_material_library(substances_file.parent_path() / "materials.xml");
  int with_layers = 0;
  for (const LibraryMaterial& material : materials) {
    CAPTURE(material.name);
    if (!material.heat_balance) continue;
    ++with_layers;
    const HeatBalanceInput& below = *material.heat_balance;
    REQUIRE_FALSE(below.layers.empty());
    // Spectra say how surfaces absorb and emit; but that of water is its surface's alone.
    CHECK(below.solar_absorptance.has_value() == (material.name == "water"));
    CHECK_FALSE(below.emissivity);
    thermal::LayerStack stack{{}, below.back};
    for (const LayerInput& layer : below.layers) {
      const auto& row = find_substance(table, layer.substance, layer.where);
      const bool last = &layer == &below.layers.back();
      CHECK((layer.thickness_m || last));
      // Nothing given: as deep as the day's wave goes. A metre holds it in any ground.
      stack.layers.push_back({row.substance, layer.thickness_m.value_or(1.0), 0.0});
    }
    CHECK_NOTHROW(thermal::check(stack));
  }
  CHECK(materials.size() == 59);
  CHECK(with_layers == 58);  // all but a coat of gold, which may lie on anything
}
