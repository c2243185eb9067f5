#include <algorithm>
#include <cmath>
#include <string>

#include "end_to_end/tiny_scenario.hpp"
#include "support/catch.hpp"

// Whole runs with moving cameras and detectors.

namespace nadir::end_to_end {
namespace {

namespace fs = std::filesystem;

constexpr double height_m = 1000.0, speed_m_s = 50.0, line_period_s = 0.01;

/// An aircraft 1000 m above the ground that flies south, so that lines run from north to south.
const std::string flight =
    R"(<position><straight azimuth_deg="180" speed_m_s="50"><local east_m="0" north_m="0" )"
    R"(up_m="1000"/></straight></position><attitude><nadir/></attitude>)";

/// A row of detectors of half a metre on the ground, which a line's flight fits.
std::string row(const std::string& name, const std::string& attributes,
                const std::string& children) {
  return "<array name=\"" + name + "\" pitch_um=\"10\" " + attributes + ">" + children +
         R"(<band_box name="b" lo_um="0.549" hi_um="0.551"/></array>)";
}
std::string pushbroom_camera(const std::string& arrays) {
  return "<perspective focal_length_mm=\"20\">" + arrays + "</perspective>";
}

/// Runs the scenario in a folder; returns where its products lie.
fs::path products_of(const sim::support::ScratchFolder& folder, const TinyScenario& scenario,
                     const std::string& out, const std::string& options = "") {
  write_file(folder / "tiny.xml", scenario.text());
  const auto result = run_nadir("run " + (folder / "tiny.xml").string() + " --quiet " + options +
                                " -o " + (folder / out).string());
  CAPTURE(result.err);
  REQUIRE(result.exit_code == 0);
  return folder / out;
}

TinyScenario noisy_scenario() {
  TinyScenario scenario;
  scenario.bodies = R"(<body name="sun" azimuth_deg="120" elevation_deg="30" irradiance="1000"/>)";
  scenario.geometry = R"(<plane material="grey" size_x_m="4000" size_y_m="8000"/>)";
  scenario.platform = flight;
  scenario.camera = pushbroom_camera(
      row("a", R"(samples="40" lines="50")",
          R"(<pushbroom line_period_ms="10" exposure_ms="4"/><optics f_number="4"/>)"
          R"(<photon_detector efficiency="0.5" read_noise_e="20" full_well_e="50000" bits="12" )"
          R"(black_level_dn="50" prnu="0.01"/>)"));
  return scenario;
}

TEST_CASE("the height of a tower is the parallax between bands that look ahead and back",
          "[end_to_end][sensor]") {
  TinyScenario scenario;
  scenario.bodies = sun_overhead;
  scenario.materials += R"(<material name="white" reflectance="1"/>)";
  scenario.materials += R"(<material name="black" reflectance="0"/>)";
  constexpr double tower_m = 60.0;
  scenario.geometry = R"(<plane material="black" size_x_m="2000" size_y_m="2000"/>)"
                      R"(<box material="black" lo_m="-10 -10 0" hi_m="10 10 59.99"/>)"
                      R"(<box material="white" lo_m="-10 -10 59.99" hi_m="10 10 60"/>)";
  scenario.platform = flight;
  // 2 mm of 20 mm: a tenth. The ground comes 200 line periods earlier or later than straight below.
  constexpr double tangent = 0.1;
  const double delay_s = tangent * height_m / speed_m_s;
  const auto band = [&](const std::string& name, const std::string& offset_um, double start_s) {
    return row(name, R"(samples="60" lines="160" offset_y_um=")" + offset_um + "\"",
               R"(<pushbroom line_period_ms="10" start_s=")" + std::to_string(start_s) + R"("/>)");
  };
  const double middle_s = -79.5 * line_period_s;
  scenario.camera = pushbroom_camera(band("ahead", "2000", middle_s - delay_s) +
                                     band("back", "-2000", middle_s + delay_s));
  scenario.samples = 4;
  const sim::support::ScratchFolder folder;
  const fs::path out = products_of(folder, scenario, "out");
  const auto centre_line = [&](const std::string& name) {
    const std::vector<float> radiance = first_plane(out / (name + "_radiance.img"));
    double sum = 0.0, moment = 0.0;
    for (std::size_t i = 0; i < radiance.size(); ++i) {
      const double line = static_cast<double>(i / 60) + 0.5;
      sum += static_cast<double>(radiance[i]);
      moment += line * static_cast<double>(radiance[i]);
    }
    return moment / sum;
  };
  // The roof, h nearer, is met h tan(angle) of flight later ahead, as much earlier behind. Edges
  // are good to a fraction of a line of 16 paths a pixel over 40 pixels; the sun's disc and the
  // aircraft's round way cost less.
  const double expected = 2.0 * tower_m * tangent / (speed_m_s * line_period_s);
  CHECK(centre_line("ahead") - centre_line("back") == Approx(expected).margin(0.05));
}

TEST_CASE("digital numbers give the radiance back within half a step", "[end_to_end][sensor]") {
  TinyScenario scenario = noisy_scenario();
  const sim::support::ScratchFolder folder;
  scenario.camera = pushbroom_camera(
      "<array name=\"a\" samples=\"40\" lines=\"50\" pitch_um=\"10\"><pushbroom "
      "line_period_ms=\"10\"/><published_noise bits=\"12\" saturation_radiance=\"200\"/>"
      "<band_box name=\"b\" lo_um=\"0.549\" hi_um=\"0.551\" reference_radiance=\"100\" "
      "snr=\"1e6\"/></array>");
  const fs::path out = products_of(folder, scenario, "out");
  const std::vector<float> radiance = first_plane(out / "a_radiance.img");
  const auto image = sim::read_envi(out / "a_dn.img");
  const auto& dn = std::get<std::vector<std::vector<std::uint16_t>>>(image.planes).front();
  REQUIRE(image.header.gains.size() == 1);
  const double gain = image.header.gains.front(), offset = image.header.offsets.front();
  CHECK(gain == Approx(200.0 / 4095.0).epsilon(1e-3));  // the range over its steps
  double worst = 0.0;
  for (std::size_t i = 0; i < dn.size(); ++i) {
    worst = std::max(worst, std::abs(dn[i] * gain + offset - static_cast<double>(radiance[i])));
  }
  CHECK(worst <= 0.51 * gain);  // half a step and noise of a thousandth of one
  CHECK(worst > 0.0);
}

TEST_CASE("one render gives many noisy images", "[end_to_end][sensor]") {
  const TinyScenario scenario = noisy_scenario();
  const sim::support::ScratchFolder folder;
  const fs::path one = products_of(folder, scenario, "one");
  const fs::path two = products_of(folder, scenario, "two", "--noise-seed 2");
  using sim::support::content_of;
  CHECK(content_of(one / "a_radiance.img") == content_of(two / "a_radiance.img"));
  CHECK(content_of(one / "a_dn.img") != content_of(two / "a_dn.img"));
  // The numbers of another seed without another render.
  const auto result = run_nadir("detect " + (folder / "tiny.xml").string() + " --output " +
                                one.string() + " --seed 2");
  CAPTURE(result.err);
  REQUIRE(result.exit_code == 0);
  CHECK(content_of(one / "a_dn_2.img") == content_of(two / "a_dn.img"));
}

TEST_CASE("a moving camera's image of several strips does not depend on threads",
          "[end_to_end][sensor]") {
  TinyScenario scenario = noisy_scenario();
  scenario.platform += R"(<jitter white_x_urad="50" white_y_urad="20" white_z_urad="0"/>)";
  // 2048 lines of 64 samples are a strip: two strips and some lines.
  scenario.camera = pushbroom_camera(
      row("a", R"(samples="64" lines="4112")",
          R"(<pushbroom line_period_ms="10" exposure_ms="4" tdi_stages="4"/>)"
          R"(<optics f_number="4"/><diffraction/><photon_detector efficiency="0.5" )"
          R"(line_noise_e="30" line_correlation="0.9" full_well_e="50000" bits="12"/>)"));
  scenario.products = R"(truth="true" sidecars="false")";
  const sim::support::ScratchFolder folder;
  const fs::path one = products_of(folder, scenario, "one", "--threads 1");
  const fs::path three = products_of(folder, scenario, "three", "--threads 3");
  int compared = 0;
  for (const auto& entry : fs::directory_iterator{one}) {
    const fs::path name = entry.path().filename();
    if (name == "report.json" || name == "samples.nadir") continue;  // clock, order of work
    CAPTURE(name.string());
    const bool same =
        sim::support::content_of(entry.path()) == sim::support::content_of(three / name);
    CHECK(same);
    ++compared;
  }
  CHECK(compared > 10);
}

}  // namespace
}  // namespace nadir::end_to_end
