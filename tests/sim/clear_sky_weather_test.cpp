// Weather of a clear sky over a scenario's site.
#include "sim/run/clear_sky_weather.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "core/constants.hpp"
#include "core/error.hpp"
#include "ephemeris/sun_moon.hpp"
#include "support/catch.hpp"

namespace {

using namespace nadir;
using namespace nadir::sim;
using thermal::Weather;

constexpr double hour_s = 3600.0, day_s = 86400.0;

Scenario site(const std::string& utc, AirInput air, double latitude_deg = 36.0) {
  Scenario scenario;
  scenario.time = ephemeris::Instant::parse_utc(utc);
  scenario.origin = {latitude_deg, 0.0, 250.0};
  scenario.illumination = ComputedSky{};
  scenario.air = std::move(air);
  return scenario;
}

ClearSkyInput plain_day() {
  ClearSkyInput input;
  input.where = {"scenario.xml", 7, 5};
  return input;
}

struct Made {
  Weather weather;
  std::vector<std::string> messages;
};

Made make(const Scenario& scenario, double history_s = day_s) {
  InputFiles files;
  Diagnostics diagnostics;
  Made made{clear_sky_weather_of(scenario, plain_day(), history_s, files, diagnostics), {}};
  made.messages = diagnostics.messages();
  return made;
}

LayeredAir quick_air() {
  LayeredAir air;
  air.aerosol.type = atmosphere::AerosolType::none;
  air.profile = "midlatitude_summer";
  return air;
}

double most(const thermal::TimeSeries& series) {
  return *std::max_element(series.value.begin(), series.value.end());
}

bool told_clear_sky_weather(const Made& made, const std::string& what) {
  return std::any_of(made.messages.begin(), made.messages.end(),
                     [&](const std::string& m) { return m.find(what) != std::string::npos; });
}

}  // namespace

TEST_CASE("clear-sky weather covers the history in ten minutes' steps", "[sim][weather]") {
  const double history_s = GENERATE(3600.0, 86400.0, 100000.0);
  const Made made = make(site("2026-06-21T15:20:00Z", NoAir{}), history_s);
  CHECK(made.weather.first_s() <= -history_s);
  CHECK(made.weather.first_s() > -history_s - 600.0);
  CHECK(made.weather.last_s() == 0.0);
  const auto& times = made.weather.air_temperature_k.time_s;
  for (std::size_t i = 1; i < times.size(); ++i) CHECK(times[i] - times[i - 1] == 600.0);
}

TEST_CASE("a summer day under layered air has summer's light", "[sim][weather]") {
  // Noon is at 12:02 UTC at longitude 0; the picture is taken 24 h after midnight.
  const Made made = make(site("2026-06-22T00:00:00Z", quick_air()));
  const Weather& w = made.weather;
  CHECK(made.messages.empty());
  const thermal::WeatherState noon = w.at(-12.0 * hour_s);
  const thermal::WeatherState night = w.at(0.0);
  // 77.4 degrees high, 1.016 au: 1005 W m^-2 from straight above at 1 au without haze, less 3 %.
  CHECK(noon.direct_normal_w_m2 > 940.0);
  CHECK(noon.direct_normal_w_m2 < 1005.0);
  CHECK(noon.diffuse_horizontal_w_m2 > 50.0);
  CHECK(noon.diffuse_horizontal_w_m2 < 80.0);
  CHECK(night.direct_normal_w_m2 == 0.0);
  CHECK(night.diffuse_horizontal_w_m2 < 1e-3);
  // The profile's sky at 250 m and 293 K, taken to the air's temperature of the moment.
  const double air_k = noon.air_temperature_k;
  CHECK(noon.sky_long_wave_w_m2 / (si::stefan_boltzmann * std::pow(air_k, 4)) ==
        Approx(night.sky_long_wave_w_m2 /
               (si::stefan_boltzmann * std::pow(night.air_temperature_k, 4)))
            .epsilon(1e-9));
  CHECK(noon.sky_long_wave_w_m2 / (si::stefan_boltzmann * std::pow(air_k, 4)) ==
        Approx(0.81).margin(0.04));
  CHECK(noon.pressure_hpa == Approx(984.0).margin(5.0));
  // Lowest at sunrise, 4:50 UTC; highest 1.86 h after noon.
  CHECK(w.at(-19.17 * hour_s).air_temperature_k == Approx(288.15).margin(0.3));
  CHECK(w.at(-10.1 * hour_s).air_temperature_k == Approx(300.15).margin(0.05));
}

TEST_CASE("sunlight is that of the ephemeris' sun", "[sim][weather]") {
  const Scenario scenario = site("2026-03-20T14:00:00Z", NoAir{}, 50.0);
  const Made made = make(scenario);
  // Without air direct light is the sun's own, 0.28 to 4 um, from sunrise to sunset.
  const auto seen = ephemeris::sun_and_moon(scenario.time, {50.0, 0.0, 250.0});
  const double distance = seen.sun.distance.value / astro::astronomical_unit_m;
  CHECK(made.weather.at(0.0).direct_normal_w_m2 ==
        Approx(1343.1 / (distance * distance)).epsilon(1e-4));
  CHECK(made.weather.at(-14.0 * hour_s).direct_normal_w_m2 == 0.0);
  CHECK(most(made.weather.diffuse_horizontal_w_m2) == 0.0);
  // Space is cold: the least that weather may have.
  CHECK(most(made.weather.sky_long_wave_w_m2) == 1.0);
}

TEST_CASE("uniform air keeps its figures through the day, with a warning", "[sim][weather]") {
  UniformAir air;
  air.solar_transmittance = {0.7, {}};
  air.sky_radiance = {10.0, {}};
  air.sky_temperature_k = 260.0;
  const Made made = make(site("2026-03-20T12:00:00Z", air));
  CHECK(told_clear_sky_weather(made,
                               "scenario.xml:7:5: uniform air is given for one height of the sun"));
  const thermal::WeatherState noon = made.weather.at(0.0);
  const double distance = 0.9961;  // au, March 20
  CHECK(noon.direct_normal_w_m2 == Approx(0.7 * 1343.1 / (distance * distance)).epsilon(1e-3));
  // pi x 10 x 3.72 um
  CHECK(noon.diffuse_horizontal_w_m2 ==
        Approx(std::numbers::pi * 37.2 / (distance * distance)).epsilon(1e-3));
  CHECK(noon.sky_long_wave_w_m2 ==
        Approx(si::stefan_boltzmann * std::pow(260.0, 4)).epsilon(1e-12));
  CHECK(made.weather.at(-5.0 * hour_s).direct_normal_w_m2 ==
        Approx(noon.direct_normal_w_m2).epsilon(1e-3));
}

TEST_CASE("a tabulated sky's heat is taken as black beyond its table", "[sim][weather]") {
  UniformAir air;
  air.sky_radiance.source =
      std::filesystem::path{NADIR_SOURCE_DIR "/scenes/library/atmosphere/clear_sky_thermal.csv"};
  const Made made = make(site("2026-06-21T12:00:00Z", air));
  // LOWTRAN7's midlatitude summer sky. Line by line it gives 349 W m^-2 with air of 294.2 K; ours
  // is the mean of the day, 294.15 K.
  CHECK(made.weather.at(0.0).sky_long_wave_w_m2 == Approx(349.0).margin(10.0));
}

TEST_CASE("a table of the air from elsewhere is stood in for, with a warning", "[sim][weather]") {
  TableAir table;
  table.where = {"scenario.xml", 3, 3};
  table.file = "not-even-read.csv";
  const Made made = make(site("2026-06-21T12:00:00Z", table));
  CHECK(told_clear_sky_weather(made, "scenario.xml:3:3: a table of the air"));
  CHECK(made.weather.at(0.0).direct_normal_w_m2 > 700.0);
  CHECK(made.weather.at(0.0).direct_normal_w_m2 < 850.0);
}

TEST_CASE("a sun given in one band only is completed by the library's", "[sim][weather]") {
  Scenario scenario = site("2026-06-21T12:00:00Z", NoAir{});
  SECTION("one number") {
    scenario.illumination = ComputedSky{SpectralInput{1000.0, {}}, {}};
    const Made made = make(scenario);
    CHECK(told_clear_sky_weather(made, "does not tell all sunlight"));
    CHECK(made.weather.at(0.0).direct_normal_w_m2 > 1290.0);
  }
  SECTION("a dark sun stays dark") {
    scenario.illumination = ComputedSky{SpectralInput{0.0, {}}, {}};
    const Made made = make(scenario);
    CHECK(made.messages.empty());
    CHECK(most(made.weather.direct_normal_w_m2) == 0.0);
  }
}

TEST_CASE("a sun at fixed angles has no day", "[sim][weather]") {
  Scenario scenario = site("2026-06-21T12:00:00Z", NoAir{});
  scenario.illumination = FixedSky{};
  try {
    static_cast<void>(make(scenario));
    FAIL("no error");
  } catch (const InputError& error) {
    const std::string text = error.what();
    CHECK(text.find("scenario.xml:7:5: error: clear-sky weather needs the sun's way through the "
                    "day") != std::string::npos);
    CHECK(text.find("<ephemeris/>") != std::string::npos);
  }
}

TEST_CASE("a day that the earth does not know is refused where it is written", "[sim][weather]") {
  ClearSkyInput input = plain_day();
  input.air_high_k = 400.0;
  InputFiles files;
  Diagnostics diagnostics;
  try {
    static_cast<void>(clear_sky_weather_of(site("2026-06-21T12:00:00Z", NoAir{}), input, day_s,
                                           files, diagnostics));
    FAIL("no error");
  } catch (const InputError& error) {
    CHECK(std::string{error.what()}.find("scenario.xml:7:5: error: weather: air temperature") !=
          std::string::npos);
  }
}
