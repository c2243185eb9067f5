#include <cmath>
#include <filesystem>
#include <optional>
#include <string>

#include "sim/files/text_tokens.hpp"
#include "sim/files/weather_csv.hpp"
#include "sim/files/weather_epw.hpp"
#include "sim/files/weather_format.hpp"
#include "sim/files/weather_surfrad.hpp"
#include "sim/files/weather_text.hpp"
#include "sim/files/weather_tmy3.hpp"
#include "sim/files/weather_typical.hpp"
#include "sim/weather_support.hpp"
#include "support/catch.hpp"

namespace nadir::sim {
namespace {

using Q = WeatherQuantity;

// Values are the cells' own, converted by one sum or product: 1e-12 is rounding.
constexpr double rounding = 1e-12;

const std::string csv_text =
    "# station: Roof\n# latitude_deg: 36.1\n# longitude_deg: -79.95\n# height_m: 273\n"
    "# radiation_mean_s: 600\n# any other remark: it passes\n"
    "utc,air_temperature_c,relative_humidity_percent,pressure_pa,wind_speed_m_s,"
    "global_horizontal_w_m2,cloud_tenths\n"
    "2026-06-21T16:00:00Z,25.5,101,98000,3.5,700,4\n"
    "2026-06-21T16:10Z,,54,98010,3.25,-2.5,10\n";

TEST_CASE("a CSV of weather is read in the units its columns name", "[sim][weather]") {
  const WeatherRecord record = parse_weather_csv(csv_text, "w.csv");
  CHECK(record.station.name == "Roof");
  CHECK(record.station.latitude_deg == 36.1);
  CHECK(record.station.longitude_deg == -79.95);
  CHECK(record.station.height_m == 273.0);
  CHECK(record.radiation_mean_s == 600.0);
  CHECK_FALSE(record.typical_year);
  REQUIRE(record.rows.size() == 2);
  const WeatherRow& first = record.rows[0];
  CHECK(first.line == 8);
  CHECK(utc_text(first.utc_s) == "2026-06-21T16:00Z");
  // 2026-06-21 is day 20,625 since 1970: 56 years of which 14 leap, then 171 days.
  CHECK(first.utc_s == 20625.0 * 86400.0 + 16.0 * 3600.0);
  CHECK(first[Q::air_temperature_k] == Approx(298.65).epsilon(rounding));
  CHECK(first[Q::relative_humidity_percent] == 100.0);  // fog in the sensor
  CHECK(first[Q::pressure_hpa] == Approx(980.0).epsilon(rounding));
  CHECK(first[Q::wind_speed_m_s] == 3.5);
  CHECK(first[Q::cloud_fraction] == Approx(0.4).epsilon(rounding));
  CHECK(std::isnan(first[Q::direct_normal_w_m2]));
  CHECK(std::isnan(record.rows[1][Q::air_temperature_k]));  // an empty cell
  CHECK(record.rows[1][Q::global_horizontal_w_m2] == 0.0);  // an instrument at night
}

TEST_CASE("local times of a CSV are shifted by their offset", "[sim][weather]") {
  const auto first_time = [](const std::string& text) {
    return utc_text(parse_weather_csv(text, "w.csv").rows.at(0).utc_s);
  };
  CHECK(first_time("# utc_offset_h: -5\nlocal,air_temperature_k\n2026-06-21T16:00,300\n") ==
        "2026-06-21T21:00Z");
  CHECK(first_time("# utc_offset_h: +5.5\nlocal,air_temperature_k\n2026-06-21 02:00:30,300\n") ==
        "2026-06-20T20:30:30Z");
  CHECK(first_time("local,utc_offset_h,air_temperature_k\n2026-06-21T16:00,2,300\n") ==
        "2026-06-21T14:00Z");
}

// The first two rows and the last of the first day of NREL's 723170TYA.CSV (public domain), of all
// its 71 columns.
const std::string tmy3_text =
    "723170,\"GREENSBORO PIEDMONT TRIAD INT\",NC,-5.0,36.100,-79.950,273\n"
    "Date (MM/DD/YYYY),Time (HH:MM),ETR (W/m^2),ETRN (W/m^2),GHI (W/m^2),GHI source,GHI uncert (%),"
    "DNI (W/m^2),DNI source,DNI uncert (%),DHI (W/m^2),DHI source,DHI uncert (%),GH illum (lx),"
    "GH illum source,Global illum uncert (%),DN illum (lx),DN illum source,DN illum uncert (%),"
    "DH illum (lx),DH illum source,DH illum uncert (%),Zenith lum (cd/m^2),Zenith lum source,"
    "Zenith lum uncert (%),TotCld (tenths),TotCld source,TotCld uncert (code),OpqCld (tenths),"
    "OpqCld source,OpqCld uncert (code),Dry-bulb (C),Dry-bulb source,Dry-bulb uncert (code),"
    "Dew-point (C),Dew-point source,Dew-point uncert (code),RHum (%),RHum source,RHum uncert "
    "(code),"
    "Pressure (mbar),Pressure source,Pressure uncert (code),Wdir (degrees),Wdir source,"
    "Wdir uncert (code),Wspd (m/s),Wspd source,Wspd uncert (code),Hvis (m),Hvis source,"
    "Hvis uncert (code),CeilHgt (m),CeilHgt source,CeilHgt uncert (code),Pwat (cm),Pwat source,"
    "Pwat uncert (code),AOD (unitless),AOD source,AOD uncert (code),Alb (unitless),Alb source,"
    "Alb uncert (code),Lprecip depth (mm),Lprecip quantity (hr),Lprecip source,"
    "Lprecip uncert (code),PresWth (METAR code),PresWth source,PresWth uncert (code)\n"
    "01/01/1988,12:00,696,1415,261,1,9,3,1,9,260,1,13,290,1,9,3,1,9,289,1,13,917,1,18,10,A,7,10,A,"
    "7,11.7,A,7,10.6,A,7,93,A,7,992,A,7,230,A,7,5.2,A,7,9700,B,7,1070,A,7,2.0,E,8,0.000,F,8,0.00,?,"
    "0,0,1,D,9,45,C,8\r\n"
    "01/01/1988,24:00,0,0,0,1,0,0,1,0,0,1,0,0,1,0,0,1,0,0,1,0,0,1,0,10,A,7,10,A,7,5.0,A,7,2.2,A,7,"
    "83,A,7,996,A,7,40,A,7,2.1,A,7,12900,B,7,1070,A,7,1.2,E,8,0.000,?,0,0.00,?,0,5,1,D,9,00,C,8\n";

TEST_CASE("TMY3 is read as NREL ships it", "[sim][weather]") {
  const WeatherRecord record = parse_weather_tmy3(tmy3_text, "t.csv");
  CHECK(record.station.name == "GREENSBORO PIEDMONT TRIAD INT");
  CHECK(record.station.latitude_deg == 36.1);
  CHECK(record.station.longitude_deg == -79.95);
  CHECK(record.station.height_m == 273.0);
  CHECK(record.utc_offset_s == -18000.0);
  CHECK(record.radiation_mean_s == 3600.0);
  CHECK(record.typical_year);
  REQUIRE(record.rows.size() == 2);
  const WeatherRow& noon = record.rows[0];
  CHECK(utc_text(noon.utc_s) == "1988-01-01T17:00Z");
  CHECK(noon[Q::global_horizontal_w_m2] == 261.0);
  CHECK(noon[Q::direct_normal_w_m2] == 3.0);
  CHECK(noon[Q::diffuse_horizontal_w_m2] == 260.0);
  CHECK(noon[Q::cloud_fraction] == Approx(1.0).epsilon(rounding));
  CHECK(noon[Q::air_temperature_k] == Approx(284.85).epsilon(rounding));
  CHECK(noon[Q::dew_point_k] == Approx(283.75).epsilon(rounding));
  CHECK(noon[Q::relative_humidity_percent] == 93.0);
  CHECK(noon[Q::pressure_hpa] == 992.0);
  CHECK(noon[Q::wind_speed_m_s] == 5.2);
  // 24:00 is the end of its own day.
  CHECK(utc_text(record.rows[1].utc_s) == "1988-01-02T05:00Z");
  const PlaceInYear last = place_in_year(record, record.rows[1]);
  CHECK(last.month == 1);
  CHECK(last.day == 1);
  CHECK(last.second == 86400.0);
}

TEST_CASE("TMY3 with fewer columns and a remark behind the station is read too", "[sim][weather]") {
  const std::filesystem::path file =
      std::filesystem::path{NADIR_SOURCE_DIR} / "tests/sim/data/greensboro_two_days.csv";
  const WeatherRecord record = parse_weather(read_bytes(file), file.string(), std::nullopt);
  CHECK(record.station.height_m == 273.0);
  REQUIRE(record.rows.size() == 48);
  CHECK(record.rows[13][Q::direct_normal_w_m2] == 311.0);  // 08/05/2001,14:00
  CHECK(record.rows[13][Q::diffuse_horizontal_w_m2] == 395.0);
  CHECK(std::isnan(record.rows[13][Q::sky_long_wave_w_m2]));
}

TEST_CASE("EPW is read with its codes for missing values", "[sim][weather]") {
  const support::EpwDay day;
  const WeatherRecord record = parse_weather_epw(support::epw_header() + support::epw_row(day, 1) +
                                                     support::epw_row(day, 12, "99.9", "9999") +
                                                     support::epw_row(day, 24, "-3.5", "0"),
                                                 "t.epw");
  CHECK(record.station.name == "Somewhere");
  CHECK(record.station.latitude_deg == 36.1);
  CHECK(record.station.height_m == 273.0);
  CHECK(record.utc_offset_s == -18000.0);
  CHECK(record.radiation_mean_s == 3600.0);
  CHECK(record.typical_year);
  REQUIRE(record.rows.size() == 3);
  const WeatherRow& noon = record.rows[1];
  CHECK(utc_text(noon.utc_s) == "2001-06-20T17:00Z");  // hour 12 ends at 12:00
  CHECK(std::isnan(noon[Q::air_temperature_k]));
  CHECK(std::isnan(noon[Q::sky_long_wave_w_m2]));
  CHECK(noon[Q::dew_point_k] == Approx(288.15).epsilon(rounding));
  CHECK(noon[Q::pressure_hpa] == Approx(980.0).epsilon(rounding));
  CHECK(noon[Q::wind_speed_m_s] == 3.1);
  CHECK(noon[Q::cloud_fraction] == Approx(0.5).epsilon(rounding));
  CHECK(noon[Q::global_horizontal_w_m2] == support::made_sunlight(11.5));
  CHECK(noon[Q::direct_normal_w_m2] ==
        Approx(0.5 * support::made_sunlight(11.5)).epsilon(rounding));
  CHECK(noon[Q::diffuse_horizontal_w_m2] ==
        Approx(0.4 * support::made_sunlight(11.5)).epsilon(rounding));
  CHECK(record.rows[0][Q::sky_long_wave_w_m2] == 350.0);
  CHECK(std::isnan(record.rows[2][Q::sky_long_wave_w_m2]));  // 0: no converter had any
}

TEST_CASE("EPW with several records an hour goes by its minutes", "[sim][weather]") {
  const support::EpwDay day;
  std::string half = support::epw_row(day, 1);
  half.replace(half.find(",60,"), 4, ",30,");
  const WeatherRecord record =
      parse_weather_epw(support::epw_header("LOCATION,A,-,-,-,0,50.0,8.0,1.0,100", "2") + half +
                            support::epw_row(day, 1),
                        "t.epw");
  CHECK(record.radiation_mean_s == 1800.0);
  CHECK(utc_text(record.rows[0].utc_s) == "2001-06-19T23:30Z");
  CHECK(utc_text(record.rows[1].utc_s) == "2001-06-20T00:00Z");
}

TEST_CASE("SURFRAD is read with its flags of quality", "[sim][weather]") {
  using support::surfrad_row;
  const WeatherRecord record = parse_weather_surfrad(
      support::surfrad_header() + surfrad_row({2010, 171, 6, 20, 0}, -2.1, 21.3) +
          surfrad_row({2010, 171, 6, 20, 1}, 640.0, 21.4) +
          surfrad_row({2010, 171, 6, 20, 2}, 640.0, -9999.9, "2"),
      "bon10171.dat");
  CHECK(record.station.name == "Bondville");
  CHECK(record.station.latitude_deg == 40.05);
  CHECK(record.station.longitude_deg == -88.37);
  CHECK(record.station.height_m == 213.0);
  CHECK(record.radiation_mean_s == 60.0);
  CHECK_FALSE(record.typical_year);
  REQUIRE(record.rows.size() == 3);
  const WeatherRow& row = record.rows[1];
  CHECK(utc_text(row.utc_s) == "2010-06-20T00:01Z");
  CHECK(record.rows[0][Q::global_horizontal_w_m2] == 0.0);
  CHECK(row[Q::global_horizontal_w_m2] == 640.0);
  CHECK(row[Q::direct_normal_w_m2] == 480.0);
  CHECK(row[Q::diffuse_horizontal_w_m2] == 160.0);
  CHECK(row[Q::sky_long_wave_w_m2] == 380.5);
  CHECK(row[Q::air_temperature_k] == Approx(294.55).epsilon(rounding));
  CHECK(row[Q::relative_humidity_percent] == 60.0);
  CHECK(row[Q::wind_speed_m_s] == 3.5);
  CHECK(row[Q::pressure_hpa] == Approx(990.2).epsilon(rounding));
  CHECK(std::isnan(record.rows[2][Q::global_horizontal_w_m2]));  // flagged
  CHECK(std::isnan(record.rows[2][Q::air_temperature_k]));       // missing
}

TEST_CASE("SURFRAD's other days are named by station, year and day of the year", "[sim][weather]") {
  const long new_year = *days_of(2010, 1, 1);
  CHECK(surfrad_file_of_day("data/bon10171.dat", new_year)->string() == "data/bon10001.dat");
  CHECK(surfrad_file_of_day("bon10001.dat", new_year - 1)->string() == "bon09365.dat");
  CHECK(surfrad_file_of_day("bon08366.dat", *days_of(2008, 2, 29))->string() == "bon08060.dat");
  CHECK_FALSE(surfrad_file_of_day("bon10001.dat", new_year));  // itself
  CHECK_FALSE(surfrad_file_of_day("weather.dat", new_year));
}

TEST_CASE("the format of weather shows in its first lines", "[sim][weather]") {
  const auto layout = [](const std::string& text) { return weather_layout_of(text, "w"); };
  CHECK(layout(csv_text) == WeatherLayout::csv);
  CHECK(layout(tmy3_text) == WeatherLayout::tmy3);
  CHECK(layout(support::epw_header()) == WeatherLayout::epw);
  CHECK(layout(support::surfrad_header()) == WeatherLayout::surfrad);
  CHECK(layout("\xEF\xBB\xBF"
               "local,air_temperature_k\n1,2\n") == WeatherLayout::csv);
}

}  // namespace
}  // namespace nadir::sim
