#pragma once

#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>
#include <variant>
#include <vector>

#include "end_to_end/command.hpp"
#include "sim/files/envi.hpp"
#include "support/catch.hpp"

namespace nadir::end_to_end {

/// A scenario of one or few pixels that look straight down; what a test does not set is plain.
struct TinyScenario {
  std::string solver;  ///< element, or nothing
  std::string bodies;  ///< elements of <fixed>
  std::string atmosphere = "<none/>";
  std::string materials = R"(<material name="grey" reflectance="0.5"/>)";
  std::string geometry = R"(<plane material="grey" size_x_m="200" size_y_m="200"/>)";
  std::string extra;  ///< <volumes>, <lamps>
  std::string band = R"(<band_box name="b" lo_um="0.549" hi_um="0.551"/>)";
  std::string array = R"(samples="1" lines="1" ground_pitch_m="0.01")";
  int samples = 1;  ///< in each of the four replicates
  std::string platform = R"(<position><local east_m="0" north_m="0" up_m="50"/></position>)"
                         R"(<attitude><euler yaw_deg="0" pitch_deg="-90"/></attitude>)";
  std::string camera;  ///< in place of an orthographic one with `array` and `band`
  std::string products = R"(exr="false" quick_look="false" truth="false" sidecars="false")";

  /// Every part begins on a line of its own, so that a test can say in which line a mistake lies.
  [[nodiscard]] std::string text() const {
    return "<scenario name=\"tiny\">\n"
           "<time utc=\"2026-06-21T16:00:00Z\"/>\n"
           "<site latitude_deg=\"36\" longitude_deg=\"-84\" height_m=\"300\"/>\n"
           "<illumination><fixed>" +
           bodies +
           "</fixed></illumination>\n"
           "<atmosphere>" +
           atmosphere + "</atmosphere>" + solver +
           "\n"
           "<materials default_temperature_k=\"300\">\n" +
           materials +
           "\n</materials>\n"
           "<geometry>" +
           geometry + "</geometry>\n" + extra + "\n<platform>" + platform +
           "</platform>\n<camera>" +
           (camera.empty() ? "<orthographic><array name=\"a\" " + array + ">" + band +
                                 "</array></orthographic>"
                           : camera) +
           "</camera>\n"
           "<sampling replicates=\"4\" samples_per_replicate=\"" +
           std::to_string(samples) +
           "\" wavelengths_per_band=\"1\"/>\n"
           "<products " +
           products +
           "/>\n"
           "</scenario>\n";
  }
};

inline const std::string path_method = R"(<solver method="path"/>)";
inline const std::string sun_overhead =
    R"(<body name="sun" azimuth_deg="0" elevation_deg="90" irradiance="1000"/>)";

inline void write_file(const std::filesystem::path& file, const std::string& content) {
  std::ofstream{file, std::ios::binary} << content;
}

/// What a run of a tiny scenario left.
struct TinyRun {
  std::vector<float> radiance, error;  ///< of the first band, by pixel
  std::string report;

  [[nodiscard]] double counter(const std::string& name) const { return number_after(name); }
  [[nodiscard]] double mean_radiance() const {
    double sum = 0.0;
    for (const float value : radiance) sum += value;
    return sum / static_cast<double>(radiance.size());
  }
  /// Standard error of `mean_radiance`: pixels are independent.
  [[nodiscard]] double mean_error() const {
    double sum = 0.0;
    for (const float value : error) sum += static_cast<double>(value) * value;
    return std::sqrt(sum) / static_cast<double>(error.size());
  }

 private:
  [[nodiscard]] double number_after(const std::string& key) const {
    const auto at = report.find("\"" + key + "\":");
    REQUIRE(at != std::string::npos);
    return std::stod(report.substr(at + key.size() + 3));
  }
};

inline std::vector<float> first_plane(const std::filesystem::path& image) {
  return std::get<std::vector<std::vector<float>>>(sim::read_envi(image).planes).front();
}

/// Runs the scenario in `folder`, where its other files lie.
inline TinyRun run_tiny(const sim::support::ScratchFolder& folder, const TinyScenario& scenario) {
  write_file(folder / "tiny.xml", scenario.text());
  const auto out = folder / "out";
  const auto result = run_nadir("run " + (folder / "tiny.xml").string() +
                                " --quiet --threads 1 -o " + out.string());
  CAPTURE(result.err);
  REQUIRE(result.exit_code == 0);
  return {first_plane(out / "a_radiance.img"), first_plane(out / "a_error.img"),
          sim::support::content_of(out / "report.json")};
}

inline TinyRun run_tiny(const TinyScenario& scenario) {
  return run_tiny(sim::support::ScratchFolder{}, scenario);
}

/// The one message of a run that must be refused: without the folder's name, up to its first line's
/// end. Checks exit code, that there is one error, and that nothing was written.
inline std::string refusal(const sim::support::ScratchFolder& folder,
                           const TinyScenario& scenario) {
  write_file(folder / "tiny.xml", scenario.text());
  const auto out = folder / "out";
  const auto result =
      run_nadir("run " + (folder / "tiny.xml").string() + " --quiet -o " + out.string());
  CHECK(result.exit_code == 2);
  CHECK_FALSE(std::filesystem::exists(out));
  std::size_t errors = 0;
  for (auto at = result.err.find(": error: "); at != std::string::npos;
       at = result.err.find(": error: ", at + 1)) {
    ++errors;
  }
  CAPTURE(result.err);
  CHECK(errors == 1);
  const std::string place = folder.path().string() + "/";
  const auto begin = result.err.find(place);
  if (begin == std::string::npos) return result.err;
  return result.err.substr(begin + place.size(),
                           result.err.find('\n', begin) - begin - place.size());
}

}  // namespace nadir::end_to_end
