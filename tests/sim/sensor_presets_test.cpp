#include <cmath>
#include <filesystem>
#include <map>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

#include "camera_support.hpp"
#include "sensor/detector/figures.hpp"
#include "sensor/detector/photon_yield.hpp"
#include "sensor/detector/signal_chain.hpp"
#include "sim/products/sensor_sheet.hpp"
#include "sim/run/load_camera.hpp"
#include "support/catch.hpp"

// The shipped sensors under scenes/sensors say what was published of them (docs/sensor-presets.md
// has the sources).

namespace nadir::sim {
namespace {

struct PresetBand {
  const sensor::DetectorArray& array;
  std::size_t index;
  const BandElectronics& electronics;

  [[nodiscard]] const spectral::Response& response() const { return array.bands[index].response; }
  [[nodiscard]] sensor::SignalChain chain() const {
    return {array, index, electronics.detector.value(), 0};
  }
  [[nodiscard]] double snr() const {
    const double radiance = electronics.reference_radiance.value();
    return radiance / chain().noise_equivalent_radiance(radiance);
  }
  [[nodiscard]] double nedt_k(double scene_k) const {
    const double radiance = sensor::band_planck(response(), Kelvin{scene_k});
    const double nedl = chain().noise_equivalent_radiance(radiance);
    return sensor::nedt(response(), nedl, Kelvin{scene_k}).value;
  }
};

struct Preset {
  SensorSheetInput input;
  std::vector<std::string> warnings;

  explicit Preset(const std::string& name) : input{load(name, warnings)} {}

  [[nodiscard]] PresetBand band(const std::string& name) const {
    const Camera& camera = input.camera;
    for (std::size_t a = 0; a < camera.arrays.size(); ++a) {
      for (std::size_t b = 0; b < camera.arrays[a].bands.size(); ++b) {
        if (camera.arrays[a].bands[b].name == name) {
          return {camera.arrays[a], b, camera.electronics.at(a).at(b)};
        }
      }
    }
    throw std::out_of_range{name};
  }
  /// Arrays as if of one piece: staggered modules look at places tens of kilometres apart.
  [[nodiscard]] SensorSheet sheet() const {
    Camera camera = input.camera;
    for (sensor::DetectorArray& array : camera.arrays) array.modules.clear();
    SheetGround ground;
    ground.height_m = input.height_m;
    ground.ground_speed_m_s = input.ground_speed_m_s;
    return sensor_sheet(camera, ground);
  }

 private:
  static SensorSheetInput load(const std::string& name, std::vector<std::string>& warnings) {
    InputFiles files;
    Diagnostics diagnostics;
    SensorSheetInput loaded = load_sensor_file(
        std::filesystem::path{NADIR_SOURCE_DIR} / "scenes/sensors" / (name + ".xml"), files,
        diagnostics);
    for (const std::string& text : diagnostics.messages()) warnings.push_back(text);
    return loaded;
  }
};

/// Seconds by which an odd module of a band sees a place before an even one does.
double odd_before_even_s(const Preset& preset, const std::string& band) {
  const sensor::DetectorArray& array = preset.band(band).array;
  const double focal_m = std::get<sensor::Perspective>(array.projection).focal_length_m;
  const double apart_m = array.modules.at(0).offset_y_m - array.modules.at(1).offset_y_m;
  return apart_m / focal_m * preset.input.height_m / preset.input.ground_speed_m_s;
}
/// Seconds from one band to another, in an even module.
double delay_s(const Preset& preset, const std::string& from, const std::string& to) {
  return 0.5 * (odd_before_even_s(preset, to) - odd_before_even_s(preset, from));
}

void check_sampling(const std::string& name, const std::map<std::string, double>& gsd_m) {
  const SensorSheet sheet = Preset{name}.sheet();
  std::size_t found = 0;
  for (const BandSheet& band : sheet.bands) {
    const auto expected = gsd_m.find(band.figures.band);
    if (expected == gsd_m.end()) continue;
    ++found;
    CAPTURE(name, band.figures.band);
    CHECK(band.figures.gsd_x_m == Approx(expected->second).epsilon(0.01));
    CHECK(band.figures.gsd_y_m == Approx(expected->second).epsilon(0.01));
  }
  CHECK(found == gsd_m.size());
}

constexpr const char* preset_names[] = {"landsat8_oli", "landsat8_tirs",     "sentinel2_msi",
                                        "modis_teb",    "uav_multispectral", "uncooled_longwave"};

}  // namespace

TEST_CASE("every preset loads without a warning and names its sources", "[sim][presets]") {
  for (const char* name : preset_names) {
    CAPTURE(name);
    const Preset preset{name};
    CHECK(preset.warnings.empty());
    CHECK_FALSE(preset.input.source.empty());
    CHECK_FALSE(preset.input.title.empty());
    CHECK_FALSE(preset.input.camera.instrument_name.empty());
    CHECK_FALSE(preset.input.camera.platform_name.empty());
    for (const auto& bands : preset.input.camera.electronics) {
      for (const BandElectronics& band : bands) CHECK(band.detector.has_value());
    }
  }
}

// Published: 30 m products of OLI from 28.65 m samples (36 um / 886 mm x 705 km), half of it in
// pan, 100 m of TIRS, 10, 20 and 60 m of MSI, 1 km of MODIS. Behind each stands a rounded focal
// length: 1 %.
TEST_CASE("Landsat's presets sample the ground as published", "[sim][presets]") {
  check_sampling("landsat8_oli", {{"red", 28.65}, {"swir2", 28.65}, {"pan", 14.32}});
  check_sampling("landsat8_tirs", {{"thermal1", 99.0}, {"thermal2", 99.0}});
}

TEST_CASE("Sentinel-2's preset samples the ground as published", "[sim][presets]") {
  check_sampling("sentinel2_msi", {{"B2", 10.0}, {"B5", 20.0}, {"B9", 60.0}, {"B11", 20.0}});
}

TEST_CASE("the presets of frames and of MODIS sample the ground as published", "[sim][presets]") {
  check_sampling("modis_teb", {{"band_31", 1000.0}});
  check_sampling("uav_multispectral", {{"nir", 0.0833}});
  check_sampling("uncooled_longwave", {{"lwir", 0.0857}});
}

// Landsat 185 km, MSI 290 km: what scenes are cut to, hence 3 %.
TEST_CASE("presets span the published swaths", "[sim][presets]") {
  CHECK(Preset{"landsat8_oli"}.sheet().bands[0].figures.swath_m == Approx(185e3).epsilon(0.03));
  CHECK(Preset{"landsat8_tirs"}.sheet().bands[0].figures.swath_m == Approx(185e3).epsilon(0.03));
  CHECK(Preset{"sentinel2_msi"}.sheet().bands[0].figures.swath_m == Approx(290e3).epsilon(0.03));
}

// The specified 2330 km, from a mirror that swings by 110 degrees as docs/sensor-presets.md says;
// the ellipsoid's curvature, which depends on latitude, is worth 0.3 %.
TEST_CASE("MODIS behind its scan mirror spans 2330 km", "[sim][presets]") {
  Preset preset{"modis_teb"};
  Camera& camera = preset.input.camera;
  for (sensor::DetectorArray& array : camera.arrays) {
    std::get<sensor::Whiskbroom>(array.timing.scan).first_sample_s = 0.0;  // start_s="0"
    array.lines = 10;
  }
  constexpr double degree = std::numbers::pi / 180.0;
  sensor::ScanMount mirror;
  mirror.first_rad = -55.0 * degree;
  mirror.last_rad = 55.0 * degree;
  mirror.start_s = -166.6667e-6;
  mirror.sweep_s = 0.451333;
  mirror.period_s = 1.4771;
  sensor::PlatformDescription still;
  still.track = sensor::Track{Vec3{0.0, 0.0, preset.input.height_m}};
  still.attitude = sensor::EulerAttitude{degrees(0.0), degrees(-90.0), degrees(0.0)};
  still.mounts = {sensor::Mount{{}, {}, mirror}};
  const SheetGround ground;
  camera.platform = sensor::Platform{still, ground.frame, -0.01, 1.5};
  const sensor::BandFigures figures = preset.sheet().bands.at(0).figures;
  CHECK(figures.swath_m == Approx(2330e3).epsilon(0.005));
  CHECK(figures.gsd_x_m == Approx(1000.0).epsilon(0.01));
}

// The law of the noise goes through a single figure: rounding.
TEST_CASE("presets have the published signal-to-noise ratios", "[sim][presets]") {
  using Table = std::map<std::string, double>;
  const std::map<std::string, Table> published{{"landsat8_oli",
                                                {{"coastal", 230},
                                                 {"blue", 360},
                                                 {"green", 300},
                                                 {"red", 225},
                                                 {"nir", 200},
                                                 {"swir1", 265},
                                                 {"swir2", 100},
                                                 {"pan", 145},
                                                 {"cirrus", 165}}},
                                               {"sentinel2_msi",
                                                {{"B1", 129},
                                                 {"B2", 154},
                                                 {"B3", 168},
                                                 {"B4", 142},
                                                 {"B5", 117},
                                                 {"B6", 89},
                                                 {"B7", 105},
                                                 {"B8", 174},
                                                 {"B8A", 72},
                                                 {"B9", 114},
                                                 {"B10", 50},
                                                 {"B11", 100},
                                                 {"B12", 100}}}};
  for (const auto& [name, table] : published) {
    const Preset preset{name};
    for (const auto& [band, snr] : table) {
      CAPTURE(name, band);
      CHECK(preset.band(band).snr() == Approx(snr).epsilon(1e-4));
      // Room above the reference: no largest number below it by mistake.
      CHECK(preset.band(band).chain().saturation_radiance() >
            2.0 * preset.band(band).electronics.reference_radiance.value());
    }
  }
}

// A single figure a band; derivatives of the Planck function by quadrature: 1e-4.
TEST_CASE("MODIS and the uncooled camera have the published temperature noise", "[sim][presets]") {
  struct Published {
    const char* band;
    double scene_k, nedt_k;
  };
  const Preset modis{"modis_teb"};
  for (const Published& p : {Published{"band_20", 300, 0.02}, Published{"band_21", 335, 2.0},
                             Published{"band_22", 300, 0.07}, Published{"band_23", 300, 0.07},
                             Published{"band_24", 250, 0.25}, Published{"band_25", 275, 0.25},
                             Published{"band_27", 240, 0.25}, Published{"band_28", 250, 0.25},
                             Published{"band_29", 300, 0.02}, Published{"band_30", 250, 0.25},
                             Published{"band_31", 300, 0.02}, Published{"band_32", 300, 0.03},
                             Published{"band_33", 260, 0.25}, Published{"band_34", 250, 0.25},
                             Published{"band_35", 240, 0.25}, Published{"band_36", 220, 0.35}}) {
    CAPTURE(p.band);
    CHECK(modis.band(p.band).nedt_k(p.scene_k) == Approx(p.nedt_k).epsilon(1e-4));
    CHECK(modis.band(p.band).chain().saturation_radiance() >
          sensor::band_planck(modis.band(p.band).response(), Kelvin{p.scene_k}));
  }
  CHECK(Preset{"uncooled_longwave"}.band("lwir").nedt_k(300.0) == Approx(0.040).epsilon(1e-4));
}

// Three figures a band, which alpha^2 + beta L cannot all meet: Montanaro et al. 2014. They have
// two digits (1 %); the law leaves 3 %.
TEST_CASE("TIRS has the temperature noise measured at 270, 300 and 320 K", "[sim][presets]") {
  const Preset preset{"landsat8_tirs"};
  const std::map<std::string, std::map<double, double>> published{
      {"thermal1", {{270, 0.057}, {300, 0.049}, {320, 0.045}}},
      {"thermal2", {{270, 0.060}, {300, 0.052}, {320, 0.051}}}};
  for (const auto& [band, figures] : published) {
    for (const auto& [scene_k, nedt_k] : figures) {
      CAPTURE(band, scene_k);
      CHECK(preset.band(band).nedt_k(scene_k) == Approx(nedt_k).epsilon(0.02));
    }
  }
}

// NASA's typical radiances are Planck's over the specified limits: half of the last digit.
TEST_CASE("MODIS sees the published radiance of 300 K", "[sim][presets]") {
  const Preset preset{"modis_teb"};
  const std::map<std::string, double> published{
      {"band_20", 0.450}, {"band_29", 9.583}, {"band_31", 9.555}, {"band_32", 8.946}};
  for (const auto& [band, radiance] : published) {
    CAPTURE(band);
    CHECK(sensor::band_planck(preset.band(band).response(), Kelvin{300.0}) ==
          Approx(radiance).margin(0.0005));
  }
}

// The typical radiances of all bands belong to their typical temperatures: a check of limits and
// figures against each other. NASA cuts off (2.1868 -> 2.18): a unit of the last digit.
TEST_CASE("MODIS's typical radiances and temperatures belong together", "[sim][presets]") {
  const Preset preset{"modis_teb"};
  const std::map<std::string, double> typical_k{
      {"band_20", 300}, {"band_21", 335}, {"band_22", 300}, {"band_23", 300},
      {"band_24", 250}, {"band_25", 275}, {"band_27", 240}, {"band_28", 250},
      {"band_29", 300}, {"band_30", 250}, {"band_31", 300}, {"band_32", 300},
      {"band_33", 260}, {"band_34", 250}, {"band_35", 240}, {"band_36", 220}};
  for (const auto& [name, scene_k] : typical_k) {
    CAPTURE(name);
    const PresetBand band = preset.band(name);
    CHECK(sensor::band_planck(band.response(), Kelvin{scene_k}) ==
          Approx(band.electronics.reference_radiance.value()).margin(0.01));
  }
}

// OLI: de Michele et al. 2016. MSI: blue to red 1.005 s; odd to even in blue 0.022 of the height.
// Offsets are rounded to 1 um: 1e-4 s.
TEST_CASE("bands of Landsat and Sentinel-2 follow each other as published", "[sim][presets]") {
  const Preset oli{"landsat8_oli"};
  CHECK(delay_s(oli, "pan", "red") == Approx(0.52).margin(2e-4));
  CHECK(delay_s(oli, "pan", "green") == Approx(0.65).margin(2e-4));
  const Preset msi{"sentinel2_msi"};
  CHECK(delay_s(msi, "B2", "B4") == Approx(1.005).margin(2e-4));
  CHECK(odd_before_even_s(msi, "B2") * 6710.0 / 786e3 == Approx(0.022).margin(1e-5));
}

TEST_CASE("neighbouring modules lie on either side of the axis", "[sim][presets]") {
  for (const char* name : {"landsat8_oli", "landsat8_tirs", "sentinel2_msi"}) {
    for (const sensor::DetectorArray& array : Preset{name}.input.camera.arrays) {
      CAPTURE(name, array.name);
      REQUIRE(array.modules.size() > 1);
      CHECK(array.modules[0].offset_y_m > 0.0);
      for (std::size_t i = 1; i < array.modules.size(); ++i) {
        CHECK(array.modules[i].offset_y_m == -array.modules[i - 1].offset_y_m);
        CHECK(array.modules[i].samples == array.modules[0].samples);
      }
    }
  }
}

// Diffraction, detector and motion leave what such instruments have (requirements are 0.2 to 0.3
// along the track): no blur was forgotten, and none counted twice.
TEST_CASE("the presets' sharpness is that of real instruments", "[sim][presets]") {
  for (const char* name : {"landsat8_oli", "landsat8_tirs", "sentinel2_msi"}) {
    CAPTURE(name);
    for (const BandSheet& band : Preset{name}.sheet().bands) {
      CAPTURE(band.figures.band);
      CHECK(band.figures.mtf_nyquist_y > 0.15);
      CHECK(band.figures.mtf_nyquist_y < 0.42);
      CHECK(band.figures.mtf_nyquist_x > 0.25);
      CHECK(band.figures.mtf_nyquist_x < 0.63);
    }
  }
}

// Five lenses: the same place in all bands. No figures of its noise are published: photons decide,
// and a grey surface of 20 % in the sun is to lie between the noise and the largest number.
TEST_CASE("the five-band camera is exposed for daylight", "[sim][presets]") {
  const Preset preset{"uav_multispectral"};
  REQUIRE(preset.input.camera.arrays.size() == 5);
  for (const char* name : {"blue", "green", "red", "rededge", "nir"}) {
    CAPTURE(name);
    const PresetBand band = preset.band(name);
    CHECK(band.array.offset_x_m == 0.0);
    CHECK(band.snr() > 25.0);
    CHECK(band.snr() < std::sqrt(7000.0));  // that of a full well
    CHECK(band.chain().saturation_radiance() > 2.0 * band.electronics.reference_radiance.value());
  }
}

TEST_CASE("a scenario takes a part of a shipped sensor", "[sim][presets]") {
  const Scenario scenario = test::read_text(test::with_camera(
      "<sensor file=\"sensors/landsat8_oli.xml\" arrays=\"B4 B8\" samples=\"200\" "
      "first_sample=\"3300\" lines=\"100\"/>"));
  REQUIRE(scenario.camera.arrays.size() == 2);
  CHECK(scenario.camera.arrays[0].samples == 200);
  CHECK(scenario.camera.arrays[1].samples == 400);  // pan: half of the pitch
  CHECK(scenario.camera.arrays[1].lines == 200);
  CHECK(scenario.camera.arrays[0].modules.size() == 1);  // the eighth alone
  CHECK(scenario.camera.platform_name == "Landsat-8");
}

}  // namespace nadir::sim
