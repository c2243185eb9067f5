#include "scenario_support.hpp"
#include "support/catch.hpp"

// Heat balances of materials, and the weather and settings that they need.

using namespace nadir;
using namespace nadir::sim;
using test::minimal_text;
using test::mistake_lines;
using test::replaced;

namespace {

const std::string sky = "<heat><clear_sky/></heat>";

Scenario read_heat(const std::string& text) {
  Diagnostics diagnostics;
  return parse_scenario(text, test::data_folder() / "test.xml", diagnostics);
}

/// The minimal scenario with <heat> in line 8.
std::string with_heat(const std::string& heat) {
  return replaced(minimal_text(), "  <materials", heat + "\n  <materials");
}
HeatInput heat_of(const std::string& heat) {
  const Scenario scenario = read_heat(with_heat(heat));
  REQUIRE(scenario.heat);
  return *scenario.heat;
}
std::string told_of_heat(const std::string& attributes) {
  return mistake_lines(with_heat("<heat " + attributes + "><clear_sky/></heat>"));
}
std::string told_of_sky(const std::string& attributes) {
  return mistake_lines(with_heat("<heat><clear_sky " + attributes + "/></heat>"));
}

/// The minimal scenario with a heat balance in line 11, and clear skies.
std::string with_balance(const std::string& balance, const std::string& heat = sky) {
  return replaced(with_heat(heat), "<material name=\"grey\" reflectance=\"0.5\"/>",
                  "<material name=\"grey\" reflectance=\"0.5\">\n" + balance + "</material>");
}
const std::string thick = "<layer substance=\"concrete\"/>";
std::string balance_with(const std::string& attributes, const std::string& layers = thick) {
  return with_balance("<heat_balance " + attributes + ">" + layers + "</heat_balance>");
}
HeatBalanceInput balance_of(const std::string& attributes, const std::string& layers = thick) {
  return std::get<HeatBalanceInput>(
      read_heat(balance_with(attributes, layers)).materials.at(0).temperature);
}
std::string told_of_heat_input(const std::string& attributes, const std::string& layers = thick) {
  return mistake_lines(balance_with(attributes, layers));
}

Approx about(double value) { return Approx(value).epsilon(1e-15); }

}  // namespace

TEST_CASE("a heat balance without more is dry, follows the wind and has no back",
          "[scenario][heat]") {
  const HeatBalanceInput b = balance_of("");
  REQUIRE(b.layers.size() == 1);
  CHECK(b.layers[0].substance == "concrete");
  CHECK_FALSE(b.layers[0].thickness_m);
  CHECK(b.layers[0].layer.heat_w_m2 == 0.0);
  CHECK(b.layers[0].where.line == 11);
  CHECK(std::holds_alternative<thermal::AdiabaticBack>(b.back));
  CHECK(std::get<thermal::Tarp>(b.convection).roughness == thermal::Tarp{}.roughness);
  CHECK_FALSE(b.solar_absorptance);
  CHECK_FALSE(b.emissivity);
  CHECK(b.wind_factor == 1.0);
  CHECK(b.wetness == 0.0);
  CHECK(b.where.line == 11);
}

TEST_CASE("a heat balance keeps its surface, layers and back", "[scenario][heat]") {
  const Scenario s = read_heat(test::warm_text());
  const auto& roof = std::get<HeatBalanceInput>(s.materials.at(4).temperature);
  CHECK(roof.solar_absorptance == 0.4);
  CHECK(roof.emissivity == 0.25);
  CHECK(std::get<thermal::SimpleByRoughness>(roof.convection).roughness ==
        thermal::Roughness::smooth);
  CHECK(roof.wind_factor == 0.8);
  CHECK(roof.wetness == 0.1);
  const auto& room = std::get<thermal::RoomBack>(roof.back);
  CHECK(room.temperature->value == about(293.15));
  CHECK(room.film_w_m2_k == 6.0);
  REQUIRE(roof.layers.size() == 2);
  CHECK(roof.layers[0].thickness_m == 0.001);
  CHECK(roof.layers[1].substance.empty());
  CHECK(roof.layers[1].layer.substance.conductivity_w_m_k == 0.04);
  CHECK(roof.layers[1].layer.substance.density_kg_m3 == 30.0);
  CHECK(roof.layers[1].layer.substance.specific_heat_j_kg_k == 1200.0);
  CHECK(roof.layers[1].layer.thickness_m == 0.1);
  CHECK(roof.layers[1].layer.heat_w_m2 == 5.0);
}

TEST_CASE("every convection and every back is read", "[scenario][heat]") {
  CHECK(
      std::get<thermal::FixedFilm>(balance_of("convection=\"fixed\" film_w_m2_k=\"12\"").convection)
          .film_w_m2_k == 12.0);
  CHECK(std::holds_alternative<thermal::McAdams>(
      balance_of("convection=\"mcadams\" wind_factor=\"0.5\"").convection));
  CHECK(std::get<thermal::Tarp>(balance_of("roughness=\"very_rough\"").convection).roughness ==
        thermal::Roughness::very_rough);
  CHECK(std::get<thermal::Tarp>(balance_of("roughness=\"very_smooth\"").convection).roughness ==
        thermal::Roughness::very_smooth);
  CHECK(std::get<thermal::SimpleByRoughness>(balance_of("convection=\"simple\"").convection)
            .roughness == thermal::Roughness::medium_rough);
  const std::string sheet = "<layer substance=\"steel\" thickness_m=\"0.001\"/>";
  CHECK(std::get<thermal::FixedBack>(
            balance_of("back=\"fixed\" back_temperature_k=\"285\"", sheet).back)
            .temperature.value == 285.0);
  const auto room =
      std::get<thermal::RoomBack>(balance_of("back=\"room\" room_offset_k=\"4\"", sheet).back);
  CHECK_FALSE(room.temperature);
  CHECK(room.offset_k == 4.0);
  CHECK(room.film_w_m2_k == thermal::RoomBack{}.film_w_m2_k);
  CHECK(std::holds_alternative<thermal::OpenBack>(balance_of("back=\"open\"", sheet).back));
}

TEST_CASE("attributes of another convection are located", "[scenario][heat][mistakes]") {
  CHECK(told_of_heat_input("convection=\"fixed\"") ==
        "11:15: convection=\"fixed\" needs film_w_m2_k\n");
  CHECK(told_of_heat_input("film_w_m2_k=\"5\"") ==
        "11:15: film_w_m2_k is for convection=\"fixed\"\n");
  CHECK(told_of_heat_input("convection=\"mcadams\" roughness=\"rough\"") ==
        "11:36: roughness is for convection=\"tarp\" and convection=\"simple\"\n");
  CHECK(told_of_heat_input(
            "convection=\"fixed\" film_w_m2_k=\"5\" roughness=\"rough\" wind_factor=\"1\"") ==
        "11:50: roughness is for convection=\"tarp\" and convection=\"simple\"\n"
        "11:68: wind_factor is for convections that follow the wind, not for fixed\n");
  CHECK(told_of_heat_input("convection=\"tarpp\"") ==
        "11:15: attribute \"convection\" of <heat_balance>: \"tarpp\", expected tarp or mcadams or "
        "simple or fixed (did you mean \"tarp\"?)\n");
  CHECK(told_of_heat_input("roughness=\"ruff\"")
            .find("11:15: attribute \"roughness\" of <heat_balance>") == 0);
}

TEST_CASE("attributes of another back are located", "[scenario][heat][mistakes]") {
  const std::string sheet = "<layer substance=\"steel\" thickness_m=\"0.001\"/>";
  CHECK(told_of_heat_input("back=\"fixed\"", sheet) ==
        "11:15: back=\"fixed\" needs back_temperature_k or back_temperature_c\n");
  CHECK(told_of_heat_input("back=\"fixed\" back_temperature_k=\"280\" back_temperature_c=\"7\"",
                           sheet) ==
        "11:53: give either back_temperature_k or back_temperature_c, not both\n");
  CHECK(told_of_heat_input("back_temperature_k=\"280\"") ==
        "11:15: back_temperature_k is for back=\"fixed\"\n");
  CHECK(
      told_of_heat_input("room_temperature_c=\"20\" room_offset_k=\"1\" room_film_w_m2_k=\"8\"") ==
      "11:15: room_temperature_c is for back=\"room\"\n"
      "11:39: room_offset_k is for back=\"room\"\n"
      "11:57: room_film_w_m2_k is for back=\"room\"\n");
  CHECK(told_of_heat_input("back=\"room\" room_temperature_c=\"20\" room_offset_k=\"1\"", sheet) ==
        "11:51: room_offset_k is for a room that follows the air outdoors\n");
}

TEST_CASE("layers that lack something or have too much are located", "[scenario][heat][mistakes]") {
  const std::string no_thickness =
      "<layer> lacks thickness_m: only the last one above an adiabatic back goes as deep as a "
      "day's wave\n";
  CHECK(told_of_heat_input("", "<layer substance=\"a\"/>\n<layer substance=\"b\"/>") ==
        "11:16: " + no_thickness);
  CHECK(told_of_heat_input("back=\"open\"", "<layer substance=\"a\"/>") ==
        "11:27: " + no_thickness);
  CHECK(told_of_heat_input("", "<layer/>") ==
        "11:16: <layer> says not what it is made of (write substance=\"...\", or "
        "conductivity_w_m_k, density_kg_m3 and specific_heat_j_kg_k)\n");
  CHECK(told_of_heat_input("", "<layer conductivity_w_m_k=\"1\" density_kg_m3=\"2000\"/>") ==
        "11:16: <layer> lacks specific_heat_j_kg_k: give all three figures or a substance\n");
  CHECK(told_of_heat_input("", "<layer substance=\"a\" density_kg_m3=\"2000\"/>") ==
        "11:37: density_kg_m3 is for a layer without substance, which brings its own\n");
  CHECK(told_of_heat_input("", "<layer substance=\"a\" thickness_m=\"0\"/>") ==
        "11:37: attribute \"thickness_m\" of <layer>: \"0\", expected a number above 0 and at most "
        "1000 [m]\n");
  CHECK(told_of_heat_input("", "") == "11:1: <heat_balance> needs <layer>\n");
}

TEST_CASE("what follows the weather needs <heat>, which is told once",
          "[scenario][heat][mistakes]") {
  const std::string hint =
      ", which needs weather, but the scenario has no <heat> (the shortest is "
      "<heat><clear_sky/></heat> in <scenario>)\n";
  const auto said = [](const std::string& materials) {
    return mistake_lines(replaced(minimal_text(),
                                  "    <material name=\"grey\" "
                                  "reflectance=\"0.5\"/>",
                                  materials));
  };
  CHECK(said("<material name=\"grey\" emissivity=\"1\"><air_temperature/></material>") ==
        "9:38: material \"grey\" is as warm as the air" + hint);
  CHECK(said("<material name=\"grey\" emissivity=\"1\"><heat_balance>" + thick +
             "</heat_balance></material><material name=\"b\" emissivity=\"1\"><air_temperature/>"
             "</material>") == "9:38: material \"grey\" has a heat balance" + hint);
  CHECK(said("<library file=\"warm_library.xml\"/><material name=\"grey\" from=\"asphalt\" "
             "solve=\"true\"/>") == "9:72: material \"grey\" has a heat balance" + hint);
  CHECK(mistake_lines(with_balance("<air_temperature/>")).empty());
}

TEST_CASE("weather that nothing needs is told", "[scenario][heat]") {
  Diagnostics diagnostics;
  static_cast<void>(parse_scenario(with_heat(sky), test::data_folder() / "test.xml", diagnostics));
  REQUIRE(diagnostics.messages().size() == 1);
  CHECK(diagnostics.messages()[0] ==
        (test::data_folder() / "test.xml").string() +
            ":8:1: no material has a heat balance or the air's temperature: <heat> "
            "changes nothing");
  Diagnostics quiet;
  static_cast<void>(parse_scenario(balance_with(""), test::data_folder() / "test.xml", quiet));
  CHECK(quiet.messages().empty());
}

TEST_CASE("the defaults of <heat> are those of the plain data", "[scenario][heat]") {
  const HeatInput plain, h = heat_of(sky);
  CHECK(h.settings.step_s == plain.settings.step_s);
  CHECK(h.settings.resolution_m == plain.settings.resolution_m);
  CHECK(h.settings.history_s == plain.settings.history_s);
  CHECK(h.settings.spin_up_k == plain.settings.spin_up_k);
  CHECK(h.settings.spin_up_days == plain.settings.spin_up_days);
  CHECK(h.settings.grid.first_fraction == plain.settings.grid.first_fraction);
  CHECK(h.settings.grid.growth == plain.settings.grid.growth);
  CHECK(h.settings.exposure.sky_rays == plain.settings.exposure.sky_rays);
  CHECK(h.settings.exposure.surroundings == plain.settings.exposure.surroundings);
  CHECK(h.settings.exposure.surroundings_interval_s ==
        plain.settings.exposure.surroundings_interval_s);
  CHECK(h.shadow_interval_s == plain.shadow_interval_s);
  CHECK(h.shadow_days == plain.shadow_days);
  CHECK_FALSE(h.history_h);
  CHECK_FALSE(h.substances);
  CHECK_FALSE(h.ground_reflectance);
  const auto& clear = std::get<ClearSkyInput>(h.weather);
  CHECK(clear.air_low_k == about(ClearSkyInput{}.air_low_k));
  CHECK(clear.air_high_k == about(ClearSkyInput{}.air_high_k));
  CHECK(clear.dew_point_k == about(ClearSkyInput{}.dew_point_k));
  CHECK(clear.wind_m_s == ClearSkyInput{}.wind_m_s);
}

TEST_CASE("settings of the heat balance arrive in SI units", "[scenario][heat]") {
  const Scenario s = read_heat(test::warm_text());
  REQUIRE(s.heat);
  const HeatInput& h = *s.heat;
  CHECK(h.settings.step_s == 1200.0);
  CHECK(h.settings.resolution_m == 0.5);
  CHECK(h.history_h == 48.0);
  CHECK(h.settings.history_s == 172800.0);
  CHECK(h.shadow_interval_s == 600.0);
  CHECK(h.shadow_days == 2.0);
  CHECK(h.settings.exposure.sky_rays == 128);
  CHECK(h.settings.exposure.surroundings == 16);
  CHECK(h.settings.spin_up_k == 0.02);
  CHECK(h.settings.spin_up_days == 60);
  CHECK(h.settings.grid.first_fraction == 0.1);
  CHECK(h.settings.grid.growth == 1.5);
  CHECK(h.substances == test::data_folder() / "substances.csv");
  CHECK(h.ground_reflectance == 0.3);
  CHECK(h.where.line == 8);
  const auto& file = std::get<WeatherFileInput>(h.weather);
  CHECK(file.file == test::data_folder() / "weather.csv");
  CHECK(file.format == WeatherFormat::csv);
  CHECK(file.any_year == true);
  CHECK(file.long_wave == SkyLongWave::swinbank);
  CHECK(s.products.truth_temperature);
}

TEST_CASE("a weather file's format and sky may be left to the file", "[scenario][heat]") {
  const auto file = std::get<WeatherFileInput>(
      heat_of("<heat><weather_file file=\"weather.csv\"/></heat>").weather);
  CHECK(file.format == WeatherFormat::automatic);
  CHECK_FALSE(file.any_year);
  CHECK(file.long_wave == SkyLongWave::prata);
  CHECK(file.where.line == 8);
  const auto other = std::get<WeatherFileInput>(
      heat_of("<heat><weather_file file=\"weather.csv\" format=\"surfrad\" any_year=\"false\" "
              "long_wave=\"from_air\"/></heat>")
          .weather);
  CHECK(other.format == WeatherFormat::surfrad);
  CHECK(other.any_year == false);
  CHECK(other.long_wave == SkyLongWave::from_air);
}

TEST_CASE("a clear day's temperatures follow those that are given", "[scenario][heat]") {
  const auto sky_of = [](const std::string& attributes) {
    return std::get<ClearSkyInput>(heat_of("<heat><clear_sky " + attributes + "/></heat>").weather);
  };
  const ClearSkyInput low = sky_of("air_low_c=\"-10\"");
  CHECK(low.air_low_k == about(263.15));
  CHECK(low.air_high_k == about(275.15));
  CHECK(low.dew_point_k == about(260.15));
  const ClearSkyInput high = sky_of("air_high_k=\"310\" wind_m_s=\"0\"");
  CHECK(high.air_low_k == about(298.0));
  CHECK(high.dew_point_k == about(295.0));
  CHECK(high.wind_m_s == 0.0);
  const ClearSkyInput all = sky_of("air_low_k=\"280\" air_high_k=\"281\" dew_point_c=\"0\"");
  CHECK(all.air_high_k == 281.0);
  CHECK(all.dew_point_k == about(273.15));
}

TEST_CASE("days that cannot be are located", "[scenario][heat][mistakes]") {
  CHECK(told_of_sky("air_low_c=\"10\" air_high_c=\"9\"") ==
        "8:33: the air's highest temperature is below its lowest\n");
  CHECK(told_of_sky("air_low_c=\"10\" dew_point_k=\"290\"") ==
        "8:33: the dew point, 290.00 K, is above the air's lowest temperature, 283.15 K\n");
  CHECK(told_of_sky("air_low_c=\"10\" air_low_k=\"280\"") ==
        "8:33: give either air_low_k or air_low_c, not both\n");
  CHECK(mistake_lines(with_heat("<heat/>")) == "8:1: <heat> needs <weather_file> or <clear_sky>\n");
  CHECK(mistake_lines(with_heat("<heat><clear_sky/><weather_file file=\"weather.csv\"/></heat>")) ==
        "8:19: <heat> holds only one <weather_file> or <clear_sky>; <clear_sky> stands in line 8 "
        "already\n");
  CHECK(mistake_lines(with_heat("<heat><weather_file file=\"weathr.csv\"/></heat>"))
            .find("8:21: file \"weathr.csv\" does not exist") == 0);
  CHECK(mistake_lines(with_heat("<heat><weather_file file=\"weather.csv\" format=\"tmy\"/>"
                                "</heat>")) ==
        "8:40: attribute \"format\" of <weather_file>: \"tmy\", expected auto or csv or tmy3 or "
        "epw or surfrad (did you mean \"tmy3\"?)\n");
}

TEST_CASE("steps and shadows must fit a day and each other", "[scenario][heat][mistakes]") {
  CHECK(told_of_heat("step_min=\"7\"") ==
        "8:7: 24 h are not a whole number of times step_min = 7 min (6 would do)\n");
  CHECK(told_of_heat("shadow_interval_min=\"50\"") ==
        "8:7: 24 h are not a whole number of times shadow_interval_min = 50 min (48 would do)\n");
  CHECK(told_of_heat("step_min=\"0.3\" shadow_interval_min=\"0.6\"").empty());  // 4800 steps
  CHECK(told_of_heat("step_min=\"0.2\"").empty());
  CHECK(told_of_heat("step_min=\"0.1\"").find("8:7: attribute \"step_min\" of <heat>") == 0);
  CHECK(told_of_heat("step_min=\"61\"").find("8:7: attribute \"step_min\" of <heat>") == 0);
  CHECK(told_of_heat("step_min=\"10\" shadow_interval_min=\"15\"") ==
        "8:21: shadow_interval_min, 15, is neither a multiple nor a whole fraction of step_min, "
        "10\n");
  CHECK(told_of_heat("step_min=\"15\" shadow_interval_min=\"60\"").empty());
  CHECK(told_of_heat("step_min=\"60\" shadow_interval_min=\"15\"").empty());
  CHECK(told_of_heat("history_h=\"24.1\"") ==
        "8:7: history_h, 24.1, is not a whole number of steps of 10 min\n");
  CHECK(told_of_heat("history_h=\"24.5\"").empty());
  CHECK(told_of_heat("history_h=\"12\"").find("8:7: attribute \"history_h\" of <heat>") == 0);
  CHECK(told_of_heat("shadow_days=\"1.5\"").find("8:7: attribute \"shadow_days\" of <heat>") == 0);
}

TEST_CASE("the surroundings' sun is looked up at moments of the shadows", "[scenario][heat]") {
  const auto interval_s = [](const char* minutes) {
    const std::string both =
        std::string{"step_min=\""} + minutes + "\" shadow_interval_min=\"" + minutes + "\"";
    return heat_of("<heat " + both + "><clear_sky/></heat>")
        .settings.exposure.surroundings_interval_s;
  };
  CHECK(interval_s("10") == 3600.0);
  CHECK(interval_s("16") == 4 * 960.0);
  CHECK(interval_s("48") == 2880.0);
  CHECK(interval_s("60") == 3600.0);
}

TEST_CASE("a truth plane of temperatures needs the truth", "[scenario][heat][mistakes]") {
  const auto products = [](const std::string& attributes) {
    return replaced(minimal_text(), "</scenario>", "<products " + attributes + "/></scenario>");
  };
  CHECK(mistake_lines(products("truth=\"false\" truth_temperature=\"true\"")) ==
        "25:25: truth_temperature=\"true\" asks for a plane that truth=\"false\" leaves out\n");
  CHECK_FALSE(read_heat(products("truth=\"true\"")).products.truth_temperature);
}
