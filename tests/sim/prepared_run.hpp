#pragma once

#include <fstream>
#include <string>

#include "sim/run/prepare.hpp"
#include "sim/scratch_folder.hpp"

namespace nadir::sim::support {

/// A scenario of a few pixels that look straight down; what a test does not set is plain.
struct SmallScenario {
  std::string bodies = R"(<body name="sun" azimuth_deg="0" elevation_deg="60" irradiance="1000"/>)";
  std::string materials = R"(<material name="grey" reflectance="0.5"/>)";
  std::string geometry = R"(<plane material="grey" size_x_m="200" size_y_m="200"/>)";
  std::string bands = R"(<band_box name="b" lo_um="0.549" hi_um="0.551"/>)";
  std::string more;  ///< elements at the end: <effects>, <accuracy>
  int samples = 8, lines = 8;
  int paths = 2;  ///< a replicate
  std::string solver = R"(<solver method="path"/>)";

  [[nodiscard]] std::string text() const {
    return R"(<scenario name="small">
<time utc="2026-06-21T16:00:00Z"/>
<site latitude_deg="36" longitude_deg="-84" height_m="300"/>
<illumination><fixed>)" +
           bodies + "</fixed></illumination>\n<atmosphere><none/></atmosphere>" + solver +
           "\n<materials default_temperature_k=\"300\">" + materials + "</materials>\n<geometry>" +
           geometry +
           R"(</geometry>
<platform><position><local east_m="0" north_m="0" up_m="50"/></position>
<attitude><euler yaw_deg="0" pitch_deg="-90"/></attitude></platform>
<camera><orthographic><array name="a" ground_pitch_m="1" samples=")" +
           std::to_string(samples) + "\" lines=\"" + std::to_string(lines) + "\">" + bands +
           "</array></orthographic></camera>\n" + more +
           "\n<sampling replicates=\"4\" samples_per_replicate=\"" + std::to_string(paths) +
           "\" wavelengths_per_band=\"1\"/>\n</scenario>\n";
  }
};

/// A scenario in a folder of its own, read, planned and solved.
struct SmallRun {
  ScratchFolder folder;
  RunRequest request;
  StageClock clock;
  Diagnostics diagnostics;
  PreparedRun run;

  explicit SmallRun(const SmallScenario& scenario, std::optional<double> accuracy = {})
      : request{request_for(folder, scenario, accuracy)},
        run{prepare_run(request, clock, diagnostics)} {}

 private:
  static RunRequest request_for(const ScratchFolder& folder, const SmallScenario& scenario,
                                std::optional<double> accuracy) {
    const auto file = folder / "small.xml";
    std::ofstream{file} << scenario.text();
    RunRequest request;
    request.scenario = file;
    request.accuracy = accuracy;
    return request;
  }
};

}  // namespace nadir::sim::support
