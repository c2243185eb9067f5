#include "sim/files/sounding.hpp"

#include <cmath>
#include <filesystem>

#include "core/error.hpp"
#include "sim/files/band_tables.hpp"
#include "sim/message_of.hpp"
#include "support/catch.hpp"

namespace nadir::sim {
namespace {

using atmosphere::Gas;
using atmosphere::Profile;

const Profile& standard() {
  static const Profile profile = standard_profile(
      read_band_tables(std::filesystem::path{NADIR_SOURCE_DIR} / "scenes/library/atmosphere"),
      "midlatitude_summer");
  return profile;
}

std::string sounding_message(const std::string& text) {
  Diagnostics diagnostics;
  return support::message_of(
      [&] { static_cast<void>(parse_sounding(text, "s.csv", standard(), diagnostics)); });
}

// Hydrostatic at about 288 K: a scale height of 8.43 km.
const std::string sounding_head = "height_m,pressure_hpa,temperature_c,relative_humidity_percent\n";

TEST_CASE("a sounding joins a standard profile above its top", "[sim][sounding]") {
  Diagnostics diagnostics;
  const Profile air =
      parse_sounding(sounding_head + "300,980,15,60\n1300,870,9,50\n3300,681,-4,30\n", "s.csv",
                     standard(), diagnostics);
  CHECK(diagnostics.messages().empty());
  CHECK(air.levels[0].height_m == 300.0);
  CHECK(air.levels[1].temperature_k == Approx(282.15).epsilon(1e-12));
  CHECK(relative_humidity(air.levels[2]) == Approx(0.30).epsilon(1e-9));
  CHECK(air.levels[3].height_m == 5000.0);  // the first of the standard levels 1 km above
  CHECK(air.levels.back().height_m == standard().levels.back().height_m);
  CHECK(air.levels[0].mixing(Gas::co2) == Approx(420.0).epsilon(1e-9));
  // The pressures above keep their ratio to the standard ones.
  const double joined = 681.0 / level_at(standard(), 3300.0).pressure_hpa;
  CHECK(air.levels[3].pressure_hpa / level_at(standard(), 5000.0).pressure_hpa ==
        Approx(joined).epsilon(1e-9));
  CHECK_NOTHROW(check(air));
  CHECK_THROWS_AS(level_at(air, 299.0), InputError);  // nothing is known below
}

TEST_CASE("humidity may be given in four ways", "[sim][sounding]") {
  Diagnostics diagnostics;
  const auto water = [&](const std::string& column, const std::string& value) {
    return parse_sounding("height_m,pressure_hpa,temperature_k," + column + "\n0,1000,298.15," +
                              value + "\n1000,892,292," + "0\n",
                          "s.csv", standard(), diagnostics)
        .levels[0]
        .mixing(Gas::h2o);
  };
  // 31.70 hPa saturate at 25 C: half of it in 1000 hPa is 15,850 ppmv, a mixing ratio of
  // 621.98 e/(p - e) = 10.02 g/kg.
  CHECK(water("relative_humidity_percent", "50") == Approx(15850.0).epsilon(1e-3));
  CHECK(water("mixing_ratio_g_kg", "10.017") == Approx(15850.0).epsilon(1e-3));
  CHECK(water("h2o_ppmv", "15850") == Approx(15850.0).epsilon(1e-12));
  // 15.85 hPa saturate at 13.87 C (Murphy & Koop).
  const Profile dew = parse_sounding(
      "height_m,pressure_hpa,temperature_k,dewpoint_c,o3_ppmv\n0,1000,298.15,13.87,0.05\n"
      "1000,892,292,-20,0.06\n",
      "s.csv", standard(), diagnostics);
  CHECK(dew.levels[0].mixing(Gas::h2o) == Approx(15850.0).epsilon(1e-3));
  CHECK(dew.levels[1].mixing(Gas::o3) == 0.06);
}

TEST_CASE("mistakes of a sounding have their places", "[sim][sounding]") {
  CHECK(sounding_message(sounding_head + "0,1013,15,60\n0,900,10,60\n") ==
        "s.csv:3:1: error: heights must ascend: 0 m follows 0 m\n"
        "    3 | 0,900,10,60\n"
        "      | ^\n");
  CHECK(sounding_message(sounding_head + "0,1013,15,60\n\n# a remark\n1000,1020,10,60\n") ==
        "s.csv:5:6: error: pressures must fall with height: 1020 hPa follows 1013 hPa\n"
        "    5 | 1000,1020,10,60\n"
        "      |      ^\n");
  CHECK(sounding_message(sounding_head + "0,1013,15,103\n1000,900,10,60\n") ==
        "s.csv:2:11: error: relative_humidity_percent must lie from 0 to 102\n"
        "    2 | 0,1013,15,103\n"
        "      |           ^\n");
  CHECK_THAT(
      sounding_message(
          "height_m,pressure_hpa,temperature_c,dewpoint_c\n0,1013,15,16\n1000,900,10,5\n"),
      Catch::Matchers::Contains("s.csv:2:11: error: the humidity lies above saturation: 107 %"));
  CHECK_THAT(sounding_message(sounding_head + "0,1013,-140,10\n1000,900,10,60\n"),
             Catch::Matchers::Contains("s.csv:2:8: error: temperature_c must lie from"));
  CHECK(sounding_message(sounding_head + "0,1013,15,60\n") ==
        "s.csv: error: a sounding needs at least two rows\n");
  CHECK_THAT(sounding_message("height_m,pressure_hpa,temperature_c\n0,1013,15\n1000,900,10\n"),
             Catch::Matchers::Contains(
                 "expected one of the columns relative_humidity_percent, dewpoint_c, "
                 "mixing_ratio_g_kg, h2o_ppmv, found none"));
  CHECK_THAT(sounding_message(
                 "height_m,pressure_hpa,temperature_c,temperature_k,h2o_ppmv\n0,1013,15,288,1\n"
                 "1000,900,10,283,1\n"),
             Catch::Matchers::Contains("temperature_k, temperature_c, found 2"));
}

TEST_CASE("heights and pressures that disagree are told or refused", "[sim][sounding]") {
  // Feet for metres: the layer is 3.28 times too thick.
  CHECK_THAT(sounding_message(sounding_head + "0,1013,15,60\n3281,900,9,60\n"),
             Catch::Matchers::Contains("s.csv:3:1: error: heights and pressures disagree"));
  Diagnostics diagnostics;
  static_cast<void>(parse_sounding(sounding_head + "0,1013,15,60\n1080,900,9,60\n", "s.csv",
                                   standard(), diagnostics));
  REQUIRE(diagnostics.messages().size() == 1);
  CHECK_THAT(diagnostics.messages()[0], Catch::Matchers::Contains("disagree by 9 % below 1080 m"));
}

TEST_CASE("the standard profiles pass their own test of balance", "[sim][sounding]") {
  std::string text = "height_m,pressure_hpa,temperature_k,h2o_ppmv\n";
  for (const atmosphere::Level& level : standard().levels) {
    if (level.height_m > 24'000.0) break;
    text += std::to_string(level.height_m) + "," + std::to_string(level.pressure_hpa) + "," +
            std::to_string(level.temperature_k) + "," + std::to_string(level.mixing(Gas::h2o)) +
            "\n";
  }
  Diagnostics diagnostics;
  CHECK_NOTHROW(parse_sounding(text, "s.csv", standard(), diagnostics));
  CHECK(diagnostics.messages().empty());
}

}  // namespace
}  // namespace nadir::sim
