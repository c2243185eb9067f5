#include <cmath>
#include <limits>
#include <string>

#include "sim/run/file_weather_check.hpp"
#include "sim/weather_loading.hpp"
#include "support/catch.hpp"
#include "thermal/surface/humidity.hpp"

// Weather that cannot be, and weather that just reaches.

namespace nadir::sim {
namespace {

using support::at_zero;
using support::Files;
using support::load;
using support::Loaded;
using support::named;
using support::place_lines;

/// Steady weather at 45 degrees north and longitude 0 between two hours from 2026-06-20T00:00Z on;
/// the sun's hours alternate in brightness.
struct Steady {
  double from_h = 0.0, to_h = 72.0, step_h = 1.0;
  int mean_s = 0;
  std::string air_c = "20", humidity = "dew_point_c", damp = "10";
  double dark_from_h = 1000.0, dark_to_h = 0.0;
  std::string place = place_lines("45");
  double no_wind_at_h = -1.0;

  [[nodiscard]] std::string text() const {
    std::string text = place + fmt::format("# radiation_mean_s: {}\n", mean_s) +
                       "utc,air_temperature_c," + humidity +
                       ",wind_speed_m_s,direct_normal_w_m2,diffuse_horizontal_w_m2,"
                       "sky_long_wave_w_m2\n";
    const int rows = static_cast<int>(std::lround((to_h - from_h) / step_h));
    for (int i = 0; i <= rows; ++i) text += row(from_h + step_h * i);
    return text;
  }
  [[nodiscard]] std::string row(double hour) const {
    const auto minute = static_cast<int>(std::lround(60.0 * hour));
    const bool dark = hour >= dark_from_h && hour <= dark_to_h;
    const double light =
        dark ? 0.0 : support::made_sunlight(std::fmod(hour - mean_s / 7200.0, 24.0));
    return fmt::format("2026-06-{:02d}T{:02d}:{:02d}Z,{},{},{},{:g},{:g},{}\n", 20 + minute / 1440,
                       minute / 60 % 24, minute % 60, air_c, damp, hour == no_wind_at_h ? "" : "2",
                       light, 0.2 * light, 300 + minute % 50);
  }
};

std::string said_weather_plausible(const Scenario& scenario, const Steady& steady,
                                   double hours = 24.0) {
  Files files;
  return files.message(scenario, named(files.write("w.csv", steady.text())), hours);
}
std::string told_weather_plausible(const Scenario& scenario, const Steady& steady,
                                   double hours = 24.0) {
  Files files;
  return files.plain(load(scenario, named(files.write("w.csv", steady.text())), hours).warnings);
}

TEST_CASE("air that would hold more vapour than it can is refused", "[sim][weather]") {
  Steady damp;
  // 33 C: 50.3 hPa, 20 C: 23.4 hPa (Magnus). Rows from 20 h to 46 h of the file are looked at,
  // four hours about those needed: hour 14 is the file's line 19.
  damp.damp = "33";
  CHECK(said_weather_plausible(at_zero(), damp) ==
        "w.csv:19:1: error: dew point of 33.0 C in air of 20.0 C, here and in 32 more rows, is a "
        "relative humidity of 215 %: expected at most 110 %\n");
  damp.humidity = "vapour_pressure_hpa";
  damp.damp = "26";
  CHECK(said_weather_plausible(at_zero(), damp) ==
        "w.csv:19:1: error: vapour pressure of 26.0 hPa in air of 20.0 C, here and in 32 more "
        "rows, is a relative humidity of 111 %: expected at most 110 %\n");
  // Of rows that are not needed nothing is said.
  Steady later;
  later.to_h = 44.0;
  CHECK(said_weather_plausible(at_zero(), later) == "(nothing thrown)");
  Files files;
  later.damp = "33";
  later.from_h = 47.0;
  later.to_h = 48.0;
  Steady sound;
  sound.to_h = 46.0;
  const std::string rest = later.row(47.0) + later.row(48.0);
  CHECK(files.message(at_zero(), named(files.write("w.csv", sound.text() + rest)), 24.0) ==
        "(nothing thrown)");
}

TEST_CASE("air a little above saturation is saturated", "[sim][weather]") {
  Files files;
  Steady fog;
  fog.damp = "21";  // 106 %
  const Loaded found = load(at_zero(), named(files.write("w.csv", fog.text())), 24.0);
  // The same formula: 1e-12.
  CHECK(found.weather.at(-3600.0).vapour_pressure_hpa ==
        Approx(thermal::saturation_over_water_hpa(293.15)).epsilon(1e-12));
  fog.damp = "19.9";
  const Loaded below = load(at_zero(), named(files.write("w.csv", fog.text())), 24.0);
  CHECK(below.weather.at(-3600.0).vapour_pressure_hpa ==
        Approx(thermal::vapour_pressure_of_dew_point_hpa(293.05)).epsilon(1e-12));
}

TEST_CASE("weather without a place is told", "[sim][weather]") {
  Steady nowhere;
  nowhere.place = "";
  CHECK(told_weather_plausible(at_zero(), nowhere) ==
        "w.csv: the weather does not say where it was measured (latitude_deg): whether it is of "
        "the scene's place and hemisphere is not checked\n");
  nowhere.place = "# latitude_deg: 46\n";
  CHECK(told_weather_plausible(at_zero(), nowhere) ==
        "w.csv: the weather does not say where it was measured (longitude_deg): whether it is of "
        "the scene's place is not checked\n");
  nowhere.place = "# latitude_deg: -45\n";
  CHECK(said_weather_plausible(at_zero(), nowhere) ==
        "w.csv:1:1: error: the station lies at latitude -45, the scene at 45: on the other "
        "hemisphere\n");
}

TEST_CASE("air that its latitude does not know at that time of the year is told",
          "[sim][weather]") {
  Steady cold;
  cold.air_c = "-30";
  cold.damp = "-35";
  // -31.5 - 28 / 4 + 25.5 x 0.707 x 0.91 = -22.1; 57 - 7 + 10.0 = 60.
  CHECK(told_weather_plausible(at_zero(), cold) ==
        "w.csv:23: air of -30.0 C, here and in 24 more rows, at latitude 45.0 at this time of the "
        "year: nothing outside -22 to 60 C is known; is it the weather of another place or "
        "season?\n");
  cold.air_c = "-15";
  CHECK(told_weather_plausible(at_zero(), cold).empty());
}

TEST_CASE("records of air temperature lie within its limits", "[sim][weather]") {
  struct Extreme {
    const char* what;
    const char* utc;
    double latitude_deg, height_m, air_c;
  };
  // World Meteorological Organization, archive of weather and climate extremes (wmo.asu.edu), but
  // for Snag, Rogers Pass and Sunndalsora: their national services.
  // The season counts, not the year: the ephemeris knows no 1892.
  const Extreme extremes[] = {
      {"Vostok", "1983-07-21T00:00:00Z", -78.5, 3420.0, -89.2},
      {"Klinck", "1991-12-22T00:00:00Z", 72.3, 3105.0, -69.6},
      {"Verkhoyansk", "2000-02-05T00:00:00Z", 67.55, 107.0, -67.8},
      {"Oymyakon", "1933-02-06T00:00:00Z", 63.25, 800.0, -67.8},
      {"Snag", "1947-02-03T00:00:00Z", 62.4, 646.0, -63.0},
      {"Rogers Pass", "1954-01-20T00:00:00Z", 47.1, 1667.0, -56.7},
      {"Sarmiento", "1907-06-01T00:00:00Z", -45.6, 268.0, -32.8},
      {"Ifrane", "1935-02-11T00:00:00Z", 33.5, 1635.0, -23.9},
      {"Ranfurly", "1903-07-17T00:00:00Z", -45.1, 430.0, -25.6},
      {"Furnace Creek", "1913-07-10T00:00:00Z", 36.5, -54.0, 56.7},
      {"Kebili", "1931-07-07T00:00:00Z", 33.7, 38.0, 55.0},
      {"Oodnadatta", "1960-01-02T00:00:00Z", -27.6, 112.0, 50.7},
      {"Lytton", "2021-06-29T00:00:00Z", 50.2, 225.0, 49.6},
      {"Verkhoyansk", "2020-06-20T00:00:00Z", 67.55, 107.0, 38.0},
      {"Esperanza", "2020-02-06T00:00:00Z", -63.4, 13.0, 18.3},
      {"Sunndalsora", "2020-01-02T00:00:00Z", 62.7, 10.0, 19.0},
  };
  for (const Extreme& extreme : extremes) {
    CAPTURE(extreme.what, extreme.air_c);
    const auto date = ephemeris::Instant::parse_utc(extreme.utc).utc();
    const double utc_s = 86400.0 * (date.day - 2440587.5 + date.fraction);
    const AirLimits limits = air_limits({extreme.latitude_deg, 0.0, extreme.height_m}, utc_s);
    CHECK(extreme.air_c > limits.lowest_c);
    CHECK(extreme.air_c < limits.highest_c);
    // Wide, but not without use.
    CHECK(limits.highest_c - limits.lowest_c < 88.5 + 20.0 + 0.01 * extreme.height_m);
  }
}

TEST_CASE("days without any sunlight are refused, one is told", "[sim][weather]") {
  Steady dark;
  dark.dark_from_h = 0.0;
  dark.dark_to_h = 72.0;
  // The sun is 10 degrees up from about 5:30 to 18:30; at noon 68 degrees (90 - 45 + 23.4).
  CHECK(said_weather_plausible(at_zero(), dark) ==
        "w.csv:11:1: error: no sunlight at all on 2 days, from 2026-06-20T06:00Z to "
        "2026-06-21T18:00Z, while the sun stands up to 68 degrees high\n");
  dark.dark_from_h = 30.0;
  dark.dark_to_h = 43.0;
  CHECK(told_weather_plausible(at_zero(), dark) ==
        "w.csv:35: no sunlight at all on one day, from 2026-06-21T06:00Z to 2026-06-21T18:00Z, "
        "while the sun stands up to 68 degrees high\n");
  // Two dark hours of a morning are no day.
  Steady morning;
  morning.from_h = 30.0;
  morning.dark_from_h = 30.0;
  morning.dark_to_h = 32.0;
  CHECK(told_weather_plausible(at_zero("2026-06-21T08:00:00Z"), morning, 2.0) == "");
  // One bright hour makes it a day, and the days after the picture do not count.
  dark.dark_to_h = 36.0;
  CHECK(told_weather_plausible(at_zero(), dark).empty());
  dark.dark_from_h = 49.0;
  dark.dark_to_h = 72.0;
  CHECK(told_weather_plausible(at_zero(), dark).empty());
}

TEST_CASE("a polar night has no sunlight to miss", "[sim][weather]") {
  Steady dark;
  dark.dark_from_h = 0.0;
  dark.dark_to_h = 72.0;
  dark.air_c = "-30";
  dark.damp = "-35";
  dark.place = place_lines("-80");
  Scenario south = at_zero();
  south.origin.latitude_deg = -80.0;
  CHECK(told_weather_plausible(south, dark).empty());
}

TEST_CASE("weather that just covers what is needed reaches over all of it", "[sim][weather]") {
  // 2026-06-21T18:00Z is hour 42. Hours whose first ends 23 h before and whose last ends with the
  // picture; minutes up to the picture, and up to the one before it.
  const Steady hours{19.0, 42.0, 1.0, 3600};
  const Steady minutes{17.0, 42.0, 1.0 / 60.0, 60};
  const Steady at_times{18.0, 42.0 - 1.0 / 60.0, 1.0 / 60.0, 0};
  for (const Steady& just : {hours, minutes, at_times}) {
    CAPTURE(just.from_h, just.to_h, just.mean_s);
    Files files;
    const Loaded found = load(at_zero(), named(files.write("w.csv", just.text())), 24.0);
    CHECK(files.plain(found.warnings) == "");
    CHECK(found.weather.first_s() <= -86400.0 + 1e-3);  // times of doubles of days: microseconds
    CHECK(found.weather.last_s() >= -1e-3);
    CHECK_NOTHROW(thermal::check(found.weather));
    // Held to the ends.
    CHECK(found.weather.at(0.0).air_temperature_k == Approx(293.15).epsilon(1e-12));
    CHECK(support::reach_h(at_zero(), named(files.write("w.csv", just.text()))) >= 24.0);
  }
}

TEST_CASE("held ends keep the energy of the intervals that are there", "[sim][weather]") {
  Files files;
  Steady hours{13.0, 36.0, 1.0, 3600};  // the last hour ends at noon, with the picture
  const Loaded found =
      load(at_zero("2026-06-21T12:00:00Z"), named(files.write("w.csv", hours.text())), 24.0);
  const auto mean = [&](double from_h, double to_h, double thermal::WeatherState::*what) {
    // The middles of 720 parts: exact for lines but for the three parts with a bend, 1e-5.
    double sum = 0.0;
    for (int i = 0; i < 720; ++i) {
      sum += found.weather.at(3600.0 * (from_h + (to_h - from_h) * (i + 0.5) / 720.0)).*what;
    }
    return sum / 720.0;
  };
  using S = thermal::WeatherState;
  CHECK(mean(-1.0, 0.0, &S::direct_normal_w_m2) ==
        Approx(support::made_sunlight(11.5)).epsilon(1e-5));
  CHECK(mean(-24.0, -23.0, &S::direct_normal_w_m2) ==
        Approx(support::made_sunlight(12.5)).epsilon(1e-5));
  // Long-wave means run through the middle of their hours and stand still beyond the last.
  CHECK(found.weather.at(-900.0).sky_long_wave_w_m2 == Approx(300 + 2160 % 50).epsilon(1e-12));
  CHECK(found.weather.at(-23.75 * 3600.0).sky_long_wave_w_m2 ==
        Approx(300 + 780 % 50).epsilon(1e-12));
}

TEST_CASE("half an hour that is not covered is refused at the scenario's element",
          "[sim][weather]") {
  CHECK(said_weather_plausible(at_zero(), Steady{10.0, 41.0, 1.0, 3600}) ==
        "scene.xml:3:5: error: the weather of w.csv does not cover the hours before the picture: "
        "needed are 2026-06-20T18:00Z to 2026-06-21T18:00Z, the file has 2026-06-20T10:00Z to "
        "2026-06-21T17:00Z\n");
  CHECK(said_weather_plausible(at_zero(), Steady{19.5, 48.0, 0.5, 3600 / 2})
            .find("scene.xml:3:5: error: the weather of w.csv does not cover") == 0);
}

TEST_CASE("how far back weather reaches is known without loading it", "[sim][weather]") {
  Files files;
  const auto reach = [&](const Steady& steady, const Scenario& scenario) {
    return support::reach_h(scenario, named(files.write("w.csv", steady.text())));
  };
  constexpr double second = 1.0 / 3600.0;  // the slack
  // Hour 42 is the picture.
  CHECK(reach(Steady{}, at_zero()) == Approx(42.0 + second).margin(1e-6));
  CHECK(reach(Steady{0.0, 72.0, 1.0, 3600}, at_zero()) == Approx(43.0 + second).margin(1e-6));
  CHECK(reach(Steady{0.0, 41.0}, at_zero()) == 0.0);
  CHECK(reach(Steady{43.0, 72.0}, at_zero()) == 0.0);
  CHECK(reach(Steady{}, at_zero("2027-06-21T18:00:00Z")) == 0.0);
  // A hole: hours 30 to 33 are missing, so that it begins anew with 34; of wind, alike.
  const auto hole = files.write("hole.csv", support::hourly_csv(0, 30, 33));
  CHECK(support::reach_h(at_zero(), named(hole)) == Approx(8.0 + second).margin(1e-6));
  const auto bridged = files.write("bridged.csv", support::hourly_csv(0, 30, 31));
  CHECK(support::reach_h(at_zero(), named(bridged)) == Approx(42.0 + second).margin(1e-6));
  Steady calm{0.0, 72.0, 2.0};  // four hours without wind about hour 30
  calm.no_wind_at_h = 30.0;
  CHECK(reach(calm, at_zero()) == Approx(10.0 + second).margin(1e-6));
  // What it tells is what load_weather takes.
  CHECK(files.message(at_zero(), named(hole), 8.0) == "(nothing thrown)");
  CHECK(files.message(at_zero(), named(hole), 8.5) != "(nothing thrown)");
}

TEST_CASE("a clear sky and a whole typical year reach back without end", "[sim][weather]") {
  constexpr double endless = std::numeric_limits<double>::infinity();
  InputFiles noted;
  CHECK(weather_reaches_back_s(at_zero(), noted) == endless);
  // Two days of a typical year are two days: the picture is at hour 36 of them by their clock, and
  // the first row's hour counts.
  Scenario scenario = support::at_greensboro("2023-08-06T17:00:00Z");
  CHECK(support::reach_h(scenario, named(support::greensboro)) ==
        Approx(36.0 + 1.0 / 3600.0).margin(1e-6));
  // So far as it is looked back, it reaches.
  scenario.heat->weather = named(support::greensboro);
  CHECK(weather_reaches_back_s(scenario, noted, 86400.0) == endless);
  CHECK(noted.all().count(support::greensboro) == 1);
  // A file that cannot be read is none that ends early.
  Files files;
  scenario.heat->weather =
      named(files.write("w.csv", "utc,air_temprature_c\n2026-06-21T16:00Z,20\n"));
  CHECK(files.plain(support::message_of([&] {
    static_cast<void>(weather_reaches_back_s(scenario, noted));
  })) == "w.csv:1:5: error: unknown column \"air_temprature_c\"\n"
         "    1 | utc,air_temprature_c\n"
         "      |     ^\n"
         "    hint: did you mean \"air_temperature_c\"?\n");
}

}  // namespace
}  // namespace nadir::sim
