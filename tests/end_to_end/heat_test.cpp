#include <algorithm>
#include <cmath>
#include <string>

#include "end_to_end/tiny_scenario.hpp"
#include "support/catch.hpp"

// Whole runs whose temperatures are solved, and the command that shows them.

namespace nadir::end_to_end {
namespace {

using sim::support::content_of;
using sim::support::ScratchFolder;

/// Soil beside a black roof, seen from above, without air between them and the camera.
struct HeatScenario {
  std::string time = "2026-06-21T20:00:00Z";
  std::string heat =
      R"(<heat resolution_m="20"><clear_sky air_low_c="14" air_high_c="28"/></heat>)";
  std::string band = R"(<band_box name="b" lo_um="8" hi_um="12"/>)";
  std::string geometry = R"(<plane name="ground" material="soil" size_x_m="200" size_y_m="200"/>)";
  std::string products = R"(exr="false" quick_look="false")";
  int samples = 2;  ///< pixels across

  [[nodiscard]] std::string text() const {
    return "<scenario name=\"tiny\">\n<time utc=\"" + time +
           "\"/>\n<site latitude_deg=\"36\" longitude_deg=\"-84\" height_m=\"300\"/>\n"
           "<illumination><ephemeris/></illumination>\n<atmosphere><uniform "
           "solar_transmittance=\"0.75\" sky_radiance=\"30\" sky_temperature_k=\"265\"/>"
           "</atmosphere>\n" +
           heat +
           "\n<materials>\n"
           "<material name=\"soil\" reflectance=\"0\"><heat_balance solar_absorptance=\"0.8\">"
           "<layer conductivity_w_m_k=\"1\" density_kg_m3=\"1600\" specific_heat_j_kg_k=\"1000\"/>"
           "</heat_balance></material>\n"
           "<material name=\"sheet\" reflectance=\"0\"><heat_balance back=\"open\">"
           "<layer conductivity_w_m_k=\"45\" density_kg_m3=\"7800\" specific_heat_j_kg_k=\"480\" "
           "thickness_m=\"0.001\"/></heat_balance></material>\n"
           "<material name=\"leaf\" reflectance=\"0\"><air_temperature "
           "offset_k=\"2\"/></material>\n"
           "<material name=\"stated\" reflectance=\"0\" temperature_c=\"40\"/>\n"
           "</materials>\n<geometry>" +
           geometry +
           "</geometry>\n<platform><position><local east_m=\"0\" north_m=\"0\" up_m=\"50\"/>"
           "</position><attitude><euler yaw_deg=\"0\" pitch_deg=\"-90\"/></attitude></platform>\n"
           "<camera><orthographic><array name=\"a\" samples=\"" +
           std::to_string(samples) + "\" lines=\"1\" ground_pitch_m=\"8\">" + band +
           "</array></orthographic></camera>\n"
           "<sampling replicates=\"4\" samples_per_replicate=\"1\" wavelengths_per_band=\"2\"/>\n"
           "<products " +
           products + "/>\n</scenario>\n";
  }
};

struct HeatRun {
  std::vector<float> brightness_k, temperature_k;
  std::string report;
};

std::vector<std::vector<float>> planes_of(const std::filesystem::path& image) {
  return std::get<std::vector<std::vector<float>>>(sim::read_envi(image).planes);
}

HeatRun run_heat(const HeatScenario& scenario, const std::string& options = "--threads 1") {
  const ScratchFolder folder;
  write_file(folder / "tiny.xml", scenario.text());
  const auto out = folder / "out";
  const auto result = run_nadir("run " + (folder / "tiny.xml").string() + " --quiet " + options +
                                " -o " + out.string());
  CAPTURE(result.err);
  REQUIRE(result.exit_code == 0);
  HeatRun run;
  run.report = content_of(out / "report.json");
  run.temperature_k = planes_of(out / "a_truth.img").at(1);
  const auto brightness = out / "a_brightness.img";
  if (std::filesystem::exists(brightness)) run.brightness_k = first_plane(brightness);
  return run;
}

/// What `nadir temperature` prints as the temperature.
double told_kelvin(const HeatScenario& scenario, const std::string& point) {
  const ScratchFolder folder;
  write_file(folder / "tiny.xml", scenario.text());
  const auto result =
      run_nadir("temperature " + (folder / "tiny.xml").string() + " --point=" + point);
  CAPTURE(result.out, result.err);
  REQUIRE(result.exit_code == 0);
  const std::string label = "temperature ";
  const auto at = result.out.find(label);
  REQUIRE(at != std::string::npos);
  return std::stod(result.out.substr(at + label.size()));
}

TEST_CASE("a picture, its truth plane and nadir temperature agree", "[end_to_end][heat]") {
  const HeatScenario scenario;
  const HeatRun run = run_heat(scenario);
  const double told = told_kelvin(scenario, "-4,0.5");
  CHECK(told > 310.0);  // dry soil at three in the afternoon of a June day, in a light wind
  CHECK(told < 345.0);
  // Two decimals are printed; a pixel of 8 m lies in one or two cells of 20 m, alike to 0.5 K.
  CHECK(static_cast<double>(run.temperature_k.at(0)) == Approx(told).margin(0.5));
  CHECK(run.report.find("\"heat\": {") != std::string::npos);
  CHECK(run.report.find("\"cells_ahead\":") != std::string::npos);
}

TEST_CASE("a visible picture by day solves nothing and reads no weather", "[end_to_end][heat]") {
  HeatScenario scenario;
  scenario.band = R"(<band_box name="b" lo_um="0.5" hi_um="0.7"/>)";
  const ScratchFolder folder;
  write_file(folder / "w.csv", "this is no weather\n");
  scenario.heat = "<heat><weather_file file=\"" + (folder / "w.csv").string() + "\"/></heat>";
  const HeatRun run = run_heat(scenario);
  CHECK(run.report.find("\n  \"heat\": {") == std::string::npos);
  CHECK(run.report.find("w.csv") == std::string::npos);
  CHECK(run.report.find("sunlight_at_ground") == std::string::npos);
  CHECK(std::isnan(run.temperature_k.at(0)));  // the truth plane: nobody asked
}

TEST_CASE("the truth plane has temperatures where the scenario asks for them",
          "[end_to_end][heat]") {
  HeatScenario visible, infrared;
  visible.band = R"(<band_box name="b" lo_um="0.5" hi_um="0.7"/>)";
  visible.products += R"( truth_temperature="true")";
  CHECK(run_heat(visible).temperature_k == run_heat(infrared).temperature_k);
}

TEST_CASE("solved pictures have the same bytes on one thread and on two", "[end_to_end][heat]") {
  HeatScenario scenario;
  scenario.geometry += R"(<box name="box" material="sheet" lo_m="-3 -3 0" hi_m="1 3 4"/>)";
  scenario.samples = 6;
  const HeatRun one = run_heat(scenario, "--threads 1"), two = run_heat(scenario, "--threads 2");
  CHECK(one.temperature_k == two.temperature_k);
}

TEST_CASE("what stood in the sun's way until shortly before leaves its footprint",
          "[end_to_end][heat]") {
  HeatScenario bare, left;
  bare.heat = left.heat =
      R"(<heat resolution_m="2"><clear_sky air_low_c="14" air_high_c="28"/></heat>)";
  left.geometry += R"(<box name="car" material="sheet" lo_m="-12 -6 0.2" hi_m="12 6 1.5" )"
                   R"(present_until="2026-06-21T19:30:00Z"/>)";
  const double warm = told_kelvin(bare, "0.3,0.4"), cold = told_kelvin(left, "0.3,0.4");
  CHECK(cold < warm - 5.0);
  // The car itself is not in the picture.
  CHECK(std::abs(static_cast<double>(run_heat(left).temperature_k.at(0)) - cold) < 3.0);
}

TEST_CASE("leaves follow the weather's air, and parts what they are told to",
          "[end_to_end][heat]") {
  HeatScenario scenario;
  scenario.geometry =
      R"(<plane name="leaf" material="leaf" size_x_m="40" size_y_m="40"/>)"
      R"(<plane name="lid" material="leaf" temperature_c="50" size_x_m="4" size_y_m="4" east_m="60"/>)"
      R"(<plane name="pan" material="soil" temperature_of="stated" size_x_m="4" size_y_m="4" east_m="80"/>)";
  // The day's high falls two hours after solar noon, which is at 17:38 UTC: near 20:00 it is 28 C.
  CHECK(told_kelvin(scenario, "0,0") == Approx(273.15 + 28.0 + 2.0).margin(0.3));
  CHECK(told_kelvin(scenario, "60,0") == Approx(323.15).margin(0.01));
  CHECK(told_kelvin(scenario, "80,0") == Approx(313.15).margin(0.01));
}

TEST_CASE("nadir temperature draws the day's curves and writes every step", "[end_to_end][heat]") {
  const ScratchFolder folder;
  write_file(folder / "tiny.xml", HeatScenario{}.text());
  const auto result =
      run_nadir("temperature " + (folder / "tiny.xml").string() + " --point=-4,0.5 --plot " +
                (folder / "t.svg").string() + " --csv " + (folder / "t.csv").string());
  CAPTURE(result.out, result.err);
  REQUIRE(result.exit_code == 0);
  CHECK(result.out.find("surface     soil of ground\n") != std::string::npos);
  CHECK(result.out.find("UTC               surface    back     air") != std::string::npos);
  const std::string csv = content_of(folder / "t.csv");
  CHECK(csv.rfind("utc,surface_c,back_c,air_c,sun_absorbed_w_m2,", 0) == 0);
  CHECK(std::count(csv.begin(), csv.end(), '\n') == 1 + 144);  // a day of 10 min steps
  CHECK(content_of(folder / "t.svg").find("into the layers") != std::string::npos);
}

TEST_CASE("nadir temperature tells of places that have no curve", "[end_to_end][heat]") {
  const ScratchFolder folder;
  HeatScenario scenario;
  scenario.geometry = R"(<plane name="lid" material="stated" size_x_m="4" size_y_m="4"/>)";
  write_file(folder / "tiny.xml", scenario.text());
  const std::string command = "temperature " + (folder / "tiny.xml").string();
  const auto missed = run_nadir(command + " --point=100,0");
  CHECK(missed.exit_code == 2);
  CHECK(missed.err.find("nothing of the scene lies below east 100 m, north 0 m") !=
        std::string::npos);
  const auto stated = run_nadir(command + " --point=0,0 --plot " + (folder / "t.svg").string());
  CHECK(stated.exit_code == 2);
  CHECK(stated.out.find("stated, not solved") != std::string::npos);
  CHECK(stated.err.find("there is nothing to plot or write") != std::string::npos);
  CHECK_FALSE(std::filesystem::exists(folder / "t.svg"));
  const auto points = run_nadir(command + " --point=1");
  CHECK(points.exit_code == 2);
}

}  // namespace
}  // namespace nadir::end_to_end
