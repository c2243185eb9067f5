#include "sim/run/load_light.hpp"

#include <cmath>
#include <string>
#include <vector>

#include "ephemeris/sun_moon.hpp"
#include "sim/files/spectrum_file.hpp"
#include "support/catch.hpp"

namespace {

using namespace nadir;
using namespace nadir::sim;

struct LoadedLight {
  ephemeris::Illumination bodies;
  std::vector<std::string> files, messages;
};

Scenario at_light(const std::string& utc, double latitude_deg, double longitude_deg) {
  Scenario scenario;
  scenario.time = ephemeris::Instant::parse_utc(utc);
  scenario.origin = {latitude_deg, longitude_deg, 0.0};
  scenario.illumination = ComputedSky{};
  return scenario;
}

LoadedLight load_light(const Scenario& scenario) {
  InputFiles files;
  Diagnostics diagnostics;
  LoadedLight loaded{load_illumination(scenario, files, diagnostics), {}, {}};
  for (const auto& file : files.all()) loaded.files.push_back(file.filename().string());
  loaded.messages = diagnostics.messages();
  return loaded;
}

ephemeris::SunAndMoon seen_light(const Scenario& scenario) {
  return ephemeris::sun_and_moon(
      scenario.time, {scenario.origin.latitude_deg, scenario.origin.longitude_deg, 0.0});
}

double light_library_sun(Micrometres wavelength) {
  static const auto curve = read_curve(NADIR_SOURCE_DIR "/scenes/library/illumination/solar.csv",
                                       "", SpectrumQuantity::irradiance, spectral::Outside::reject);
  return curve.at(wavelength);
}

using Names = std::vector<std::string>;
const SpectralInput dark{0.0, {}};

}  // namespace

TEST_CASE("by day an ephemeris has the library's sun, and no moon to pay for", "[sim][light]") {
  const Scenario noon = at_light("2026-07-04T12:00:00Z", 43.0, 5.0);  // at aphelion, 1.0166 au
  const LoadedLight light = load_light(noon);
  REQUIRE(light.bodies.size() == 1);
  CHECK(light.bodies[0].name == "sun");
  CHECK(light.bodies[0].irradiance.at(0.55_um) ==
        Approx(light_library_sun(0.55_um) / (1.0166 * 1.0166)).epsilon(1e-4));
  CHECK(light.files == Names{"solar.csv"});
  CHECK(light.messages.empty());
}

// Full moons above the horizon, phase 2 to 7 degrees: 2.0e-6 to 2.8e-6 of the sun, both outside the
// air, at the mean distance. The last one is in the zenith at perigee, 351,700 km away: 3.1e-6.
TEST_CASE("by night an ephemeris has a full moon of 2e-6 suns", "[sim][light]") {
  const std::string utc = GENERATE(as<std::string>{}, "2026-10-26T04:00:00Z",
                                   "2026-06-29T23:00:00Z", "2027-01-22T14:00:00Z");
  const double longitude_deg = utc == "2027-01-22T14:00:00Z" ? 140.0 : 5.0;
  const Scenario night = at_light(utc, 10.0, longitude_deg);
  const auto sky = seen_light(night);
  CAPTURE(utc, to_degrees(sky.phase.phase_angle), to_degrees(sky.moon.elevation),
          sky.moon.distance.value);
  REQUIRE(sky.moon.elevation > 0.0_deg);
  REQUIRE(sky.phase.phase_angle > 2.0_deg);
  REQUIRE(sky.phase.phase_angle < 7.0_deg);
  const LoadedLight light = load_light(night);
  REQUIRE(light.bodies.size() == 2);
  CHECK(light.bodies[0].irradiance.max_value() == 0.0);
  CHECK(light.bodies[1].name == "moon");
  const double sun_au = sky.sun.distance.value / 149'597'870'700.0;
  const double ratio =
      light.bodies[1].irradiance.at(0.55_um) / (light_library_sun(0.55_um) / (sun_au * sun_au));
  const double at_mean_distance = ratio * std::pow(sky.moon.distance.value / 384.4e6, 2.0);
  CHECK(at_mean_distance > 2.0e-6);
  CHECK(at_mean_distance < 2.8e-6);
  CHECK(ratio < 3.2e-6);
  // redder than the sun
  CHECK(light.bodies[1].irradiance.at(1.6_um) / light_library_sun(1.6_um) > 1.5 * ratio);
  CHECK(light.bodies[1].irradiance.covers(0.3_um, 14.0_um));
  CHECK(light.files == Names{"moon.csv", "solar.csv"});
  REQUIRE(light.messages.size() == 1);
  CHECK(light.messages[0].find("modelled from 0.35 to 2.3836 um") != std::string::npos);
}

TEST_CASE("with sun and moon far below the horizon no file is opened", "[sim][light]") {
  const Scenario night = at_light("2026-06-15T22:30:00Z", 0.0, 5.0);  // new moon, midnight
  REQUIRE(seen_light(night).moon.elevation < -20.0_deg);
  const LoadedLight light = load_light(night);
  REQUIRE(light.bodies.size() == 1);
  CHECK(light.bodies[0].irradiance.max_value() == 0.0);
  CHECK(light.bodies[0].direction_enu.z < 0.0);
  CHECK(light.files.empty());
  CHECK(light.messages.empty());
}

TEST_CASE("in twilight the sun still lights, and the moon as well", "[sim][light]") {
  const Scenario dusk = at_light("2026-06-29T20:00:00Z", 43.0, 5.0);
  const auto sky = seen_light(dusk);
  REQUIRE(sky.sun.elevation < 0.0_deg);
  REQUIRE(sky.sun.elevation > -18.0_deg);
  const LoadedLight light = load_light(dusk);
  REQUIRE(light.bodies.size() == 2);
  CHECK(light.bodies[0].irradiance.max_value() > 1000.0);
  CHECK(light.bodies[1].irradiance.max_value() > 1e-4);
}

TEST_CASE("a zero makes a body dark, and the other stays", "[sim][light]") {
  Scenario night = at_light("2026-10-26T04:00:00Z", 43.0, 5.0);
  night.illumination = ComputedSky{std::nullopt, dark};
  const LoadedLight no_moon = load_light(night);
  REQUIRE(no_moon.bodies.size() == 2);
  CHECK(no_moon.bodies[1].irradiance.max_value() == 0.0);
  CHECK(no_moon.files.empty());
  night.illumination = ComputedSky{dark, std::nullopt};
  const LoadedLight no_sun = load_light(night);
  REQUIRE(no_sun.bodies.size() == 2);
  CHECK(no_sun.bodies[0].irradiance.max_value() == 0.0);
  CHECK(no_sun.bodies[1].irradiance.max_value() > 1e-3);
  // the moon is up in the afternoon of 2026 July 18
  Scenario day = at_light("2026-07-18T16:15:00Z", 43.0, 5.0);
  day.illumination = ComputedSky{dark, std::nullopt};
  REQUIRE(load_light(day).bodies.size() == 2);
  CHECK(load_light(day).bodies[1].irradiance.max_value() > 1e-5);
  day.illumination = ComputedSky{dark, dark};
  CHECK(load_light(day).bodies[0].irradiance.max_value() == 0.0);
  CHECK(load_light(day).files.empty());
}

TEST_CASE("what a scenario gives is taken as it is", "[sim][light]") {
  Scenario day = at_light("2026-07-04T12:00:00Z", 43.0, 5.0);
  day.illumination = ComputedSky{SpectralInput{1800.0, {}}, SpectralInput{0.004, {}}};
  const LoadedLight light = load_light(day);
  REQUIRE(light.bodies.size() == 2);
  CHECK(light.bodies[0].irradiance.at(0.55_um) == Approx(1800.0 / (1.0166 * 1.0166)).epsilon(1e-4));
  CHECK(light.bodies[1].irradiance.at(0.55_um) == 0.004);
  CHECK(light.files.empty());
}

TEST_CASE("eclipses darken the light and are told", "[sim][light]") {
  const LoadedLight total = load_light(at_light("2017-08-21T18:25:32Z", 36.967, -87.672));
  CHECK(total.bodies[0].irradiance.max_value() == 0.0);
  REQUIRE(total.messages.size() == 1);
  CHECK(total.messages[0] == "a solar eclipse: the moon covers 100.0 % of the sun's disc");
  const LoadedLight lunar = load_light(at_light("2022-05-16T04:11:00Z", -19.5, -63.9));
  REQUIRE(lunar.bodies.size() == 2);
  const double ratio = lunar.bodies[1].irradiance.at(0.55_um) / light_library_sun(0.55_um);
  CHECK(ratio == Approx(2.8e-6 * 8e-5).epsilon(0.2));  // at perigee, 362,000 km
  REQUIRE(lunar.messages.size() == 3);
  CHECK(lunar.messages[0] == "a lunar eclipse: the moon has 8e-05 of its light at 0.55 um");
}
