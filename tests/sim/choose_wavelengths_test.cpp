#include "sim/run/choose_wavelengths.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <numbers>

#include "core/error.hpp"
#include "sim/run/render.hpp"
#include "sim/scenario/read_scenario.hpp"
#include "sim/scratch_folder.hpp"
#include "spectral/coverage.hpp"
#include "support/catch.hpp"

// The wavelengths that are chosen for a scene against 32, in rendered pixels and in air that is
// split into lanes.

namespace nadir::sim {
namespace {

using radiometry::Effect;
using radiometry::EffectSet;

const std::string sun = R"(<illumination><fixed><body name="sun" azimuth_deg="90"
    elevation_deg="40" irradiance="library:illumination/solar.csv"/></fixed></illumination>)";
const std::string no_air = "<atmosphere><none/></atmosphere>";

/// Plates of steep spectra side by side, each in a pixel of its own.
std::string plates(const std::string& light, const std::string& bands) {
  return R"(<scenario name="plates">
  <time utc="2026-06-21T16:00:00Z"/>
  <site latitude_deg="36.4" longitude_deg="-84.2" height_m="0"/>
  )" + light +
         R"(
  <solver method="path"/>
  <materials default_temperature_k="300">
    <material name="leaf" reflectance="spectra.csv#leaf"/>
    <material name="lines" reflectance="spectra.csv#lines"/>
    <material name="quartz" reflectance="spectra.csv#quartz" temperature_k="310"/>
  </materials>
  <geometry>
    <plane material="leaf" size_x_m="2" size_y_m="2" east_m="-2"/>
    <plane material="lines" size_x_m="2" size_y_m="2"/>
    <plane material="quartz" size_x_m="2" size_y_m="2" east_m="2"/>
  </geometry>
  <platform>
    <position><local east_m="0" north_m="0" up_m="3000"/></position>
    <attitude><euler yaw_deg="0" pitch_deg="-90"/></attitude>
  </platform>
  <camera><orthographic><array name="a" samples="3" lines="1" ground_pitch_m="2">)" +
         bands + R"(</array></orthographic></camera>
</scenario>)";
}

/// A red edge 0.02 um wide, a comb of lines 0.02 um wide, a reststrahlen band; 0.3 to 14 um.
void write_spectra(const std::filesystem::path& file) {
  std::ofstream out{file};
  out << "# nadir-spectrum: 1\n# title: Steep spectra\n# quantity: reflectance\n# unit: 1\n"
      << "# wavelength: um, vacuum\n# source: this test\n# licence: CC0-1.0\n"
      << "wavelength_um,leaf,lines,quartz\n";
  for (double x = 0.3; x <= 14.5; x += x < 2.5 ? 0.0025 : 0.02) {
    const double leaf = 0.05 + 0.45 / (1.0 + std::exp(-(x - 0.72) / 0.005));
    const double lines =
        x > 2.5 ? 0.5 : 0.5 - 0.3 * std::exp(-std::pow((std::fmod(x, 0.1) - 0.05) / 0.01, 2));
    const double quartz = 0.05 + 0.4 * std::exp(-std::pow((x - 9.0) / 0.4, 2));
    out << x << "," << leaf << "," << lines << "," << quartz << "\n";
  }
}

struct Plates {
  support::ScratchFolder folder{};
  Diagnostics diagnostics{};
  World world;

  Plates(const std::string& light, const std::string& bands)
      : world{load(folder, diagnostics, plates(light, bands))} {}

  static World load(const support::ScratchFolder& folder, Diagnostics& diagnostics,
                    const std::string& text) {
    write_spectra(folder / "spectra.csv");
    std::ofstream{folder / "plates.xml"} << text;
    InputFiles files;
    return load_world(read_scenario(folder / "plates.xml", diagnostics), files, diagnostics);
  }
  [[nodiscard]] ArrayImage rendered(const BandNodes& nodes) {
    RenderOptions options;
    options.sampling.wavelengths_per_band = nodes;
    options.truth = false;
    options.threads = 1;
    return render(world.scene, world.camera, options, diagnostics).images.front();
  }
};

const std::string hard_bands = R"(<band_box name="edge" lo_um="0.6" hi_um="0.9"/>
    <band_box name="lines" lo_um="0.42" hi_um="0.5"/>
    <band_gaussian name="narrow" centre_um="0.718" fwhm_um="0.001"/>
    <band_box name="thermal" lo_um="8" hi_um="14"/>)";

double largest_difference(const ArrayImage& a, const ArrayImage& b, std::size_t band) {
  double largest = 0.0, mean = 0.0;
  for (const float one : b.bands[band].radiance) mean += static_cast<double>(one) / 3.0;
  for (std::size_t i = 0; i < a.pixels(); ++i) {
    const double there = static_cast<double>(b.bands[band].radiance[i]);
    const double against = std::max(there, 0.1 * mean);
    largest = std::max(largest,
                       std::abs(static_cast<double>(a.bands[band].radiance[i]) - there) / against);
  }
  return largest;
}

}  // namespace

TEST_CASE("rendered radiance at the wavelengths chosen is that at 32", "[sim][wavelengths]") {
  Plates scene{sun + no_air, hard_bands};
  const double share = 0.005;
  const auto chosen = choose_wavelengths(scene.world, {EffectSet::all()}, share, scene.diagnostics);
  const ArrayImage few = scene.rendered(chosen.nodes), many = scene.rendered(32);
  for (std::size_t band = 0; band < 4; ++band) {
    CAPTURE(few.bands[band].name, chosen.nodes.of(0, band), chosen.error[0][band]);
    // Both see the same sun through the same random numbers; 32 have an error of their own, which
    // the smooth edge makes small: half the share is plenty.
    CHECK(largest_difference(few, many, band) <= 1.5 * share);
    CHECK(chosen.error[0][band] <= share);
    CHECK(chosen.nodes.of(0, band) <= 28);
  }
  CHECK(chosen.nodes.of(0, 2) <= 2);  // a band narrower than the spectra's step
  CHECK(chosen.nodes.of(0, 3) <= 12);
  // A single wavelength is told to be as wrong as it is.
  const ByBand of_one = wavelength_errors(scene.world, {EffectSet::all()}, 1);
  const ArrayImage one = scene.rendered(1);
  for (std::size_t band = 0; band < 4; ++band) {
    CHECK(largest_difference(one, many, band) <= of_one[0][band] + 1.5 * share);
  }
  CHECK(of_one[0][0] > 0.1);
}

TEST_CASE("only spectra of what is simulated need wavelengths", "[sim][wavelengths]") {
  Plates scene{sun + no_air, hard_bands};
  const auto with = [&](EffectSet effects) {
    return choose_wavelengths(scene.world, {effects}, 0.001, scene.diagnostics);
  };
  const auto nothing = with(EffectSet{});
  for (std::size_t band = 0; band < 4; ++band) CHECK(nothing.nodes.of(0, band) == 1);
  const auto night = with(EffectSet{}.with(Effect::surface_emission));
  const auto day = with(EffectSet{}.with(Effect::solar_reflection));
  CHECK(day.nodes.of(0, 0) > 4);    // the red edge
  CHECK(night.nodes.of(0, 3) > 2);  // quartz in the thermal band
}

TEST_CASE("a scenario may leave the number of wavelengths to the planner", "[sim][wavelengths]") {
  Diagnostics diagnostics;
  const support::ScratchFolder folder;
  write_spectra(folder / "spectra.csv");
  const auto nodes_of = [&](const std::string& sampling) {
    std::string text = plates(sun + no_air, hard_bands);
    text.insert(text.find("</scenario>"), sampling);
    return parse_scenario(text, folder / "plates.xml", diagnostics).sampling.wavelengths_per_band;
  };
  CHECK(nodes_of(R"(<sampling wavelengths_per_band="auto"/>)") == BandNodes{0});
  CHECK(nodes_of(R"(<sampling wavelengths_per_band="32"/>)") == BandNodes{32});
  CHECK(nodes_of("<sampling/>") == BandNodes{4});
  CHECK_THROWS_AS(nodes_of(R"(<sampling wavelengths_per_band="33"/>)"), InputError);
  CHECK_THROWS_AS(nodes_of(R"(<sampling wavelengths_per_band="0"/>)"), InputError);
}

TEST_CASE("a band that 32 wavelengths do not integrate is told of", "[sim][wavelengths]") {
  Plates scene{sun + no_air, R"(<band_box name="all" lo_um="0.35" hi_um="2.4"/>)"};
  const auto chosen = choose_wavelengths(scene.world, {EffectSet::all()}, 1e-5, scene.diagnostics);
  CHECK(chosen.error[0][0] > 1e-5);
  const auto messages = scene.diagnostics.messages();
  CHECK(std::any_of(messages.begin(), messages.end(), [](const std::string& message) {
    return message.find("band all is integrated to") != std::string::npos;
  }));
}

TEST_CASE("gases of layered air are integrated by the intervals of few nodes",
          "[sim][wavelengths][air]") {
  // The O2 A band, and water vapour's at 0.94 um.
  Plates scene{sun + "<atmosphere><layered profile=\"midlatitude_summer\"/></atmosphere>",
               R"(<band_box name="o2" lo_um="0.75" hi_um="0.78"/>
                  <band_box name="water" lo_um="0.9" hi_um="0.98"/>)"};
  const double share = 0.005;
  const auto chosen = choose_wavelengths(scene.world, {EffectSet::all()}, share, scene.diagnostics);
  // The sun on a plate through the lanes that a run would have, straight down and up again.
  const LayeredTask& task = *scene.world.air->layered;
  const auto band_means = [&](const BandNodes& nodes) {
    const CameraPlan plan = plan_camera(scene.world.camera.arrays, nodes, task.air, task.settings);
    std::vector<double> sums;
    for (const auto& terms : plan.arrays[0].lanes.bands) {
      double& sum = sums.emplace_back(0.0);
      for (const auto& term : terms) {
        const auto& lanes = plan.arrays[0].lanes.blocks[static_cast<std::size_t>(term.block)];
        const Micrometres at = lanes[term.lane];
        const auto lane = lanes.absorption(term.lane);
        const auto split =
            std::find_if(plan.air.lanes.begin(), plan.air.lanes.end(), [&](const auto& one) {
              return one.absorption == lane &&
                     plan.air.wavelengths[static_cast<std::size_t>(one.source)] == at;
            });
        double depth = 0.0;
        for (const double layer : split->gas_depth) depth += layer;
        const double light =
            spectral::lane_mean(scene.world.scene.illumination[0].irradiance, at, lane);
        const double reflected = scene.world.scene.materials[0].reflectance->at(at);
        sum += term.weight * light * reflected * std::exp(-2.0 * depth);
      }
    }
    return sums;
  };
  const auto few = band_means(chosen.nodes), many = band_means(32);
  for (std::size_t band = 0; band < 2; ++band) {
    CAPTURE(band, chosen.nodes.of(0, band));
    // Terms are merged to 5e-4 of transmittance, of which this light sees the double.
    CHECK(few[band] == Approx(many[band]).epsilon(share + 2e-3));
    CHECK(chosen.nodes.of(0, band) < 20);
  }
}

}  // namespace nadir::sim
