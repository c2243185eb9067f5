#include <cmath>
#include <filesystem>
#include <string>

#include "core/constants.hpp"
#include "sim/run/file_weather.hpp"
#include "sim/run/file_weather_derive.hpp"
#include "sim/weather_loading.hpp"
#include "support/catch.hpp"
#include "thermal/surface/humidity.hpp"
#include "thermal/weather/sky_long_wave.hpp"

namespace nadir::sim {
namespace {

using support::at_greensboro;
using support::at_zero;
using support::Files;
using support::greensboro;
using support::hourly_csv;
using support::load;
using support::Loaded;
using support::named;
using support::place_lines;

TEST_CASE("a typical year stands in for the year of the picture", "[sim][weather]") {
  const Loaded found = load(at_greensboro("2023-08-06T17:00:00Z"), named(greensboro), 24.0);
  CHECK(found.warnings.empty());
  CHECK(found.files.count(greensboro) == 1);
  CHECK_NOTHROW(thermal::check(found.weather));
  CHECK(found.weather.first_s() <= -86400.0);
  CHECK(found.weather.last_s() >= 0.0);
  // 08/06/2001,12:00: 28.9 C, dew point 18.9 C, 992 mbar, 2.1 m/s. Sums only: 1e-12.
  const thermal::WeatherState now = found.weather.at(0.0);
  CHECK(now.air_temperature_k == Approx(302.05).epsilon(1e-12));
  CHECK(now.pressure_hpa == Approx(992.0).epsilon(1e-12));
  CHECK(now.wind_speed_m_s == Approx(2.1).epsilon(1e-12));
  const double vapour = thermal::vapour_pressure_of_dew_point_hpa(292.05);
  CHECK(now.vapour_pressure_hpa == Approx(vapour).epsilon(1e-12));
  CHECK(vapour == Approx(21.8).epsilon(0.005));  // Smithsonian tables: 21.83 hPa at 18.9 C
  CHECK(now.sky_long_wave_w_m2 ==
        Approx(thermal::sky_long_wave_w_m2(
                   {thermal::ClearSkyFormula::prata, thermal::CloudFormula::unsworth_monteith},
                   {302.05, vapour, 0.5}))
            .epsilon(1e-12));
  // Half past nine lies within 10:00's hour (5.5 h before): direct 546 between 546 and 628 of its
  // neighbours, so that the middle of the hour is (2 x 546 - (546 + 587) / 2).
  CHECK(found.weather.at(-2.5 * 3600.0).direct_normal_w_m2 == Approx(525.5).epsilon(1e-9));
  // Night.
  CHECK(found.weather.at(-12.0 * 3600.0).direct_normal_w_m2 == 0.0);
  CHECK(found.weather.at(-12.0 * 3600.0).diffuse_horizontal_w_m2 == 0.0);
}

TEST_CASE("a typical year wraps over new year", "[sim][weather]") {
  Files files;
  std::string text = support::epw_header("LOCATION,A,-,-,-,0,10.0,0.0,0.0,100");
  for (int hour = 1; hour <= 24; ++hour) {
    text += support::epw_row({1999, 1, 1}, hour, std::to_string(hour));
  }
  for (int hour = 1; hour <= 24; ++hour) {
    text += support::epw_row({1985, 12, 31}, hour, std::to_string(-hour));
  }
  const auto file = files.write("a.epw", text);
  Scenario tropics = at_zero("2026-01-01T18:00:00Z");  // lit from 6 to 18
  tropics.origin.latitude_deg = 10.0;
  const Loaded found = load(tropics, named(file), 36.0);
  CHECK(found.weather.at(0.0).air_temperature_k == Approx(291.15).epsilon(1e-12));  // 18 C
  // Hour 24 of December 31 is midnight of new year: -24 C; an hour later 1 C.
  CHECK(found.weather.at(-18.0 * 3600.0).air_temperature_k == Approx(249.15).epsilon(1e-12));
  CHECK(found.weather.at(-17.5 * 3600.0).air_temperature_k == Approx(261.65).epsilon(1e-12));
  CHECK(found.weather.at(-36.0 * 3600.0).air_temperature_k == Approx(267.15).epsilon(1e-12));
  // The file's own long-wave, the mean of the hour before.
  CHECK(found.weather.at(0.0).sky_long_wave_w_m2 == Approx(350.0).epsilon(1e-12));
}

TEST_CASE("a leap day that a typical year does not have is its 28th again", "[sim][weather]") {
  Files files;
  std::string text = support::epw_header("LOCATION,A,-,-,-,0,45.0,0.0,0.0,100");
  for (int hour = 1; hour <= 24; ++hour) {
    text += support::epw_row({1999, 2, 28}, hour, std::to_string(hour));
  }
  for (int hour = 1; hour <= 24; ++hour) text += support::epw_row({1999, 3, 1}, hour, "30");
  const auto file = files.write("a.epw", text);
  const Loaded found = load(at_zero("2024-03-01T12:00:00Z"), named(file), 24.0);
  CHECK(found.weather.at(-24.0 * 3600.0).air_temperature_k == Approx(285.15).epsilon(1e-12));
  CHECK(files.plain(found.warnings) ==
        "a.epw: the weather has no 29 February: its 28th is taken again\n");
}

TEST_CASE("weather must cover the hours before the picture", "[sim][weather]") {
  Files files;
  const auto file = files.write("w.csv", hourly_csv());
  CHECK(files.message(at_zero(), named(file), 24.0) == "(nothing thrown)");
  CHECK(files.message(at_zero("2025-06-21T18:00:00Z"), named(file), 24.0) ==
        "scene.xml:3:5: error: the weather of w.csv does not cover the hours before the picture: "
        "needed are 2025-06-20T18:00Z to 2025-06-21T18:00Z, the file has 2026-06-20T00:00Z to "
        "2026-06-22T00:00Z\n");
  CHECK(files.message(at_zero(), named(file), 48.0).find("needed are 2026-06-19T18:00Z") !=
        std::string::npos);
  WeatherFileInput any_year = named(file);
  any_year.any_year = true;
  CHECK(files.message(at_zero("2025-06-21T18:00:00Z"), any_year, 24.0) == "(nothing thrown)");
  // A typical year by its real dates.
  WeatherFileInput real = named(greensboro);
  real.any_year = false;
  CHECK(files.message(at_greensboro("2001-08-06T17:00:00Z"), real, 24.0) == "(nothing thrown)");
  CHECK(files.message(at_greensboro("2023-08-06T17:00:00Z"), real, 24.0)
            .find("the file has 2001-08-05T06:00Z to 2001-08-07T05:00Z") != std::string::npos);
}

TEST_CASE("gaps of weather are bridged up to three hours and told", "[sim][weather]") {
  Files files;
  const auto small = files.write("small.csv", hourly_csv(0, 30, 31));
  CHECK(files.plain(load(at_zero(), named(small), 24.0).warnings) ==
        "small.csv:34: a gap in the weather is bridged: nothing for 3.0 h after line 33, "
        "from 2026-06-21T05:00Z to 2026-06-21T08:00Z\n");
  const auto large = files.write("large.csv", hourly_csv(0, 30, 33));
  CHECK(files.message(at_zero(), named(large), 24.0) ==
        "large.csv:34:1: error: a gap in the weather: nothing for 5.0 h after line 33, from "
        "2026-06-21T05:00Z to 2026-06-21T10:00Z; at most 3 h are bridged\n");
  // A gap before the hours that are needed is none.
  CHECK(files.message(at_zero(), named(large), 8.0) == "(nothing thrown)");
}

TEST_CASE("missing values are bridged or located", "[sim][weather]") {
  Files files;
  const auto without_wind = [&](int from, int to) {
    std::string text = hourly_csv();
    for (int hour = from; hour <= to; ++hour) {
      const std::string start =
          fmt::format("2026-06-{:02d}T{:02d}:00Z,{},-1,", 20 + hour / 24, hour % 24, hour);
      text.erase(text.find(start) + start.size(), 1);
    }
    return files.write("wind.csv", text);
  };
  const Loaded bridged = load(at_zero(), named(without_wind(30, 31)), 24.0);
  CHECK(files.plain(bridged.warnings) ==
        "wind.csv:34: wind speed is missing here and in 1 more rows and bridged\n");
  CHECK(bridged.weather.at(-11.5 * 3600.0).wind_speed_m_s == Approx(2.0).epsilon(1e-12));
  CHECK(files.message(at_zero(), named(without_wind(30, 33)), 24.0) ==
        "wind.csv:34:1: error: wind speed is missing for 5.0 h, in lines 34 to 37 "
        "(2026-06-21T06:00Z to 2026-06-21T09:00Z); at most 3 h are bridged\n");
  CHECK(files.message(at_zero(), named(without_wind(0, 48)), 24.0) ==
        "wind.csv: error: the weather has no wind speed: expected wind speed\n");
}

TEST_CASE("weather of another place is refused or told", "[sim][weather]") {
  Files files;
  const auto place = [](const std::string& lat, const std::string& lon, const std::string& height) {
    return "# station: Roof\n# latitude_deg: " + lat + "\n# longitude_deg: " + lon +
           "\n# height_m: " + height + "\n";
  };
  const auto south = files.write("w.csv", hourly_csv(0, 1000, 0, place("-45", "0", "0")));
  CHECK(files.message(at_zero(), named(south), 24.0) ==
        "w.csv:1:1: error: Roof lies at latitude -45, the scene at 45: on the other hemisphere\n");
  const auto far = files.write("w.csv", hourly_csv(0, 1000, 0, place("48", "0", "900")));
  CHECK(files.plain(load(at_zero(), named(far), 24.0).warnings) ==
        "w.csv: Roof lies 334 km from the scene\n"  // 3 degrees of 111.2 km
        "w.csv: Roof lies at 900 m, the scene at 0 m\n");
  const auto near = files.write("w.csv", hourly_csv(0, 1000, 0, place("46", "0", "400")));
  CHECK(load(at_zero(), named(near), 24.0).warnings.empty());
}

TEST_CASE("sunlight at night gives a wrong time zone away", "[sim][weather]") {
  Files files;
  const auto early = files.write("w.csv", hourly_csv(-5));
  CHECK(files.message(at_zero(), named(early), 24.0) ==
        "w.csv:7:1: error: sunlight of 480 W/m2 at 2026-06-20T03:00Z while the sun stands 10 "
        "degrees below the horizon of the scene: the times look 5 h early; the file's times are "
        "taken as UTC\n");
  const auto late = files.write("w.csv", hourly_csv(6));
  CHECK(files.message(at_zero(), named(late), 24.0).find("the times look 6 h late") !=
        std::string::npos);
  // Where there is no night, the middle of the light tells.
  Scenario polar = at_zero();
  polar.origin = {75.0, 0.0, 0.0};
  const auto there = files.write("w.csv", hourly_csv(6, 1000, 0, place_lines("75")));
  CHECK(files.plain(load(polar, named(there), 24.0).warnings) ==
        "w.csv:4: the centre of the sunlight lies 6.0 h after noon at the scene: the "
        "times look 6 h late; the file's times are taken as UTC\n");
}

TEST_CASE("sunlight is made direct and diffuse from what there is", "[sim][weather]") {
  Files files;
  const auto state = [&](const std::string& columns, const std::string& values) {
    std::string text =
        "utc,air_temperature_c,relative_humidity_percent,wind_speed_m_s,"
        "cloud_fraction," +
        columns + "\n";
    for (int hour = 9; hour <= 15; ++hour) {
      text += fmt::format("2026-06-21T{:02d}:00Z,20,50,2,0,{}\n", hour, values);
    }
    const auto file = files.write("w.csv", text);
    return load(at_zero("2026-06-21T12:00:00Z"), named(file), 2.0).weather.at(0.0);
  };
  // The sun's height at noon of the solstice, 45 degrees north, longitude 0: cos(45 - 23.44
  // degrees) = 0.930; the equation of time, 2 minutes, changes it by 3e-5.
  constexpr double cosine = 0.9300;
  const auto two = state("global_horizontal_w_m2,diffuse_horizontal_w_m2", "850,106");
  CHECK(two.direct_normal_w_m2 == Approx(744.0 / cosine).epsilon(1e-3));
  CHECK(two.diffuse_horizontal_w_m2 == Approx(106.0).epsilon(1e-12));
  const auto other = state("global_horizontal_w_m2,direct_normal_w_m2", "850,800");
  CHECK(other.diffuse_horizontal_w_m2 == Approx(850.0 - 800.0 * cosine).epsilon(1e-3));
  const auto whole = state("global_horizontal_w_m2", "850");
  CHECK(whole.direct_normal_w_m2 * cosine + whole.diffuse_horizontal_w_m2 ==
        Approx(850.0).epsilon(1e-4));
  CHECK(whole.direct_normal_w_m2 > 600.0);
  // No pressure in the file: the standard atmosphere at the scene's height.
  CHECK(whole.pressure_hpa == Approx(1013.25).epsilon(1e-12));
  CHECK(files.message(at_zero("2026-06-21T12:00:00Z"),
                      named(files.write("w.csv",
                                        "utc,air_temperature_c\n2026-06-21T09:00Z,20\n"
                                        "2026-06-21T12:00Z,20\n")),
                      2.0) ==
        "w.csv: error: the weather has no humidity: expected dew point, relative humidity or "
        "vapour pressure\n"
        "w.csv: error: the weather has no wind speed: expected wind speed\n"
        "w.csv: error: the weather has no direct sunlight: expected direct normal or global "
        "horizontal radiation\n"
        "w.csv: error: the weather has no diffuse sunlight: expected diffuse or global horizontal "
        "radiation\n"
        "w.csv: error: the weather has no long-wave radiation of the sky: expected long-wave "
        "radiation, or temperature and humidity\n");
}

TEST_CASE("the sky's long-wave radiation is made where the file has none", "[sim][weather]") {
  Files files;
  const auto sky = [&](const std::string& cloud, SkyLongWave choice, std::string& told) {
    std::string text = place_lines("45") +
                       "utc,air_temperature_k,dew_point_c,wind_speed_m_s,global_horizontal_w_m2" +
                       std::string{cloud.empty() ? "" : ",cloud_fraction"} + "\n";
    for (int hour = 9; hour <= 15; ++hour) {
      text += fmt::format("2026-06-21T{:02d}:00Z,290,10,2,500{}\n", hour, cloud);
    }
    WeatherFileInput input = named(files.write("w.csv", text));
    input.long_wave = choice;
    const Loaded found = load(at_zero("2026-06-21T12:00:00Z"), input, 2.0);
    told = files.plain(found.warnings);
    return found.weather.at(0.0).sky_long_wave_w_m2;
  };
  std::string told;
  // Swinbank's 5.31e-13 T^6 at 290 K: 315.85 W/m2.
  CHECK(sky("", SkyLongWave::swinbank, told) == Approx(315.85).epsilon(1e-4));
  CHECK(told ==
        "w.csv: 7 of 7 rows have neither long-wave radiation of the sky nor clouds: the "
        "sky is taken for clear\n");
  // An overcast sky: 0.84 + 0.16 of the clear one's; black at 290 K: 401.06 W/m2.
  CHECK(sky(",1", SkyLongWave::swinbank, told) ==
        Approx(0.84 * 401.06 + 0.16 * 315.85).epsilon(1e-4));
  CHECK(told.empty());
  // Brutsaert: 1.24 (12.27 hPa / 290 K)^(1/7) = 0.789.
  CHECK(sky(",0", SkyLongWave::brutsaert, told) == Approx(0.789 * 401.06).epsilon(2e-3));
}

TEST_CASE("the sky of the scenario's air lends its emissivity", "[sim][weather]") {
  const auto black = [](double t) { return si::stefan_boltzmann * t * t * t * t; };
  thermal::Weather clear;  // emissivity 0.75 at 280 K
  for (thermal::TimeSeries* series :
       {&clear.air_temperature_k, &clear.vapour_pressure_hpa, &clear.pressure_hpa,
        &clear.wind_speed_m_s, &clear.direct_normal_w_m2, &clear.diffuse_horizontal_w_m2}) {
    *series = {{0.0}, {280.0}};
  }
  clear.sky_long_wave_w_m2 = {{0.0}, {0.75 * black(280.0)}};
  WeatherRecord record;
  record.files.emplace_back("w.csv");
  WeatherRow row;
  row[WeatherQuantity::air_temperature_k] = 300.0;
  row[WeatherQuantity::vapour_pressure_hpa] = 12.0;
  row[WeatherQuantity::cloud_fraction] = 0.5;
  const SunHeights sun{
      ephemeris::Instant::parse_utc("1970-01-01T00:00:00Z"), {}, -86400.0, 86400.0};
  WeatherView view;
  view.sun = &sun;
  view.sky.clear = &clear;
  Diagnostics diagnostics;
  // Half the sky covered: (1 - 0.42) 0.75 + 0.42. A sum of products: 1e-12.
  CHECK(derive(record, {row}, view, diagnostics).at(0).state.sky_long_wave_w_m2 ==
        Approx((0.58 * 0.75 + 0.42) * black(300.0)).epsilon(1e-12));
  row[WeatherQuantity::vapour_pressure_hpa] = no_weather_value;
  CHECK(std::isnan(derive(record, {row}, view, diagnostics).at(0).state.sky_long_wave_w_m2));
}

TEST_CASE("days of SURFRAD are read from the files beside the one that is named",
          "[sim][weather]") {
  Files files;
  const auto day = [&](int day_of_year, int date, double temperature) {
    std::string text = support::surfrad_header();
    for (int minute = 0; minute < 1440; minute += 3) {
      // Bondville's noon is at 17:55 UTC.
      const double light = support::made_sunlight(std::fmod(minute / 60.0 + 18.1, 24.0));
      text += support::surfrad_row({2010, day_of_year, 6, date, minute}, light, temperature);
    }
    return files.write(fmt::format("bon10{}.dat", day_of_year), text);
  };
  const auto first = day(171, 20, 20.0);
  const auto named_one = day(172, 21, 22.0);
  Scenario scenario = at_greensboro("2010-06-21T20:00:00Z");
  scenario.origin = {40.05, -88.37, 213.0};
  const Loaded found = load(scenario, named(named_one), 24.0);
  CHECK(found.warnings.empty());
  CHECK(found.files.count(first) == 1);
  CHECK(found.files.count(named_one) == 1);
  CHECK(found.weather.at(0.0).air_temperature_k == Approx(295.15).epsilon(1e-12));
  CHECK(found.weather.at(-23.5 * 3600.0).air_temperature_k == Approx(293.15).epsilon(1e-12));
  CHECK(found.weather.at(-3600.0).sky_long_wave_w_m2 == Approx(380.5).epsilon(1e-12));
  // Three-minute rows are joined into the steps of the heat balance.
  CHECK(found.weather.air_temperature_k.time_s.size() < 200);
  // From midnight of the first day, and the three minutes before that; a second is slack.
  constexpr double more_h = 181.0 / 3600.0;
  CHECK(support::reach_h(scenario, named(named_one)) == Approx(44.0 + more_h).margin(1e-6));
  std::filesystem::remove(first);
  CHECK(support::reach_h(scenario, named(named_one)) == Approx(20.0 + more_h).margin(1e-6));
  CHECK(files.message(scenario, named(named_one), 24.0) ==
        "scene.xml:3:5: error: the weather of bon10172.dat does not cover the hours before the "
        "picture: needed are 2010-06-20T20:00Z to 2010-06-21T20:00Z, the file has "
        "2010-06-21T00:00Z to 2010-06-21T23:57Z\n");
}

}  // namespace
}  // namespace nadir::sim
