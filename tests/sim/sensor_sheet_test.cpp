#include "sim/products/sensor_sheet.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

#include "camera_support.hpp"
#include "core/error.hpp"
#include "end_to_end/command.hpp"
#include "sensor/detector/photon_yield.hpp"
#include "sim/files/atomic_file.hpp"
#include "sim/files/spectrum_file.hpp"
#include "sim/run/detect.hpp"
#include "support/catch.hpp"

// Data sheets of cameras, and the detectors of a camera strip by strip.

namespace nadir::sim {
namespace {

constexpr double height_m = 1000.0;

/// Stands still over the origin and looks straight down, image top north.
sensor::Platform looking_down(double up_m) {
  return sensor::Platform{
      sensor::from_euler({0.0, 0.0, up_m}, Mat3{}, degrees(0.0), degrees(-90.0), degrees(0.0))};
}

/// 50 mm, 10 um: 0.2 m from 1000 m.
sensor::DetectorArray sheet_array(int samples, int lines) {
  sensor::DetectorArray array;
  array.name = "cam";
  array.samples = samples;
  array.lines = lines;
  array.projection = sensor::Perspective{0.05};
  array.pitch_m = 10e-6;
  array.bands.push_back({"red", spectral::BoxResponse{Micrometres{0.63}, Micrometres{0.69}}});
  array.bands.push_back({"heat", spectral::BoxResponse{Micrometres{8.0}, Micrometres{12.0}}});
  array.timing.exposure_s = 1e-3;
  return array;
}

sensor::Detector sheet_detector() {
  sensor::PhotonDetector element;
  element.efficiency = 0.5;
  element.area_m2 = 1e-10;
  element.read_noise_e = 20.0;
  element.full_well_e = 1e6;
  sensor::Detector detector;
  detector.optics.f_number = 4.0;
  detector.element = element;
  return detector;
}

Camera sheet_camera(sensor::DetectorArray array) {
  Camera camera;
  camera.platform = looking_down(height_m);
  camera.electronics = {{{sheet_detector(), 20.0}, {sensor::Detector{}, std::nullopt}}};
  auto& heat = *camera.electronics[0][1].detector;
  heat.element = sensor::fit_noise({{9.0, 0.01}});
  heat.digitiser.saturation = 25.0;
  camera.arrays.push_back(std::move(array));
  camera.instrument_name = "eye";
  return camera;
}

SheetGround ground_below(double speed_m_s = 0.0) {
  SheetGround ground;
  ground.height_m = height_m;
  ground.ground_speed_m_s = speed_m_s;
  return ground;
}

Camera pushbroom_camera(double line_period_s) {
  sensor::DetectorArray array = sheet_array(100, 500);
  array.timing.scan = sensor::Pushbroom{0.0, line_period_s};
  return sheet_camera(array);
}

}  // namespace

// NASA's typical radiances of bands 20, 29, 31 and 32 are Planck's at 300 K over the specified
// limits (MODIS Specifications, modis.gsfc.nasa.gov/about/specifications.php): half a unit of the
// last digit. Aqua's band 20, as it was built, lies 0.03 um further to the red than specified and
// sees 6.5 % more: `measured` is the mean over the response, by a trapezoid rule over its table
// outside of this program.
TEST_CASE("the band-mean radiance of MODIS at 300 K is the published one", "[sim][sensor]") {
  struct Published {
    const char* band;
    double lo_um, hi_um, radiance, measured;
  };
  const auto file = std::filesystem::path{NADIR_SOURCE_DIR} / "scenes" / "library" / "responses" /
                    "modis_aqua.csv";
  const SpectrumFile table = read_spectrum_file(file);
  for (const Published& p : {Published{"band_20", 3.66, 3.84, 0.450, 0.47943},
                             Published{"band_29", 8.40, 8.70, 9.583, 9.58286},
                             Published{"band_31", 10.78, 11.28, 9.555, 9.55539},
                             Published{"band_32", 11.77, 12.27, 8.946, 8.93035}}) {
    CAPTURE(p.band);
    const spectral::Response specified =
        spectral::BoxResponse{Micrometres{p.lo_um}, Micrometres{p.hi_um}};
    CHECK(sensor::band_planck(specified, Kelvin{300.0}) == Approx(p.radiance).margin(0.0005));
    const spectral::Response built = spectral::TabulatedResponse{
        curve_in(table, p.band, SpectrumQuantity::response, spectral::Outside::zero)};
    CHECK(sensor::band_planck(built, Kelvin{300.0}) == Approx(p.measured).epsilon(2e-5));
  }
}

// pitch / focal length x height; the earth's curvature changes 0.2 m by less than 1e-6 of it.
TEST_CASE("a frame's ground sampling follows from its focal length", "[sim][sensor]") {
  const SensorSheet sheet = sensor_sheet(sheet_camera(sheet_array(100, 80)), ground_below());
  const sensor::BandFigures& f = sheet.bands.at(0).figures;
  CHECK(f.gsd_x_m == Approx(0.2).epsilon(1e-6));
  CHECK(f.gsd_y_m == Approx(0.2).epsilon(1e-6));
  CHECK(f.swath_m == Approx(20.0).epsilon(1e-6));
  CHECK(sheet.bands[0].motion.y_px_s == 0.0);
  CHECK(sheet.ground_speed_m_s == 0.0);
  CHECK(f.centre_um == Approx(0.66).epsilon(1e-12));
}

// Nothing but the detector's area: sinc(1/2) = 2 / pi.
TEST_CASE("a square detector alone has an MTF of two over pi at Nyquist", "[sim][sensor]") {
  const SensorSheet sheet = sensor_sheet(sheet_camera(sheet_array(100, 80)), ground_below());
  const double expected = 2.0 / std::numbers::pi;
  CHECK(sheet.bands[0].figures.mtf_nyquist_x == Approx(expected).epsilon(1e-12));
  CHECK(sheet.bands[0].figures.mtf_nyquist_y == Approx(expected).epsilon(1e-12));
}

TEST_CASE("a pushbroom whose speed nobody tells moves a pixel a line", "[sim][sensor]") {
  const SensorSheet sheet = sensor_sheet(pushbroom_camera(2e-3), ground_below());
  CHECK(sheet.bands[0].motion.y_px_s == Approx(500.0).epsilon(1e-9));
  CHECK(sheet.bands[0].motion.x_px_s == Approx(0.0).margin(1e-6));
  CHECK(sheet.ground_speed_m_s == Approx(100.0).epsilon(1e-6));
  CHECK(sheet.bands[0].figures.gsd_y_m == Approx(0.2).epsilon(1e-6));
  // Exposed for half of the line's period: sinc(1/2) sinc(1/4).
  const double smear = std::sin(std::numbers::pi / 4.0) / (std::numbers::pi / 4.0);
  CHECK(sheet.bands[0].figures.mtf_nyquist_y ==
        Approx(2.0 / std::numbers::pi * smear).epsilon(1e-9));
  CHECK(sheet.bands[0].figures.mtf_nyquist_x == Approx(2.0 / std::numbers::pi).epsilon(1e-9));
}

TEST_CASE("a pushbroom's lines are as far apart as the ground moves", "[sim][sensor]") {
  const SensorSheet sheet = sensor_sheet(pushbroom_camera(2e-3), ground_below(75.0));
  CHECK(sheet.bands[0].figures.gsd_y_m == Approx(0.15).epsilon(1e-6));
  CHECK(sheet.bands[0].figures.gsd_x_m == Approx(0.2).epsilon(1e-6));
}

// Due north at 100 m/s and 1000 m over the ground: what a fixed pixel looks at moves at that speed
// less 1000 m over the earth's radius, 1.6e-4 of it.
TEST_CASE("the image of a camera that flies moves with the ground", "[sim][sensor]") {
  Camera camera = pushbroom_camera(2e-3);
  sensor::PlatformDescription flight;
  flight.track =
      sensor::Track{{-10.0, 10.0}, {{0.0, -1000.0, height_m}, {0.0, 1000.0, height_m}}, 2};
  flight.attitude = sensor::TrackAttitude{};
  const SheetGround ground = ground_below();
  camera.platform = sensor::Platform{flight, ground.frame, -0.1, 1.1};
  const SensorSheet sheet = sensor_sheet(camera, ground);
  CHECK(sheet.ground_speed_m_s == Approx(100.0).epsilon(1e-3));
  CHECK(sheet.bands[0].motion.y_px_s == Approx(500.0).epsilon(1e-3));
  CHECK(sheet.bands[0].motion.x_px_s == Approx(0.0).margin(0.1));
  CHECK(sheet.bands[0].figures.gsd_y_m == Approx(0.2).epsilon(1e-3));
}

// 0.03 rad in 100 samples: 0.3 m a sample, though a detector sees 0.2 m. Tangents within 0.015 rad:
// 1e-4 of the swath.
TEST_CASE("a whiskbroom's samples are as far apart as its mirror turns", "[sim][sensor]") {
  sensor::DetectorArray array = sheet_array(100, 10);
  constexpr double period_s = 1e-4;
  array.timing.scan = sensor::Whiskbroom{0.0, period_s, 0.02, 10};
  array.timing.exposure_s = period_s;
  Camera camera = sheet_camera(array);
  sensor::PlatformDescription still;
  still.track = sensor::Track{Vec3{0.0, 0.0, height_m}};
  still.attitude = sensor::EulerAttitude{degrees(0.0), degrees(-90.0), degrees(0.0)};
  sensor::ScanMount mirror;
  mirror.first_rad = -0.015;
  mirror.last_rad = 0.015;
  mirror.start_s = -0.5 * period_s;
  mirror.sweep_s = 100.0 * period_s;
  mirror.period_s = 0.02;
  still.mounts = {sensor::Mount{{}, {}, mirror}};
  const SheetGround ground = ground_below();
  camera.platform = sensor::Platform{still, ground.frame, -0.01, 0.03};
  const sensor::BandFigures f = sensor_sheet(camera, ground).bands[0].figures;
  CHECK(f.gsd_x_m == Approx(0.3).epsilon(1e-3));
  CHECK(f.gsd_y_m == Approx(0.2).epsilon(1e-4));
  CHECK(f.swath_m == Approx(30.0).epsilon(1e-3));
  // Smeared by 1.5 detectors: sinc(1/2) sinc(3/4).
  const double smear = std::sin(0.75 * std::numbers::pi) / (0.75 * std::numbers::pi);
  CHECK(f.mtf_nyquist_x == Approx(2.0 / std::numbers::pi * smear).epsilon(1e-3));
}

// Half of a swath of 110 degrees from 705 km, on a sphere of the earth's mean radius: 1165 km
// (MODIS: 2330 km). The ellipsoid differs by its flattening, 1/300.
TEST_CASE("a wide swath follows the earth's curvature", "[sim][sensor]") {
  sensor::DetectorArray array = sheet_array(1000, 1);
  array.pitch_m = 2.0 * 0.05 * std::tan(55.0 * radians_per_degree) / 1000.0;
  Camera camera = sheet_camera(array);
  camera.platform = looking_down(705e3);
  SheetGround ground = ground_below();
  ground.height_m = 705e3;
  const double r = 6371e3, sine = (r + 705e3) / r * std::sin(55.0 * radians_per_degree);
  const double swath = 2.0 * r * (std::asin(sine) - 55.0 * radians_per_degree);
  CHECK(sensor_sheet(camera, ground).bands[0].figures.swath_m == Approx(swath).epsilon(0.004));
}

TEST_CASE("noise figures are those of the signal chain", "[sim][sensor]") {
  const Camera camera = sheet_camera(sheet_array(100, 80));
  const SensorSheet sheet = sensor_sheet(camera, ground_below());
  const sensor::BandFigures& red = sheet.bands.at(0).figures;
  const sensor::SignalChain chain{camera.arrays[0], 0, sheet_detector(), 1};
  CHECK(red.nedl.value() == Approx(chain.noise_equivalent_radiance(20.0)).epsilon(1e-14));
  CHECK(red.snr.value() == Approx(20.0 / *red.nedl).epsilon(1e-14));
  CHECK(red.saturation.value() == Approx(chain.saturation_radiance()).epsilon(1e-14));
  CHECK_FALSE(red.nedt_k.has_value());
  const sensor::BandFigures& heat = sheet.bands.at(1).figures;
  CHECK_FALSE(heat.snr.has_value());
  const double radiance = sensor::band_planck(camera.arrays[0].bands[1].response, Kelvin{300.0});
  const double nedl = 0.01 * std::sqrt(0.5 + 0.5 * radiance / 9.0);
  const double slope =
      sensor::band_planck_derivative(camera.arrays[0].bands[1].response, Kelvin{300.0});
  CHECK(heat.nedt_k.value() == Approx(nedl / slope).epsilon(1e-9));
  CHECK(heat.saturation.value() == Approx(25.0).epsilon(1e-12));
}

TEST_CASE("a camera that sees no ground has no ground sampling", "[sim][sensor]") {
  Camera camera = sheet_camera(sheet_array(100, 80));
  camera.platform = sensor::Platform{
      sensor::from_euler({0.0, 0.0, height_m}, Mat3{}, degrees(0.0), degrees(45.0), degrees(0.0))};
  const SensorSheet sheet = sensor_sheet(camera, ground_below());
  CHECK(std::isnan(sheet.bands[0].figures.gsd_x_m));
  CHECK(sheet_json(sheet).find("\"gsd_x_m\": null") != std::string::npos);
  CHECK_THROWS_AS(sensor_sheet(camera, SheetGround{}), InputError);
}

TEST_CASE("the sheet's table has a row a band", "[sim][sensor]") {
  const SensorSheet sheet = sensor_sheet(sheet_camera(sheet_array(100, 80)), ground_below());
  const std::string text = sheet_text(sheet);
  CHECK(text.find("eye\n1000 m over the ground, which passes at 0 m/s\n") == 0);
  CHECK(text.find("\ncam    red     0.66   0.06    0.2    0.2   0.02        20   76.2") !=
        std::string::npos);
  CHECK(text.find("\ncam    heat      10      4    0.2    0.2   0.02         -      -") !=
        std::string::npos);
  CHECK(std::count(text.begin(), text.end(), '\n') == 7);
}

TEST_CASE("the plot of the MTF has a panel a direction, terms dashed", "[sim][sensor]") {
  const SensorSheet sheet = sensor_sheet(pushbroom_camera(2e-3), ground_below());
  const LinePlot plot = mtf_plot(sheet, "heat");
  REQUIRE(plot.panels.size() == 2);
  CHECK(plot.panels[0].series.size() == 3);  // two bands and the detector
  CHECK(plot.panels[1].series.size() == 4);  // and the smear
  CHECK_FALSE(plot.panels[1].series[1].dashed);
  CHECK(plot.panels[1].series[3].dashed);
  CHECK(plot.x.size() == plot.panels[0].series[0].y.size());
  CHECK(to_svg(plot).find("<svg") != std::string::npos);
  CHECK_THROWS_AS(mtf_plot(sheet, "haet"), InputError);
}

namespace {

ArrayImage strip_of(const Camera& camera, int first, int lines) {
  const sensor::DetectorArray& array = camera.arrays[0];
  ArrayImage strip;
  strip.name = array.name;
  strip.samples = array.samples;
  strip.lines = lines;
  strip.first_line = first;
  strip.all_lines = array.lines;
  for (const sensor::Band& band : array.bands) {
    BandImage& image = strip.bands.emplace_back();
    image.name = band.name;
    for (std::size_t i = 0; i < strip.pixels(); ++i) {
      const auto place =
          i + static_cast<std::size_t>(first) * static_cast<std::size_t>(array.samples);
      image.radiance.push_back(static_cast<float>(5.0 + 0.01 * static_cast<double>(place % 700)));
    }
  }
  return strip;
}

/// Numbers of all lines, cut into strips of so many.
std::vector<std::uint16_t> sensor_sheet_numbers(const Camera& camera, int lines,
                                                std::uint64_t seed) {
  DetectorStage stage{camera, ProductsInput{}, seed};
  std::vector<std::uint16_t> all;
  for (int first = 0; first < camera.arrays[0].lines; first += lines) {
    ArrayImage strip = strip_of(camera, first, std::min(lines, camera.arrays[0].lines - first));
    stage.apply(0, strip);
    all.insert(all.end(), strip.bands[0].dn.begin(), strip.bands[0].dn.end());
  }
  return all;
}

Camera striped_camera() {
  Camera camera = sheet_camera(sheet_array(30, 50));
  auto& element = std::get<sensor::PhotonDetector>(camera.electronics[0][0].detector->element);
  element.line_noise_e = 50.0;
  element.line_correlation = 0.5;
  element.prnu = 0.01;
  return camera;
}

}  // namespace

TEST_CASE("how an image is cut into strips does not show in its numbers", "[sim][sensor]") {
  const Camera camera = striped_camera();
  const auto whole = sensor_sheet_numbers(camera, 50, 4);
  CHECK(whole.size() == 1500);
  CHECK(whole == sensor_sheet_numbers(camera, 7, 4));
  CHECK(whole == sensor_sheet_numbers(camera, 1, 4));
  CHECK(whole != sensor_sheet_numbers(camera, 50, 5));
}

TEST_CASE("detectors fill what was asked for, of bands that have them", "[sim][sensor]") {
  Camera camera = sheet_camera(sheet_array(30, 50));
  ProductsInput wanted;
  wanted.electrons = true;
  DetectorStage stage{camera, wanted, 1};
  CHECK(stage.any());
  CHECK(stage.complete(0));
  ArrayImage strip = strip_of(camera, 0, 50);
  stage.apply(0, strip);
  CHECK(strip.bands[0].electrons.size() == 1500);
  CHECK(strip.bands[0].noise.size() == 1500);
  CHECK(strip.bands[1].electrons.empty());  // published noise knows none
  CHECK(strip.bands[1].dn.size() == 1500);
  CHECK(stage.calibrations().at(0).at(1).gain == Approx(25.0 / 4095.0).epsilon(1e-12));
  camera.electronics[0][1].detector.reset();
  const DetectorStage half{camera, ProductsInput{}, 1};
  CHECK_FALSE(half.complete(0));
  CHECK(half.calibrations().at(0).at(1).gain == 1.0);
  camera.electronics.clear();
  const DetectorStage none{camera, ProductsInput{}, 1};
  CHECK_FALSE(none.any());
  CHECK(none.calibrations().at(0).empty());
}

TEST_CASE("strips out of order are refused", "[sim][sensor]") {
  const Camera camera = sheet_camera(sheet_array(30, 50));
  DetectorStage stage{camera, ProductsInput{}, 1};
  ArrayImage strip = strip_of(camera, 10, 5);
  CHECK_THROWS_AS(stage.apply(0, strip), std::invalid_argument);
}

TEST_CASE("a detector that cannot be is named with its band", "[sim][sensor]") {
  Camera camera = sheet_camera(sheet_array(30, 50));
  camera.electronics[0][0].detector->optics.f_number = 0.0;
  try {
    const DetectorStage stage{camera, ProductsInput{}, 1};
    FAIL("accepted");
  } catch (const InputError& error) {
    CHECK(std::string{error.what()} ==
          "error: detector of band red of array cam: expected an f-number above 0, found 0\n");
  }
}

TEST_CASE("a sheet that cannot be made for what was asked is bad input", "[sim][sensor]") {
  const support::ScratchFolder folder;
  write_file(folder / "twin.xml", test::pushbroom_sensor);
  const auto asked = [&](const std::string& options) {
    return end_to_end::run_nadir("sensor " + (folder / "twin.xml").string() + " " + options);
  };
  CHECK(asked("--height 1000 --speed 50 --plot " + (folder / "mtf.svg").string()).exit_code == 0);
  CHECK(std::filesystem::exists(folder / "mtf.svg"));
  const auto nowhere = asked("--plot " + (folder / "none" / "mtf.svg").string());
  CHECK(nowhere.exit_code == 2);
  CHECK(nowhere.err.find("there is no folder " + (folder / "none").string()) != std::string::npos);
  CHECK(asked("--plot " + (folder / "").string()).exit_code == 2);
  for (const char* number : {"nan", "inf", "0", "-3", "1e12", "high"}) {
    CAPTURE(number);
    const auto height = asked("--height " + std::string{number});
    CHECK(height.exit_code == 2);
    CHECK(height.err.find("expected a number above 0 and at most 1e+10 m, found ") !=
          std::string::npos);
    CHECK(asked("--speed " + std::string{number}).exit_code == 2);
  }
}

}  // namespace nadir::sim
