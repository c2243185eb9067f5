#include <algorithm>
#include <cmath>
#include <fstream>
#include <string>
#include <vector>

#include "sensor/optics/system_mtf.hpp"
#include "sim/run/render.hpp"
#include "sim/run/world.hpp"
#include "sim/scenario/read_scenario.hpp"
#include "sim/scratch_folder.hpp"
#include "support/catch.hpp"
#include "support/slanted_edge.hpp"

// From a scenario's text through the real renderer: the edge of a plate of 300 K over nothing, in
// the long-wave infrared, by the method of ISO 12233.

namespace nadir::sim {
namespace {

struct Scan {
  std::string blur;          ///< elements of the array
  std::string velocity;      ///< attributes of <straight>; none: it stands
  double motion_px_s = 0.0;  ///< of the image along x
  int lines = 12, paths = 256, samples = 40;
};

/// The camera is 1000 m up with pixels of 0.2 m; the plate's western side passes below it, turned
/// clockwise by atan(1/12).
std::string edge_scenario(const Scan& scan) {
  const double turn = std::atan(1.0 / 12.0);
  const std::string position =
      scan.velocity.empty() ? R"(<local east_m="0" north_m="0" up_m="1000"/>)"
                            : R"(<straight speed_m_s="20" )" + scan.velocity +
                                  R"(><local east_m="0" north_m="0" up_m="1000"/></straight>)";
  return R"(<scenario name="edge"><time utc="2026-06-21T16:00:00Z"/>
  <site latitude_deg="36" longitude_deg="-84" height_m="300"/>
  <illumination><fixed/></illumination><atmosphere><none/></atmosphere>
  <materials><material name="m" emissivity="1" temperature_k="300"/></materials>
  <geometry><plane material="m" size_x_m="200" size_y_m="200" yaw_deg=")" +
         std::to_string(turn * 180.0 / 3.14159265358979) + R"(" east_m=")" +
         std::to_string(100.0 * std::cos(turn)) + R"(" north_m=")" +
         std::to_string(-100.0 * std::sin(turn)) + R"("/></geometry>
  <platform><position>)" +
         position + R"(</position>
    <attitude><euler yaw_deg="0" pitch_deg="-90"/></attitude></platform>
  <camera><perspective focal_length_mm="100"><array name="a" samples=")" +
         std::to_string(scan.samples) + R"(" lines=")" + std::to_string(scan.lines) +
         R"(" pitch_um="20"><band_box name="t" lo_um="10" hi_um="11"/>)" + scan.blur +
         R"(</array></perspective></camera>
  <sampling replicates="4" samples_per_replicate=")" +
         std::to_string(scan.paths) + R"(" wavelengths_per_band="1"/>
</scenario>)";
}

/// The largest difference of the edge's modulation from what is told, up to a frequency.
double worst_up_to(double highest, const Scan& scan) {
  const support::ScratchFolder folder;
  std::ofstream{folder / "edge.xml"} << edge_scenario(scan);
  Diagnostics diagnostics;
  InputFiles files;
  const Scenario scenario = read_scenario(folder / "edge.xml", diagnostics);
  const World world = load_world(scenario, files, diagnostics);
  RenderOptions options;
  options.sampling = scenario.sampling;
  options.truth = false;
  const auto image = render(world.scene, world.camera, options, diagnostics).images.front();
  const std::vector<float>& radiance = image.bands.front().radiance;
  std::vector<double> frequencies;
  for (double f = 0.025; f < highest + 1e-9; f += 0.025) frequencies.push_back(f);
  const auto found = nadir::support::edge_response(
      {image.samples, image.lines, {radiance.begin(), radiance.end()}}, frequencies, 12);
  const auto told = sensor::system_mtf(world.camera.arrays.front(), world.camera.platform,
                                       {0, false, scan.motion_px_s}, frequencies);
  double worst = 0.0;
  for (std::size_t i = 0; i < frequencies.size(); ++i) {
    UNSCOPED_INFO(frequencies[i] << " cycles a pixel: " << found.modulation[i] << " for "
                                 << told.total[i]);
    REQUIRE(std::isfinite(found.modulation[i]));
    worst = std::max(worst, std::abs(found.modulation[i] - told.total[i]));
  }
  return worst;
}

const Scan gaussian{R"(<gaussian_blur sigma_x_um="8"/>)", {}, 0.0};
/// Wide: 0.5 % of the light in its rings lies beyond 20 pixels on either side.
const Scan diffraction{R"(<optics f_number="1"/><diffraction/>)", {}, 0.0, 12, 256, 96};
/// 20 m/s to the east are 100 pixels a second, to image left: 1.5 pixels in 15 ms.
const Scan smear{R"(<global_shutter exposure_ms="15"/>)", R"(azimuth_deg="90")", -100.0};

double sharp(Scan scan) {
  scan.lines = 96;
  scan.paths = 1024;
  return worst_up_to(0.5, scan);
}

// Pixels draw apart from one another here, and the noise of an edge's modulation grows with the
// frequency: 2 pi f sqrt(sum of the pixels' variances). 96 lines of 4096 paths leave 0.002.
TEST_CASE("a rendered edge has the modulation that is told", "[.slow][sim][mtf]") {
  CHECK(sharp(gaussian) < 0.005);
  CHECK(sharp(diffraction) < 0.005);
  CHECK(sharp(smear) < 0.005);
}

// 12 lines of 1024 paths: 0.01 at half of Nyquist; a factor of 2 in a width shows as 0.1.
TEST_CASE("a rendered edge has about the modulation that is told", "[sim][mtf]") {
  CHECK(worst_up_to(0.25, gaussian) < 0.03);
  CHECK(worst_up_to(0.25, diffraction) < 0.03);
  CHECK(worst_up_to(0.25, smear) < 0.03);
}

}  // namespace
}  // namespace nadir::sim
