#include "sim/scenario/sensor_file.hpp"

#include <cmath>

#include "camera_support.hpp"
#include "message_of.hpp"
#include "sim/scenario/input_paths.hpp"
#include "support/catch.hpp"

using namespace nadir;
using namespace nadir::sim;
using nadir::sim::support::message_of;
using test::pushbroom_sensor;
using test::replaced;

namespace {

void write_sensor(const std::filesystem::path& file, const std::string& text) {
  std::ofstream{file, std::ios::binary} << text;
}

/// The minimal scenario in a folder of its own, with the sensor file beside it.
struct PresetScenario {
  test::TemporaryFolder folder;
  std::string sensor = pushbroom_sensor;

  [[nodiscard]] Scenario read(const std::string& attributes) const {
    write_sensor(folder / "twin.xml", sensor);
    Diagnostics diagnostics;
    return parse_scenario(test::with_camera("<sensor file=\"twin.xml\" " + attributes + "/>\n"),
                          folder / "scenario.xml", diagnostics);
  }
  [[nodiscard]] CameraInput camera(const std::string& attributes) const {
    return read(attributes).camera;
  }
  /// Messages with line and column, without the folder and the lines of text.
  [[nodiscard]] std::string mistakes(const std::string& attributes) const {
    try {
      static_cast<void>(read(attributes));
      return {};
    } catch (const InputError& error) {
      std::string lines;
      for (const InputIssue& issue : error.issues()) {
        lines += std::filesystem::path{issue.where.file}.filename().string() + ":" +
                 std::to_string(issue.where.line) + ":" + std::to_string(issue.where.column) +
                 ": " + issue.message + (issue.hint.empty() ? "" : " (" + issue.hint + ")") + "\n";
      }
      return lines;
    }
  }
};

/// Place of an image's sample centre on the focal plane, um; modules of small turns.
Vec2 place_of_sample(const ArrayInput& array, double sample) {
  const double ideal = (sample - 0.5 * array.samples) * array.pitch_um;
  for (const ModuleInput& module : array.modules) {
    if (sample < module.first_sample || sample > module.first_sample + module.samples) continue;
    const double middle =
        (module.first_sample + 0.5 * module.samples - 0.5 * array.samples) * array.pitch_um;
    const double turn = module.rotation_deg * std::acos(-1.0) / 180.0;
    return {array.offset_x_um + middle + (ideal - middle) * std::cos(turn) + module.offset_x_um,
            array.offset_y_um + (ideal - middle) * std::sin(turn) + module.offset_y_um};
  }
  return {array.offset_x_um + ideal, array.offset_y_um};
}

}  // namespace

TEST_CASE("a sensor file arrives in the plain data", "[scenario][sensor_file]") {
  const test::TemporaryFolder folder;
  write_sensor(folder / "twin.xml", pushbroom_sensor);
  CHECK(is_sensor_file(folder / "twin.xml"));
  CHECK_FALSE(is_sensor_file(test::data_folder() / "minimal.xml"));
  const SensorInput sensor = read_sensor_file(folder / "twin.xml");
  CHECK(sensor.name == "twin");
  CHECK(sensor.title == "Two rows");
  CHECK(sensor.source == "a test");
  CHECK(sensor.nominal_height_m == 5e5);
  CHECK(sensor.ground_speed_m_s == 7000.0);
  CHECK(sensor.camera.platform_name == "bird");
  CHECK(sensor.camera.name == "twin");
  CHECK(sensor.camera.lens.focal_length_mm == 1000.0);
  REQUIRE(sensor.camera.arrays.size() == 2);
  CHECK(sensor.camera.arrays[0].modules.size() == 2);
}

TEST_CASE("a scenario takes a sensor whole", "[scenario][sensor_file]") {
  const PresetScenario preset;
  const CameraInput camera = preset.camera("");
  CHECK(camera.sensor_file == preset.folder / "twin.xml");
  CHECK(camera.name == "twin");
  REQUIRE(camera.arrays.size() == 2);
  CHECK(camera.arrays[0].samples == 1000);
  CHECK(camera.arrays[0].lines == 200);
  CHECK_FALSE(camera.arrays[0].is_cut);
  CHECK(camera.lens.focal_length_mm == 1000.0);
}

TEST_CASE("a part of a sensor's arrays and of a pass keeps its place and its time",
          "[scenario][sensor_file]") {
  const PresetScenario preset;
  const CameraInput whole = preset.camera("");
  const CameraInput cut =
      preset.camera(R"(arrays="ms pan" samples="300" first_sample="400" lines="50")");
  REQUIRE(cut.arrays.size() == 2);
  CHECK(cut.arrays[0].samples == 300);
  CHECK(cut.arrays[0].lines == 50);
  CHECK(cut.arrays[1].samples == 600);  // pixels of half the size, lines in half the time
  CHECK(cut.arrays[1].lines == 100);
  // Pixels stay where they were on the focal plane, those of turned modules as well.
  for (const double sample : {0.5, 50.5, 99.5, 100.5, 250.5}) {
    const Vec2 before = place_of_sample(whole.arrays[0], sample + 400.0);
    const Vec2 after = place_of_sample(cut.arrays[0], sample);
    CHECK(after.x == Approx(before.x).margin(1e-9));  // um; rounding of 1e4 um
    CHECK(after.y == Approx(before.y).margin(1e-9));
    const Vec2 fine_before = place_of_sample(whole.arrays[1], sample + 800.0);
    CHECK(place_of_sample(cut.arrays[1], sample).x == Approx(fine_before.x).margin(1e-9));
  }
  REQUIRE(cut.arrays[0].modules.size() == 2);
  CHECK(cut.arrays[0].modules[0].samples == 100);
  CHECK(cut.arrays[0].modules[1].first_sample == 100);
  CHECK(cut.arrays[0].modules[1].samples == 200);
  const double start = first_exposure_s(cut.arrays[0].timing, 300, 50);
  CHECK(start == Approx(-0.5 * 49 * 1.5e-3).epsilon(1e-12));  // centred anew
}

TEST_CASE("without a first sample the middle of the array is taken", "[scenario][sensor_file]") {
  const CameraInput cut = PresetScenario{}.camera(R"(arrays="pan" samples="10" lines="7000")");
  REQUIRE(cut.arrays.size() == 1);
  CHECK(cut.arrays[0].name == "pan");
  CHECK(cut.arrays[0].first_sample == 995);
  CHECK(cut.arrays[0].offset_x_um == Approx(0.0).margin(1e-9));
  CHECK(cut.arrays[0].lines == 7000);  // passes may be longer than the file says
}

TEST_CASE("start_s sets the start of every pass", "[scenario][sensor_file]") {
  for (const ArrayInput& array : PresetScenario{}.camera(R"(start_s="-2.5")").arrays) {
    CHECK(first_exposure_s(array.timing, array.samples, array.lines) == -2.5);
  }
}

TEST_CASE("a part of a rolling frame keeps its time", "[scenario][sensor_file]") {
  PresetScenario preset;
  preset.sensor = replaced(preset.sensor, R"(<pushbroom line_period_ms="1.5" exposure_ms="1"/>)",
                           R"(<rolling_shutter line_period_ms="1"/>)");
  preset.sensor = replaced(preset.sensor, R"(offset_y_um="100")", R"(offset_y_um="5000")");
  preset.sensor = replaced(preset.sensor, R"( rotation_deg="0.1")", "");
  preset.sensor = replaced(preset.sensor, R"( offset_y_um="30")", "");
  preset.sensor = replaced(preset.sensor, R"( offset_y_um="-30")", "");
  const ArrayInput cut = preset.camera(R"(arrays="ms" lines="20" first_line="150")").arrays.at(0);
  CHECK(cut.lines == 20);
  CHECK(cut.offset_y_um == Approx(-100.0 + (160.0 - 100.0) * 20.0).epsilon(1e-12));
  // line 150 of 200, centred: 50.5 ms after the middle
  CHECK(first_exposure_s(cut.timing, cut.samples, cut.lines) == Approx(0.0505).epsilon(1e-12));
}

TEST_CASE("a part of a whiskbroom's sweeps keeps the mirror's time", "[scenario][sensor_file]") {
  PresetScenario preset;
  preset.sensor = R"(<sensor name="w" nominal_height_m="7e5"><perspective focal_length_mm="400">
<array name="tir" samples="1354" lines="100" pitch_um="540">
<whiskbroom sample_period_us="333" scan_period_ms="1477" lines_per_scan="10"/>
<band_box name="b" lo_um="10" hi_um="11"/></array></perspective></sensor>)";
  const ArrayInput whole = preset.camera(R"(lines="47")").arrays.at(0);
  CHECK(whole.lines == 50);  // whole sweeps
  const ArrayInput cut =
      preset.camera(R"(lines="47" samples="100" first_sample="1000")").arrays.at(0);
  CHECK(cut.offset_x_um == 0.0);
  CHECK(first_exposure_s(cut.timing, cut.samples, cut.lines) -
            first_exposure_s(whole.timing, whole.samples, whole.lines) ==
        Approx(0.333).epsilon(1e-12));  // 1000 samples later
}

TEST_CASE("what a sensor has not is told of at the scenario's element",
          "[scenario][sensor_file][mistakes]") {
  const PresetScenario preset;
  CHECK(preset.mistakes(R"(arrays="ms pam ms")") ==
        "scenario.xml:19:25: the sensor has no array \"pam\" (did you mean \"pan\"?)\n"
        "scenario.xml:19:25: array \"ms\" is named twice\n");
  CHECK(preset.mistakes(R"(samples="1001")") ==
        "scenario.xml:19:25: samples is 1001, but array \"ms\" has 1000\n");
  CHECK(preset.mistakes(R"(samples="10" first_sample="991")") ==
        "scenario.xml:19:38: first_sample 991 and samples 10 reach beyond the 1000 of array "
        "\"ms\"\n");
  CHECK(preset.mistakes(R"(first_sample="9")") ==
        "scenario.xml:19:25: first_sample needs samples\n");
  CHECK(preset.mistakes(R"(first_line="9" lines="10")") ==
        "scenario.xml:19:25: first_line cuts frames, but array \"ms\" is scanned (start_s says "
        "when its pass begins)\n");
}

TEST_CASE("mistakes of a sensor file name it, and are told with the scenario's",
          "[scenario][sensor_file][mistakes]") {
  PresetScenario preset;
  preset.sensor = replaced(preset.sensor, R"(exposure_ms="0.7")", R"(exposure_ms="0.8")");
  CHECK(preset.mistakes("") ==
        "twin.xml:11:34: exposure_ms is 0.8, longer than line_period_ms, which is 0.75\n");
  preset.sensor = replaced(pushbroom_sensor, R"(offset_y_um="100")", R"(offset_y_um="-100")");
  preset.sensor = replaced(preset.sensor, R"(offset_y_um="30")", "");
  CHECK(preset.mistakes("") ==
        "twin.xml:10:1: array \"pan\" lies where array \"ms\" (line 4) is on the focal plane "
        "(move it by its offsets, or give it own_lens=\"true\" if it has a lens or a beam splitter "
        "of its own)\n");
  preset.sensor = "<scenario/>";
  CHECK(preset.mistakes("") == "twin.xml:1:1: expected the root <sensor>, found <scenario>\n");
}

TEST_CASE("a sensor file lies beside the scenario or in the shipped data",
          "[scenario][sensor_file]") {
  const test::TemporaryFolder folder;
  write_sensor(folder / "twin.xml", pushbroom_sensor);
  const InputPaths paths{folder / "scenario.xml"};
  CHECK(paths.absolute_or_shipped("twin.xml") == folder / "twin.xml");
  const auto shipped = std::filesystem::path{NADIR_SOURCE_DIR} / "scenes/library/materials.xml";
  CHECK(paths.absolute_or_shipped("library/materials.xml") == shipped);
  CHECK(paths.absolute_or_shipped("twig.xml") == folder / "twig.xml");
  const std::string told = message_of([&] {
    Diagnostics diagnostics;
    static_cast<void>(parse_scenario(test::with_camera("<sensor file=\"twim.xml\"/>"),
                                     folder / "scenario.xml", diagnostics));
  });
  CHECK(told.find("file \"twim.xml\" does not exist") != std::string::npos);
  CHECK(told.find("that folder holds \"twin.xml\"") != std::string::npos);
}
