#pragma once

#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <set>
#include <string>
#include <vector>

#include "sim/message_of.hpp"
#include "sim/run/load_weather.hpp"
#include "sim/scratch_folder.hpp"
#include "sim/weather_support.hpp"

// Weather from files of a test, as a scenario loads it.

namespace nadir::sim::support {

inline const std::filesystem::path greensboro =
    std::filesystem::path{NADIR_SOURCE_DIR} / "tests/sim/data/greensboro_two_days.csv";

inline Scenario at_greensboro(const std::string& utc) {
  Scenario scenario;
  scenario.time = ephemeris::Instant::parse_utc(utc);
  scenario.origin = {36.1, -79.95, 273.0};
  scenario.heat = HeatInput{};
  return scenario;
}
inline Scenario at_zero(const std::string& utc = "2026-06-21T18:00:00Z") {
  Scenario scenario = at_greensboro(utc);
  scenario.origin = {45.0, 0.0, 0.0};
  return scenario;
}

inline WeatherFileInput named(const std::filesystem::path& file) {
  WeatherFileInput input;
  input.file = file;
  input.where = {"scene.xml", 3, 5};
  return input;
}

struct Loaded {
  thermal::Weather weather;
  std::vector<std::string> warnings;
  std::set<std::filesystem::path> files;
};
inline Loaded load(Scenario scenario, const WeatherFileInput& input, double hours) {
  Diagnostics diagnostics;
  InputFiles files;
  scenario.heat->weather = input;
  Loaded loaded;
  loaded.weather = load_weather(scenario, 3600.0 * hours, files, diagnostics);
  loaded.warnings = diagnostics.messages();
  loaded.files = files.all();
  return loaded;
}
/// How far the file reaches back, hours.
inline double reach_h(Scenario scenario, const WeatherFileInput& input) {
  InputFiles files;
  scenario.heat->weather = input;
  return weather_reaches_back_s(scenario, files) / 3600.0;
}

/// Writes files of weather, and tells what is said of them.
class Files {
 public:
  std::filesystem::path write(const std::string& name, const std::string& text) {
    std::ofstream{folder_ / name} << text;
    return folder_ / name;
  }
  /// The message for a picture, without the folder's name.
  [[nodiscard]] std::string message(const Scenario& scenario, const WeatherFileInput& input,
                                    double hours) const {
    return plain(message_of([&] { static_cast<void>(load(scenario, input, hours)); }));
  }
  [[nodiscard]] std::string plain(std::string text) const {
    const std::string prefix = folder_.path().string() + "/";
    for (auto at = text.find(prefix); at != std::string::npos; at = text.find(prefix)) {
      text.erase(at, prefix.size());
    }
    return text;
  }
  [[nodiscard]] std::string plain(const std::vector<std::string>& warnings) const {
    std::string all;
    for (const std::string& warning : warnings) all += warning + "\n";
    return plain(all);
  }

 private:
  ScratchFolder folder_;
};

inline std::string place_lines(const std::string& latitude, const std::string& longitude = "0") {
  return "# latitude_deg: " + latitude + "\n# longitude_deg: " + longitude + "\n";
}

/// A CSV in UTC with the sun of longitude 0, every hour of two days from 2026-06-20 on; the air is
/// as warm as hours have passed.
inline std::string hourly_csv(int shift_h = 0, int skip_from = 1000, int skip_to = 0,
                              const std::string& place = place_lines("45")) {
  std::string text = place +
                     "utc,air_temperature_c,dew_point_c,wind_speed_m_s,direct_normal_w_m2,"
                     "diffuse_horizontal_w_m2,sky_long_wave_w_m2\n";
  for (int hour = 0; hour <= 48; ++hour) {
    if (hour >= skip_from && hour <= skip_to) continue;
    const double light = made_sunlight((hour + 24 - shift_h) % 24);
    text += fmt::format("2026-06-{:02d}T{:02d}:00Z,{},-1,2,{:g},{:g},300\n", 20 + hour / 24,
                        hour % 24, hour, light, 0.2 * light);
  }
  return text;
}

}  // namespace nadir::sim::support
