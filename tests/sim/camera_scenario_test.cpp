#include "camera_support.hpp"
#include "support/catch.hpp"

using namespace nadir;
using namespace nadir::sim;
using nadir::test::green_band;
using nadir::test::mistake_lines;
using nadir::test::read_text;
using nadir::test::with_array;
using nadir::test::with_camera;

namespace {

const std::string band = green_band;

ArrayInput array_with(const std::string& inside, const std::string& attributes = {}) {
  return read_text(with_array(inside, attributes)).camera.arrays.at(0);
}

/// Two arrays of one perspective camera, the second in line 24.
std::string two_arrays(const std::string& first, const std::string& first_inside,
                       const std::string& second, const std::string& second_inside) {
  return with_camera("<perspective focal_length_mm=\"50\">\n<array name=\"a\" pitch_um=\"10\" " +
                     first + ">\n" + first_inside + "\n" + band +
                     "</array>\n<array name=\"b\" pitch_um=\"10\" " + second + ">\n" +
                     second_inside + "\n" + band + "</array></perspective>\n");
}

}  // namespace

TEST_CASE("a camera without any of the new parts is what it was", "[scenario][camera]") {
  const CameraInput camera = read_text(with_array(band)).camera;
  CHECK_FALSE(camera.orthographic);
  CHECK(camera.lens.focal_length_mm == 50.0);
  CHECK(camera.lens.k1 == 0.0);
  CHECK(camera.lens.principal_x_um == 0.0);
  const ArrayInput& array = camera.arrays.at(0);
  CHECK(std::get<GlobalShutterInput>(array.timing).exposure_ms == 0.0);
  CHECK(array.fill_x == 1.0);
  CHECK(array.pitch_y_um == 0.0);
  CHECK(array.modules.empty());
  CHECK(array.blur.is_none());
  CHECK_FALSE(array.detector);
  CHECK_FALSE(array.optics);
}

TEST_CASE("the lens of a camera and of an array arrive in the plain data", "[scenario][camera]") {
  const Scenario s = read_text(with_camera(
      R"(<perspective focal_length_mm="5.4" k1="-0.1" k2="0.02" p1="1e-3" p2="-2e-3" k3="0.003"
        principal_x_um="12" principal_y_um="-7">
        <array name="a" samples="100" lines="40" pitch_um="10">)" +
      band + R"(</array><array name="b" samples="100" lines="40" pitch_um="10" own_lens="true">
        <lens focal_length_mm="8" k1="0.5"/>)" +
      band + "</array></perspective>"));
  const LensInput& lens = s.camera.lens;
  CHECK(lens.k1 == -0.1);
  CHECK(lens.k2 == 0.02);
  CHECK(lens.p1 == 1e-3);
  CHECK(lens.p2 == -2e-3);
  CHECK(lens.k3 == 0.003);
  CHECK(lens.principal_x_um == 12.0);
  CHECK(lens.principal_y_um == -7.0);
  CHECK_FALSE(s.camera.arrays[0].lens);
  CHECK(s.camera.arrays[1].own_lens);
  CHECK(s.camera.arrays[1].lens->focal_length_mm == 8.0);
  CHECK(s.camera.arrays[1].lens->k1 == 0.5);
}

TEST_CASE("every timing arrives in the plain data", "[scenario][camera]") {
  const auto timing = [](const std::string& text) { return array_with(text + band).timing; };
  const auto global =
      std::get<GlobalShutterInput>(timing(R"(<global_shutter exposure_ms="2" delay_ms="-3"/>)"));
  CHECK(global.exposure_ms == 2.0);
  CHECK(global.delay_ms == -3.0);
  const auto rolling = std::get<RollingShutterInput>(
      timing(R"(<rolling_shutter line_period_ms="0.03" exposure_ms="8"/>)"));
  CHECK(rolling.line_period_ms == 0.03);
  CHECK(rolling.exposure_ms == 8.0);  // longer than the line period: lines overlap in time
  CHECK_FALSE(rolling.start_s);
  const auto push = std::get<PushbroomInput>(
      timing(R"(<pushbroom line_period_ms="4.4" exposure_ms="3.6" start_s="-2" tdi_stages="8"
                tdi_direction="behind"/>)"));
  CHECK(push.exposure_ms == 3.6);
  CHECK(push.start_s == -2.0);
  CHECK(push.tdi_stages == 8);
  CHECK(push.tdi_behind);
  const auto whisk = std::get<WhiskbroomInput>(
      timing(R"(<whiskbroom sample_period_us="333" scan_period_ms="1477" lines_per_scan="10"
                exposure_us="323.3"/>)"));
  CHECK(whisk.sample_period_us == 333.0);
  CHECK(whisk.scan_period_ms == 1477.0);
  CHECK(whisk.lines_per_scan == 10);
  CHECK(whisk.exposure_us == 323.3);
  const auto bolometer =
      std::get<BolometerInput>(timing(R"(<bolometer time_constant_ms="9" line_period_us="32"/>)"));
  CHECK(bolometer.time_constant_ms == 9.0);
  CHECK(bolometer.line_period_us == 32.0);
}

TEST_CASE("an image without a start is centred on the scenario's time", "[scenario][camera]") {
  // 101 lines: the 51st, number 50, is at time 0.
  CHECK(first_exposure_s(PushbroomInput{2.0, 1.0}, 10, 101) == Approx(-0.1).epsilon(1e-12));
  CHECK(first_exposure_s(RollingShutterInput{2.0, 1.0}, 10, 101) == Approx(-0.1).epsilon(1e-12));
  CHECK(first_exposure_s(BolometerInput{9.0, 32.0}, 10, 101) == Approx(-1.6e-3).epsilon(1e-12));
  CHECK(first_exposure_s(PushbroomInput{2.0, 1.0, 7.0}, 10, 101) == 7.0);
  CHECK(first_exposure_s(GlobalShutterInput{2.0, 30.0}, 10, 101) == Approx(0.03).epsilon(1e-12));
  // Three sweeps 1 s apart, each of 11 samples over 10 x 10 ms: 2.1 s from first to last.
  CHECK(first_exposure_s(WhiskbroomInput{10000.0, 1000.0, 4, 0.0}, 11, 12) ==
        Approx(-1.05).epsilon(1e-12));
}

TEST_CASE("modules come sorted", "[scenario][camera]") {
  const auto modules =
      array_with(R"(<module first_sample="60" samples="40" offset_x_um="1" offset_y_um="-30"
                    rotation_deg="0.5"/><module first_sample="0" samples="60"/>
                    <pushbroom line_period_ms="1"/>)" +
                 band)
          .modules;
  REQUIRE(modules.size() == 2);
  CHECK(modules[0].samples == 60);
  CHECK(modules[1].first_sample == 60);
  CHECK(modules[1].offset_x_um == 1.0);
  CHECK(modules[1].offset_y_um == -30.0);
  CHECK(modules[1].rotation_deg == 0.5);
}

TEST_CASE("optics, blur and photon detector arrive in the plain data", "[scenario][camera]") {
  const ArrayInput array = array_with(
      R"(<optics f_number="2.8" obscuration="0.3" transmittance="0.8" falloff_power="3"
          temperature_k="290" emissivity="0.1" shield_temperature_k="80"/>
      <diffraction/><gaussian_blur sigma_x_um="2"/><gaussian_blur sigma_x_um="1" sigma_y_um="3"/>
      <stray_light share="0.01" core_um="50" slope="1.2" reach_um="4000"/>
      <global_shutter exposure_ms="1"/>
      <photon_detector efficiency="0.6" dark_e_s="100" temperature_k="300" read_noise_e="7"
          line_noise_e="2" line_correlation="0.5" prnu="0.01" dsnu_e="3" full_well_e="30000"
          bits="14" black_level_dn="64" gain_dn_e="0.5" flat="false" dead_share="1e-4"
          pattern_seed="9"/>
      <band_gaussian name="r" centre_um="0.65" fwhm_um="0.02" reference_radiance="22"
          efficiency="0.5" transmittance="0.7"/>)",
      R"(fill_x="0.8" fill_y="0.9" pitch_y_um="11")");
  CHECK(array.pitch_y_um == 11.0);
  CHECK(array.fill_x == 0.8);
  CHECK(array.fill_y == 0.9);
  CHECK(array.optics->shield_temperature_k == 80.0);
  CHECK(array.optics->falloff_power == 3.0);
  CHECK(array.blur.diffraction->f_number == 2.8);  // that of the optics
  CHECK(array.blur.diffraction->obscuration == 0.3);
  REQUIRE(array.blur.gaussians.size() == 2);
  CHECK(array.blur.gaussians[0].sigma_y_um == 2.0);  // as along x
  CHECK(array.blur.gaussians[1].sigma_y_um == 3.0);
  CHECK(array.blur.stray->slope == 1.2);
  CHECK(array.blur.stray->reach_um == 4000.0);
  const auto& photons = std::get<PhotonDetectorInput>(array.detector->element);
  CHECK(photons.efficiency == 0.6);
  CHECK_FALSE(photons.area_um2);
  CHECK_FALSE(photons.dark_reference_k);
  CHECK(photons.dark_doubling_k == 7.0);
  CHECK(photons.line_correlation == 0.5);
  CHECK(photons.prnu == 0.01);
  CHECK(array.detector->bits == 14);
  CHECK(array.detector->black_level_dn == 64.0);
  CHECK(array.detector->gain_dn_e == 0.5);
  CHECK_FALSE(array.detector->flat);
  CHECK(array.detector->pattern_seed == 9);
  CHECK(array.bands[0].reference_radiance == 22.0);
  CHECK(array.bands[0].efficiency == 0.5);
  CHECK(array.bands[0].transmittance == 0.7);
}

TEST_CASE("published figures of noise arrive in the plain data", "[scenario][camera]") {
  const ArrayInput array = array_with(
      R"(<published_noise bits="12" saturation_radiance="600"/>
      <band_box name="r" lo_um="0.6" hi_um="0.7" reference_radiance="22" snr="90">
        <snr_at radiance="100" snr="200"/></band_box>
      <band_box name="t" lo_um="10.6" hi_um="11.2" nedt_k="0.05" saturation_temperature_k="360">
        <nedt_at temperature_k="270" nedt_k="0.057"/></band_box>)");
  REQUIRE(array.bands[0].figures.size() == 2);
  CHECK(std::get<SnrFigure>(array.bands[0].figures[0]).radiance == 22.0);
  CHECK(std::get<SnrFigure>(array.bands[0].figures[1]).snr == 200.0);
  CHECK(array.bands[0].saturation_radiance == 600.0);
  CHECK(std::get<NedtFigure>(array.bands[1].figures[0]).temperature_k == 300.0);
  CHECK(std::get<NedtFigure>(array.bands[1].figures[1]).nedt_k == 0.057);
  CHECK_FALSE(array.bands[1].saturation_radiance);
  CHECK(array.bands[1].saturation_temperature_k == 360.0);
}

TEST_CASE("exposures fit into their periods", "[scenario][camera][mistakes]") {
  CHECK(nadir::test::mistakes(
            with_array(R"(<pushbroom line_period_ms="4.4" exposure_ms="5"/>)" + band)) ==
        R"(test.xml:21:33: error: exposure_ms is 5, longer than line_period_ms, which is 4.4
    21 | <pushbroom line_period_ms="4.4" exposure_ms="5"/><band_box name="g" lo_um="0.5" hi_um="0.6"/>
       |                                 ^
)");
  CHECK(mistake_lines(with_array(R"(<whiskbroom sample_period_us="300" scan_period_ms="20" )"
                                 R"(lines_per_scan="7" exposure_us="400"/>)" +
                                 band)) ==
        "20:31: 40 lines are not a whole number of sweeps of 7\n"
        "21:36: a sweep of 100 samples takes 30 ms, longer than scan_period_ms, which is 20\n"
        "21:75: exposure_us is 400, longer than sample_period_us, which is 300\n");
}

TEST_CASE("an array has one timing and one detector", "[scenario][camera][mistakes]") {
  CHECK(mistake_lines(with_array(R"(<global_shutter/><pushbroom line_period_ms="1"/>)" + band)) ==
        "21:18: <array> holds only one timing; <global_shutter> stands in line 21 already\n");
  CHECK(mistake_lines(with_array("<stray_light share=\"0\" core_um=\"1\" reach_um=\"2\"/>\n"
                                 "<stray_light share=\"0\" core_um=\"1\" reach_um=\"2\"/>" +
                                 band)) ==
        "22:1: <array> holds only one <stray_light>; <stray_light> stands in line 21 already\n");
  CHECK(mistake_lines(with_array("<global_shutter/>")) ==
        "20:1: <array> needs <band> or <band_box> or <band_gaussian>\n");
}

TEST_CASE("modules have every sample once", "[scenario][camera][mistakes]") {
  const auto told_of = [](const std::string& modules) {
    return mistake_lines(with_array(modules + band));
  };
  CHECK(told_of("<module first_sample=\"0\" samples=\"40\"/>\n"
                "<module first_sample=\"50\" samples=\"50\"/>") ==
        "22:9: this module begins at sample 50, but those before it end before 40 (samples between "
        "would belong to no module)\n");
  CHECK(told_of("<module first_sample=\"0\" samples=\"60\"/>\n"
                "<module first_sample=\"50\" samples=\"50\"/>") ==
        "22:9: this module begins at sample 50, but those before it end before 60 (samples would "
        "belong to two modules)\n");
  CHECK(told_of("<module first_sample=\"0\" samples=\"60\"/>") ==
        "21:26: the modules have 60 samples, array \"a\" has 100\n");
  CHECK(told_of("<pushbroom line_period_ms=\"1\"/><module first_sample=\"0\" samples=\"50\"/>\n"
                "<module first_sample=\"50\" samples=\"50\" offset_x_um=\"-5\"/>") ==
        "20:1: the modules of array \"a\" that begin at samples 0 and 50 lie at the same place of "
        "the focal plane\n");
}

TEST_CASE("arrays of one camera that lie at the same place are a mistake",
          "[scenario][camera][mistakes]") {
  const std::string row = R"(<pushbroom line_period_ms="1"/>)";
  const std::string hint =
      " (move it by its offsets, or give it own_lens=\"true\" if it has a lens or a beam splitter "
      "of its own)\n";
  const std::string told =
      "23:1: array \"b\" lies where array \"a\" (line 20) is on the focal plane";
  const std::string size = R"(samples="100" lines="40")";
  CHECK(mistake_lines(two_arrays(size, row, size, row)) == told + hint);
  // half a pixel apart is not apart; a row apart is, to either side
  CHECK(mistake_lines(two_arrays(size, row, size + R"( offset_y_um="5")", row)) == told + hint);
  CHECK(mistake_lines(two_arrays(size, row, size + R"( offset_y_um="10")", row)).empty());
  CHECK(mistake_lines(two_arrays(size, row, size + R"( offset_y_um="-10")", row)).empty());
  CHECK(mistake_lines(two_arrays(size, row, size + R"( offset_x_um="1000")", row)).empty());
  CHECK(mistake_lines(two_arrays(size, row, size + R"( own_lens="true")", row)).empty());
  // rows of time-delay integration lie around the array's centre
  const std::string stages = R"(<pushbroom line_period_ms="1" tdi_stages="5"/>)";
  CHECK(mistake_lines(two_arrays(size, stages, size + R"( offset_y_um="20")", row)) == told + hint);
  CHECK(mistake_lines(two_arrays(size, stages, size + R"( offset_y_um="30")", row)).empty());
  // turned by 10 degrees a row of 1 mm reaches 87 um up at its end
  const std::string turned = row + R"(<module first_sample="0" samples="100" rotation_deg="10"/>)";
  CHECK(mistake_lines(two_arrays(size, turned, size + R"( offset_y_um="80")", row)) == told + hint);
  CHECK(mistake_lines(two_arrays(size, turned, size + R"( offset_y_um="105")", row)).empty());
}

TEST_CASE("frames may share their field by a beam splitter", "[scenario][camera]") {
  const std::string size = R"(samples="100" lines="40")";
  CHECK(mistake_lines(two_arrays(size, "", size, "")).empty());
  CHECK(mistake_lines(two_arrays(size, "", R"(samples="50" lines="20" offset_x_um="100")", ""))
            .empty());
  // but not a part of it only
  CHECK_FALSE(mistake_lines(two_arrays(size, "", size + R"( offset_x_um="100")", "")).empty());
}

TEST_CASE("what needs optics or an exposure says so", "[scenario][camera][mistakes]") {
  CHECK(mistake_lines(with_array("<diffraction/>" + band)) ==
        "21:1: <diffraction> of array \"a\" needs an f_number: its own or that of <optics>\n");
  CHECK(mistake_lines(
            with_array(R"(<photon_detector efficiency="0.5" full_well_e="1e5"/>)" + band)) ==
        "21:1: <photon_detector> of array \"a\" needs <optics>, with its f_number\n"
        "21:1: <photon_detector> of array \"a\" needs an exposure, which its timing does not give "
        "(without a timing all detectors see at one moment: add <global_shutter exposure_ms>)\n");
  CHECK(mistake_lines(with_array(R"(<optics f_number="1"/><bolometer time_constant_ms="9"/>
<photon_detector efficiency="0.5" full_well_e="1e5"/>)" +
                                 band)) ==
        "22:1: <photon_detector> of array \"a\" counts in an exposure, which a <bolometer> has not "
        "(use <published_noise>)\n");
  CHECK(mistake_lines(with_array("<lens focal_length_mm=\"3\"/>" + band)) ==
        "21:1: <lens> of array \"a\" needs own_lens=\"true\"\n");
}

TEST_CASE("figures of noise go with published_noise", "[scenario][camera][mistakes]") {
  CHECK(mistake_lines(with_array("<published_noise/>" + band)) ==
        "21:19: no figure of noise of band \"g\", whose array has <published_noise> (give "
        "reference_radiance and snr, or nedt_k, or <snr_at>, <nedt_at> in it)\n"
        "21:19: band \"g\" needs its saturation_radiance or saturation_temperature_k, or "
        "<published_noise> one for all\n");
  CHECK(mistake_lines(with_array(
            R"(<band_box name="g" lo_um="0.5" hi_um="0.6" snr="100" efficiency="0.5"/>)")) ==
        "21:44: snr of band \"g\" needs its reference_radiance\n"
        "21:44: snr of band \"g\" needs <published_noise> in its array\n"
        "21:54: efficiency of band \"g\" needs <photon_detector> in its array\n");
  CHECK(mistake_lines(
            with_array(R"(<published_noise/><band_box name="g" lo_um="0.5" hi_um="0.6" snr="100" )"
                       R"(reference_radiance="40" saturation_radiance="30"/>)")) ==
        "21:96: band \"g\" saturates at 30, not above its reference_radiance 40\n");
  CHECK(mistake_lines(with_array(
            R"(<published_noise black_level_dn="300" bits="8" saturation_radiance="30"/>
<band_box name="g" lo_um="8" hi_um="9" nedt_k="1"/>)")) ==
        "21:18: black_level_dn is 300, the largest number of 8 bits is 255\n");
}

TEST_CASE("an orthographic camera takes timing and blur, but no aperture", "[scenario][camera]") {
  const auto text = [](const std::string& inside) {
    return with_camera(
        "<orthographic>\n<array name=\"a\" samples=\"4\" lines=\"3\" "
        "ground_pitch_m=\"1\" ground_pitch_y_m=\"2\">\n" +
        inside + band + "</array></orthographic>\n");
  };
  const ArrayInput array =
      read_text(text(R"(<pushbroom line_period_ms="1"/><gaussian_blur sigma_x_um="5e5"/>)"))
          .camera.arrays.at(0);
  CHECK(array.ground_pitch_y_m == 2.0);
  CHECK(array.blur.gaussians.at(0).sigma_x_um == 5e5);
  CHECK(mistake_lines(text("<diffraction/>")).find("<array> may not hold <diffraction>") !=
        std::string::npos);
  CHECK(mistake_lines(text(R"(<optics f_number="2"/><global_shutter exposure_ms="1"/>
<photon_detector efficiency="0.5" full_well_e="1e5"/>)")) ==
        "22:1: <photon_detector> of array \"a\" needs area_um2: an orthographic camera's pitch is "
        "not that of its detectors\n");
}
