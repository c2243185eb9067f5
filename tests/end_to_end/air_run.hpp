#pragma once

#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <string>

#include "end_to_end/tiny_scenario.hpp"
#include "support/catch.hpp"

// Runs of the whole command under air in layers, with a cache of tables of their own.

namespace nadir::end_to_end {

namespace fs = std::filesystem;
using sim::support::content_of;

inline const std::string noon = R"(<body name="sun" azimuth_deg="180" elevation_deg="45" )"
                                R"(irradiance="library:illumination/solar.csv"/>)";
inline const std::string blue_and_red = R"(<band_box name="blue" lo_um="0.449" hi_um="0.451"/>)"
                                        R"(<band_box name="red" lo_um="0.649" hi_um="0.651"/>)";
inline const std::string window = R"(<band_box name="t" lo_um="10.4" hi_um="11"/>)";

/// A folder for scenario and products, with the cache of tables in it for as long as it lives.
class AirFolder {
 public:
  AirFolder() { setenv("NADIR_CACHE", cache().c_str(), 1); }
  ~AirFolder() { unsetenv("NADIR_CACHE"); }
  AirFolder(const AirFolder&) = delete;
  AirFolder& operator=(const AirFolder&) = delete;

  [[nodiscard]] fs::path cache() const { return folder_ / "cache"; }
  [[nodiscard]] const sim::support::ScratchFolder& folder() const { return folder_; }
  [[nodiscard]] fs::path table() const {
    for (const auto& entry : fs::directory_iterator{cache()}) {
      if (entry.path().extension() == ".air") return entry.path();
    }
    return {};
  }

 private:
  sim::support::ScratchFolder folder_;
};

struct AirRun {
  std::string planes, report, err;

  [[nodiscard]] bool says(const std::string& text) const {
    return report.find(text) != std::string::npos;
  }
  /// A whole number of the report.
  [[nodiscard]] int number(const std::string& name) const {
    const auto at = report.find("\"" + name + "\": ");
    REQUIRE(at != std::string::npos);
    return std::stoi(report.substr(at + name.size() + 4));
  }
  /// Radiance of a band in the only pixel.
  [[nodiscard]] double radiance(std::size_t band) const {
    float value = 0.0F;
    std::memcpy(&value, planes.data() + band * sizeof value, sizeof value);
    return static_cast<double>(value);
  }
};

inline AirRun run_air(const AirFolder& air, const std::string& text) {
  write_file(air.folder() / "tiny.xml", text);
  const auto out = air.folder() / "out";
  const auto result = run_nadir("run " + (air.folder() / "tiny.xml").string() +
                                " --quiet --threads 2 -o " + out.string());
  CAPTURE(result.err);
  REQUIRE(result.exit_code == 0);
  return {content_of(out / "a_radiance.img"), content_of(out / "report.json"), result.err};
}

inline TinyScenario day() {
  TinyScenario scenario;
  scenario.bodies = noon;
  scenario.atmosphere = R"(<layered mode="fast"/>)";
  scenario.band = blue_and_red;
  return scenario;
}

inline std::string looking_up(const TinyScenario& scenario) {
  std::string text = scenario.text();
  const std::string down = "pitch_deg=\"-90\"";
  return text.replace(text.find(down), down.size(), "pitch_deg=\"60\"");
}

}  // namespace nadir::end_to_end
