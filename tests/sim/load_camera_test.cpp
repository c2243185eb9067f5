#include "sim/run/load_camera.hpp"

#include <cmath>

#include "camera_support.hpp"
#include "message_of.hpp"
#include "sim/run/load_camera_arrays.hpp"
#include "spectral/planck.hpp"
#include "support/catch.hpp"

using namespace nadir;
using namespace nadir::sim;
using nadir::sim::support::message_of;
using test::green_band;
using test::with_array;

namespace {

const std::string camera_band = green_band;

Camera load(const Scenario& scenario) {
  InputFiles files;
  return load_camera(scenario, geometry::LocalFrame{scenario.origin}, TerrainProbe{}, files);
}

Camera load_text(const std::string& text) { return load(test::read_text(text)); }

sensor::DetectorArray array_with_camera(const std::string& inside,
                                        const std::string& attributes = {}) {
  return load_text(with_array(inside + camera_band, attributes)).arrays.at(0);
}

void write(const std::filesystem::path& file, const std::string& text) {
  std::ofstream{file, std::ios::binary} << text;
}

}  // namespace

TEST_CASE("a plain frame is loaded as it always was", "[run][load_camera]") {
  const Camera camera = load_text(with_array(camera_band, R"(offset_x_um="100")"));
  const sensor::DetectorArray& array = camera.arrays.at(0);
  CHECK(std::get<sensor::Perspective>(array.projection).focal_length_m == 50.0 * 1e-3);
  CHECK(std::get<sensor::Perspective>(array.projection).distortion.is_none());
  CHECK(array.pitch_m == 10.0 * 1e-6);
  CHECK(array.offset_x_m == 100.0 * 1e-6);
  CHECK(std::get<sensor::GlobalShutter>(array.timing.scan).centre_s == 0.0);
  CHECK(array.timing.exposure_s == 0.0);
  CHECK(array.spread == nullptr);
  CHECK(camera.platform.is_fixed());
  REQUIRE(camera.electronics.size() == 1);
  CHECK_FALSE(camera.electronics[0].at(0).detector);
}

TEST_CASE("lengths and times arrive in metres and seconds", "[run][load_camera]") {
  // products of two doubles each: equal to the last digit or two
  const auto push = array_with_camera(
      R"(<pushbroom line_period_ms="4" exposure_ms="3" tdi_stages="3" tdi_direction="behind"/>
      <module first_sample="0" samples="100" offset_x_um="1" offset_y_um="-2" rotation_deg="0.1"/>)",
      R"(pitch_y_um="12" fill_x="0.9")");
  CHECK(push.pitch_y_m == Approx(12e-6).epsilon(1e-14));
  CHECK(push.fill_x == 0.9);
  CHECK(std::get<sensor::Pushbroom>(push.timing.scan).line_period_s == Approx(4e-3).epsilon(1e-14));
  CHECK(std::get<sensor::Pushbroom>(push.timing.scan).first_line_s ==
        Approx(-19.5 * 4e-3).epsilon(1e-14));
  CHECK(push.timing.exposure_s == Approx(3e-3).epsilon(1e-14));
  CHECK(push.timing.tdi_stages == 3);
  CHECK(push.timing.tdi_reversed);
  CHECK(push.modules.at(0).offset_y_m == Approx(-2e-6).epsilon(1e-14));
  CHECK(push.modules.at(0).rotation_rad == Approx(0.1 * std::acos(-1.0) / 180.0).epsilon(1e-14));
  const auto whisk = array_with_camera(R"(<whiskbroom sample_period_us="333" scan_period_ms="1477"
      lines_per_scan="10" exposure_us="323"/>)");
  const auto& scan = std::get<sensor::Whiskbroom>(whisk.timing.scan);
  CHECK(scan.sample_period_s == Approx(333e-6).epsilon(1e-14));
  CHECK(scan.scan_period_s == Approx(1.477).epsilon(1e-14));
  CHECK(scan.lines_per_scan == 10);
  CHECK(whisk.timing.exposure_s == Approx(323e-6).epsilon(1e-14));
  const auto rolling =
      array_with_camera(R"(<bolometer time_constant_ms="9" line_period_us="32"/>)");
  CHECK(rolling.timing.lag_s == Approx(9e-3).epsilon(1e-14));
  CHECK(rolling.timing.exposure_s == 0.0);
  CHECK(std::get<sensor::RollingShutter>(rolling.timing.scan).line_period_s ==
        Approx(32e-6).epsilon(1e-14));
  const auto frozen = array_with_camera(R"(<bolometer time_constant_ms="9" start_s="2"/>)");
  CHECK(std::get<sensor::GlobalShutter>(frozen.timing.scan).centre_s == 2.0);
}

TEST_CASE("offsets count from the principal point", "[run][load_camera]") {
  const Camera camera = load_text(test::with_camera(
      R"(<perspective focal_length_mm="5.4" k1="-0.1" principal_x_um="12" principal_y_um="-7">
        <array name="a" samples="100" lines="40" pitch_um="10" offset_x_um="20">)" +
      camera_band +
      R"(</array><array name="b" samples="100" lines="40" pitch_um="10" own_lens="true">
        <lens focal_length_mm="8" principal_x_um="1"/>)" +
      camera_band + "</array></perspective>"));
  CHECK(camera.arrays[0].offset_x_m == Approx(8e-6).epsilon(1e-14));
  CHECK(camera.arrays[0].offset_y_m == Approx(7e-6).epsilon(1e-14));
  CHECK(std::get<sensor::Perspective>(camera.arrays[0].projection).distortion.k1 == -0.1);
  CHECK(camera.arrays[1].offset_x_m == Approx(-1e-6).epsilon(1e-14));
  CHECK(std::get<sensor::Perspective>(camera.arrays[1].projection).distortion.is_none());
  CHECK(std::get<sensor::Perspective>(camera.arrays[1].projection).focal_length_m ==
        Approx(8e-3).epsilon(1e-14));
}

TEST_CASE("the span covers the exposures of all arrays", "[run][load_camera]") {
  const Camera camera = load_text(test::with_camera(
      R"(<perspective focal_length_mm="50"><array name="a" samples="9" lines="101" pitch_um="10">
        <pushbroom line_period_ms="10" exposure_ms="4"/>)" +
      camera_band +
      R"(</array><array name="b" samples="9" lines="11" pitch_um="10" offset_y_um="100">
        <pushbroom line_period_ms="10" start_s="3"/>)" +
      camera_band + "</array></perspective>"));
  const sensor::TimeSpan span = span_of(camera.arrays);
  // half a line before the first line's centre, half a line after the last one's
  CHECK(span.first_s == Approx(-0.505).epsilon(1e-12));
  CHECK(span.last_s == Approx(3.105).epsilon(1e-12));
}

TEST_CASE("a quantum curve weights radiance by its wavelength", "[run][load_camera]") {
  const test::TemporaryFolder folder;
  write(folder / "qe.csv", "wavelength_um,qe\n0.4,0.2\n0.5,0.6\n0.8,0.6\n");
  const auto response_of = [&](const std::string& kind) {
    Diagnostics diagnostics;
    const Scenario s = parse_scenario(
        with_array("<band name=\"q\" response=\"qe.csv\" response_kind=\"" + kind + "\"/>"),
        folder / "scenario.xml", diagnostics);
    return load(s).arrays.at(0).bands.at(0).response;
  };
  const auto radiance = response_of("radiance"), quantum = response_of("quantum");
  for (const double um : {0.4, 0.41, 0.4567, 0.5, 0.61, 0.8}) {
    const Micrometres w{um};
    CAPTURE(um);
    // promised between the table's rows for a slope like this one
    CHECK(spectral::at(quantum, w) == Approx(um * spectral::at(radiance, w)).epsilon(1e-5));
  }
  CHECK(spectral::at(quantum, Micrometres{0.5}) == Approx(0.3).epsilon(1e-12));
}

TEST_CASE("a photon detector's figures arrive in SI units", "[run][load_camera]") {
  const Camera camera = load_text(with_array(
      R"(<optics f_number="2.8" transmittance="0.8"/><global_shutter exposure_ms="1"/>
      <photon_detector efficiency="0.6" dark_e_s="100" temperature_k="250" full_well_e="3e4"
       bits="14"/>
      <band_box name="a" lo_um="0.5" hi_um="0.6" reference_radiance="40"/>
      <band_box name="b" lo_um="0.7" hi_um="0.8" efficiency="0.3" transmittance="0.5"/>)",
      R"(pitch_y_um="20" fill_x="0.5" fill_y="0.9")"));
  const BandElectronics& a = camera.electronics.at(0).at(0);
  CHECK(a.reference_radiance == 40.0);
  const auto& photons = std::get<sensor::PhotonDetector>(a.detector->element);
  CHECK(photons.area_m2 == Approx(10e-6 * 0.5 * 20e-6 * 0.9).epsilon(1e-12));
  CHECK(photons.efficiency == 0.6);
  CHECK(photons.dark_reference_k == 250.0);  // dark current as given, at the detector's temperature
  CHECK(a.detector->digitiser.bits == 14);
  CHECK(a.detector->optics.f_number == 2.8);
  const BandElectronics& b = camera.electronics.at(0).at(1);
  CHECK(std::get<sensor::PhotonDetector>(b.detector->element).efficiency == 0.3);
  CHECK(b.detector->optics.transmittance == 0.5);
}

TEST_CASE("a dark current that fills the well is told where the detector stands",
          "[run][load_camera]") {
  const auto dark = [](const std::string& dark_e_s) {
    return message_of([&] {
      (void)load_text(with_array(R"(<optics f_number="2.8"/><global_shutter exposure_ms="1"/>
      <photon_detector efficiency="0.6" dark_e_s=")" +
                                 dark_e_s + R"(" full_well_e="3e4"/>)" + camera_band));
    });
  };
  CHECK(dark("1e7") == "(nothing thrown)");  // 1e4 electrons
  const std::string message = dark("4e7");
  CHECK_THAT(message,
             Catch::Contains("test.xml:22:7: error: detector of band g of array a: dark current "
                             "(40000 electrons)"));
  CHECK_THAT(message, Catch::Contains("fill the well of 30000 in one exposure"));
}

TEST_CASE("published noise meets its figures", "[run][load_camera]") {
  const Camera camera = load_text(with_array(
      R"(<published_noise bits="12" saturation_radiance="600"/>
      <band_box name="r" lo_um="0.6" hi_um="0.7" reference_radiance="22" snr="90"/>
      <band_box name="t" lo_um="10.9" hi_um="11.1" nedt_k="0.05" saturation_temperature_k="360"/>)"));
  const auto noise_of = [&](std::size_t i, double radiance) {
    const auto& noise =
        std::get<sensor::PublishedNoise>(camera.electronics.at(0).at(i).detector->element);
    return std::sqrt(noise.alpha * noise.alpha + noise.beta * radiance);
  };
  CHECK(noise_of(0, 22.0) == Approx(22.0 / 90.0).epsilon(1e-12));
  CHECK(camera.electronics[0][0].detector->digitiser.saturation == 600.0);
  // A narrow band around 11 um is as one wavelength to 1e-4 (second order in 0.2 / 11).
  const Micrometres w{11.0};
  const double radiance = spectral::planck(w, Kelvin{300.0}).value;
  CHECK(noise_of(1, radiance) ==
        Approx(0.05 * spectral::planck_derivative(w, Kelvin{300.0})).epsilon(2e-4));
  CHECK(camera.electronics[0][1].detector->digitiser.saturation ==
        Approx(spectral::planck(w, Kelvin{360.0}).value).epsilon(2e-4));
}

TEST_CASE("MODIS's typical radiances are those of its bands at 300 K", "[run][load_camera]") {
  // Published (NASA): 0.45, 9.58, 9.55, 8.94 W m^-2 sr^-1 um^-1, by the nominal limits of the
  // bands; computed from them 0.450, 9.583, 9.555, 8.946. Half a unit of the last digit.
  struct Row {
    const char *lo, *hi;
    double radiance;
  };
  for (const Row& row : {Row{"3.660", "3.840", 0.450}, Row{"8.400", "8.700", 9.583},
                         Row{"10.780", "11.280", 9.555}, Row{"11.770", "12.270", 8.946}}) {
    const Camera camera = load_text(with_array(
        std::string{"<published_noise/><band_box name=\"b\" lo_um=\""} + row.lo + "\" hi_um=\"" +
        row.hi + "\" nedt_k=\"0.05\" saturation_temperature_k=\"300\"/>"));
    CHECK(camera.electronics[0][0].detector->digitiser.saturation ==
          Approx(row.radiance).margin(5.1e-4));
  }
}

TEST_CASE("blur is made ready for the bands", "[run][load_camera]") {
  const auto array = array_with_camera(R"(<optics f_number="4" obscuration="0.3"/><diffraction/>
      <gaussian_blur sigma_x_um="3"/><stray_light share="0.01" core_um="50" reach_um="4000"/>)");
  REQUIRE(array.spread != nullptr);
  const sensor::SpreadDescription& description = array.spread->description();
  CHECK(description.diffraction->f_number == 4.0);
  CHECK(description.diffraction->obscuration == 0.3);
  CHECK(description.gaussians.at(0).sigma_y_m == Approx(3e-6).epsilon(1e-14));
  CHECK(description.stray->reach_m == Approx(4e-3).epsilon(1e-14));
}

TEST_CASE("a measured point spread and measured lines of sight are read", "[run][load_camera]") {
  const test::TemporaryFolder folder;
  write(folder / "psf.csv", "# nadir-point-spread: 1\n# pitch_um: 2\nwavelength_um,0.5\n0.5,0.5\n");
  write(folder / "views.csv", "sample,across_deg,along_deg\n0.5,-2,1\n50.5,0,1\n99.5,1.96,1\n");
  const auto scenario = [&](const std::string& inside) {
    Diagnostics diagnostics;
    return parse_scenario(
        test::with_camera(
            "<lines_of_sight>\n<array name=\"a\" samples=\"100\" lines=\"40\" pitch_um=\"10\" "
            "file=\"views.csv\">" +
            inside + camera_band + "</array></lines_of_sight>"),
        folder / "scenario.xml", diagnostics);
  };
  const std::string row = R"(<pushbroom line_period_ms="1"/><blur_table file="psf.csv"/>)";
  const std::string told = message_of([&] { static_cast<void>(load(scenario(row))); });
  CHECK(told == (folder / "views.csv").string() +
                    ":3: error: sample 50.5 is not on an even grid: 3 from 0.5 to 99.5 have one at "
                    "50\n");
  write(folder / "views.csv", "sample,across_deg,along_deg\n0.5,-2,1\n99.5,1.96,1\n");
  InputFiles files;
  const Scenario good = scenario(row);
  const Camera camera = load_camera(good, geometry::LocalFrame{good.origin}, TerrainProbe{}, files);
  const auto& views = std::get<sensor::Tabulated>(camera.arrays.at(0).projection);
  REQUIRE(views != nullptr);
  CHECK(views->sample_step == 99.0);
  CHECK(camera.arrays[0].spread->description().table->columns == 2);
  CHECK(files.all().contains(folder / "views.csv"));
  CHECK(files.all().contains(folder / "psf.csv"));
  write(folder / "psf.csv", "# nadir-point-spread: 1\n# pitch_um: 2\nwavelength_um,0.5\n0.5,0.4\n");
  CHECK(message_of([&] { static_cast<void>(load(scenario(row))); }) ==
        (folder / "psf.csv").string() +
            ":3:1: error: the weights of this wavelength sum to 0.9, not to 1\n"
            "    3 | wavelength_um,0.5\n      | ^\n");
  write(folder / "views.csv", "sample,across_deg,along_deg\n0.5,-2,1\n89.5,1.96,1\n");
  CHECK(message_of([&] {
          static_cast<void>(load(scenario(row)));
        }).find("scenario.xml:20:1: error: array a: the view table ends at sample 89.5") !=
        std::string::npos);
}

TEST_CASE("a sensor file alone stands at its nominal height and looks down", "[run][load_camera]") {
  const test::TemporaryFolder folder;
  write(folder / "twin.xml", test::pushbroom_sensor);
  InputFiles files;
  Diagnostics diagnostics;
  const SensorSheetInput sheet = load_sensor_file(folder / "twin.xml", files, diagnostics);
  CHECK(sheet.title == "Two rows");
  CHECK(sheet.height_m == 5e5);
  CHECK(sheet.ground_speed_m_s == 7000.0);
  CHECK(sheet.camera.instrument_name == "twin");
  CHECK(sheet.camera.platform_name == "bird");
  CHECK(sheet.camera.arrays.size() == 2);
  const sensor::Pose pose = sheet.camera.platform.at(0.0);
  CHECK(pose.position == Vec3{0.0, 0.0, 5e5});
  CHECK(pose.axes.z.z == Approx(-1.0).epsilon(1e-14));
  CHECK(files.all().contains(folder / "twin.xml"));
  CHECK(diagnostics.messages().empty());
}
