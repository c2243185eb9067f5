#include "sim/run/world.hpp"

#include <cmath>
#include <fstream>
#include <numbers>

#include "core/error.hpp"
#include "sim/message_of.hpp"
#include "sim/run/check_view.hpp"
#include "sim/run/render.hpp"
#include "sim/run/run.hpp"
#include "sim/scenario/read_scenario.hpp"
#include "sim/scratch_folder.hpp"
#include "support/catch.hpp"

// From a scenario's text to rendered pixels, in one process.

namespace nadir::sim {
namespace {

/// A scenario around the pieces that a test cares about.
std::string world_scenario_text(const std::string& light, const std::string& materials,
                                const std::string& geometry, const std::string& bands) {
  return R"(<scenario name="test">
  <time utc="2026-06-21T16:00:00Z"/>
  <site latitude_deg="36.4" longitude_deg="-84.2" height_m="300"/>
  )" + light +
         R"(
  <materials default_temperature_k="300">)" +
         materials + R"(</materials>
  <geometry>)" +
         geometry + R"(</geometry>
  <platform>
    <position><local east_m="0" north_m="0" up_m="500"/></position>
    <attitude><euler yaw_deg="0" pitch_deg="-90"/></attitude>
  </platform>
  <camera><orthographic><array name="a" samples="2" lines="2" ground_pitch_m="1">)" +
         bands + R"(</array></orthographic></camera>
  <sampling replicates="4" samples_per_replicate="4"/>
</scenario>)";
}

const std::string no_light =
    "<illumination><fixed/></illumination><atmosphere><none/></atmosphere>";
const std::string ground = R"(<plane material="m" size_x_m="100" size_y_m="100"/>)";
const std::string thermal_band = R"(<band_box name="t" lo_um="10" hi_um="11"/>)";

struct LoadedWorld {
  Scenario scenario;
  World world;
  std::vector<std::string> warnings;
};

LoadedWorld load_world(const support::ScratchFolder& folder, const std::string& text) {
  Diagnostics diagnostics;
  InputFiles files;
  const auto file = folder / "scenario.xml";
  std::ofstream{file} << text;
  Scenario scenario = read_scenario(file, diagnostics);
  World world = load_world(scenario, files, diagnostics);
  check_spectra(world, scenario.sampling, diagnostics);
  return {std::move(scenario), std::move(world), diagnostics.messages()};
}

ArrayImage rendered_world(const LoadedWorld& loaded) {
  Diagnostics diagnostics;
  RenderOptions options;
  options.sampling = loaded.scenario.sampling;
  return render(loaded.world.scene, loaded.world.camera, options, diagnostics).images.front();
}

TEST_CASE("a thermal band of a black plate shows the plate's temperature", "[sim][world]") {
  const support::ScratchFolder folder;
  const auto image = rendered_world(load_world(
      folder,
      world_scenario_text(no_light, R"(<material name="m" emissivity="1" temperature_k="312.5"/>)",
                          ground, thermal_band)));
  for (const float kelvin : image.bands[0].brightness_temperature) {
    CHECK(kelvin == Approx(312.5).margin(1e-3));  // float lanes: 1e-6 of the radiance
  }
  for (const float kelvin : image.truth.temperature_k) CHECK(kelvin == 312.5F);
  for (const auto id : image.truth.material) CHECK(id == 1);
}

TEST_CASE("a sunlit plate reflects rho E cos / pi, and the truth planes know the sun",
          "[sim][world]") {
  const std::string light =
      R"(<illumination><fixed><body name="sun" azimuth_deg="90" elevation_deg="30"
         irradiance="1500"/></fixed></illumination><atmosphere><none/></atmosphere>)";
  const support::ScratchFolder folder;
  const auto image = rendered_world(load_world(
      folder,
      world_scenario_text(light, R"(<material name="m" reflectance="0.4" temperature_k="0"/>)",
                          ground, R"(<band_box name="g" lo_um="0.5" hi_um="0.6"/>)")));
  // The disc's half width of a quarter degree moves the cosine by up to 0.8 %; over 16 scrambled
  // points in the disc that averages to well below 0.1 %.
  const double expected = 0.4 * 1500.0 * 0.5 * std::numbers::inv_pi;
  for (const float radiance : image.bands[0].radiance) {
    CHECK(radiance == Approx(expected).epsilon(2e-3));
  }
  for (const float elevation : image.truth.sun_elevation_deg) {
    CHECK(elevation == Approx(30.0).margin(1e-4));
  }
  for (const float shadow : image.truth.shadow_fraction) CHECK(shadow == 0.0F);
  for (const float range : image.truth.range_m) CHECK(range == Approx(500.0).margin(1e-3));
}

TEST_CASE("pixels in shadow say so", "[sim][world]") {
  const std::string light =
      R"(<illumination><fixed><body name="sun" azimuth_deg="90" elevation_deg="45"
         irradiance="1500"/></fixed></illumination><atmosphere><none/></atmosphere>)";
  const support::ScratchFolder folder;
  const auto image = rendered_world(load_world(
      folder, world_scenario_text(light, R"(<material name="m" reflectance="0.4"/>)",
                                  ground + R"(<box material="m" lo_m="30 -20 0" hi_m="35 20 90"/>)",
                                  R"(<band_box name="g" lo_um="0.5" hi_um="0.6"/>)")));
  for (const float shadow : image.truth.shadow_fraction) CHECK(shadow == 1.0F);
}

TEST_CASE("nested lists of instances multiply and stand where both lists say", "[sim][world]") {
  const support::ScratchFolder folder;
  std::ofstream{folder / "outer.csv"} << "east_m,north_m,yaw_deg\n0,0,0\n100,0,90\n";
  std::ofstream{folder / "inner.csv"} << "east_m,north_m\n10,0\n20,0\n30,0\n";
  const auto loaded = load_world(
      folder,
      world_scenario_text(no_light, R"(<material name="m" reflectance="0.4"/>)",
                          ground + R"(<instances list="outer.csv"><instances list="inner.csv">
                                <sphere material="m" radius_m="1"/></instances></instances>)",
                          thermal_band));
  const auto& scene = loaded.world.scene.geometry;
  CHECK(scene.represented_primitives() == 1 + 2 * 3);
  // Yaw turns clockwise: the second group's spheres lie south of (100, 0).
  for (const Vec3 top : {Vec3{20.0, 0.0, 50.0}, Vec3{100.0, -20.0, 50.0}}) {
    const auto hit = scene.intersect({top, {0.0, 0.0, -1.0}});
    REQUIRE(hit.has_value());
    CHECK(hit->position.z == Approx(1.0).margin(1e-4));  // floats of a 100 m scene
  }
}

TEST_CASE("mistakes of several files are told at once", "[sim][world]") {
  const support::ScratchFolder folder;
  std::ofstream{folder / "bad.obj"} << "v 0 0 x\n";
  std::ofstream{folder / "good.obj"} << "v 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl wall\nf 1 2 3\n";
  std::ofstream{folder / "bad.csv"} << "wavelength_um,rho\n0.4,0.1\n0.5,abc\n";
  const auto message = support::message_of([&] {
    (void)load_world(folder,
                     world_scenario_text(no_light, R"(<material name="m" reflectance="bad.csv"/>)",
                                         ground + R"(<mesh file="bad.obj" material="m"/>
                                     <mesh file="good.obj"><part name="wal" material="m"/></mesh>)",
                                         thermal_band));
  });
  CAPTURE(message);
  CHECK(message.find("bad.csv:3:") != std::string::npos);
  CHECK(message.find("bad.obj:1:") != std::string::npos);
  CHECK(message.find("did you mean \"wall\"?") != std::string::npos);
  CHECK(message.find("part \"wall\" of this mesh has no material") != std::string::npos);
}

TEST_CASE("a spectrum that does not reach a band is an error or a warning, never silence",
          "[sim][world]") {
  const support::ScratchFolder folder;
  std::ofstream{folder / "sky.csv"} << "wavelength_um,l\n0.4,50\n0.9,40\n";
  std::ofstream{folder / "rho.csv"} << "wavelength_um,rho\n0.4,0.1\n0.9,0.2\n";
  const std::string sky = R"(<illumination><fixed/></illumination>
                             <atmosphere><uniform sky_radiance="sky.csv"/></atmosphere>)";
  const std::string grey = R"(<material name="m" reflectance="0.4"/>)";
  const auto message = support::message_of(
      [&] { (void)load_world(folder, world_scenario_text(sky, grey, ground, thermal_band)); });
  CHECK(message.find("the sky's radiance is tabulated from 0.4 to 0.9 um, but the bands need it") !=
        std::string::npos);
  const auto held = load_world(
      folder, world_scenario_text(no_light, R"(<material name="m" reflectance="rho.csv"/>)", ground,
                                  thermal_band));
  CHECK(held.warnings.size() == 1);
}

TEST_CASE("a camera that looks straight down has north at the top, wherever it stands",
          "[sim][world]") {
  const support::ScratchFolder folder;
  const std::string material = R"(<material name="m" reflectance="0.4"/>)";
  for (const std::string east_m : {"0", "1", "1000"}) {
    std::string text = world_scenario_text(no_light, material, ground, thermal_band);
    const auto from = text.find("<platform>"), to = text.find("</platform>");
    text.replace(from, to - from,
                 "<platform><position><local east_m=\"" + east_m +
                     "\" north_m=\"0\" up_m=\"500\"/></position><attitude><look_at>"
                     "<local east_m=\"" +
                     east_m + "\" north_m=\"0\" up_m=\"0\"/></look_at></attitude>");
    Diagnostics diagnostics;
    InputFiles files;
    std::ofstream{folder / "down.xml"} << text;
    const World world =
        load_world(read_scenario(folder / "down.xml", diagnostics), files, diagnostics);
    CAPTURE(east_m);
    CHECK(length(world.camera.platform.at(0.0).axes.x - Vec3{1.0, 0.0, 0.0}) < 1e-12);
    CHECK(length(world.camera.platform.at(0.0).axes.y - Vec3{0.0, -1.0, 0.0}) < 1e-12);
  }
}

TEST_CASE("a scene too large for its shadows, or far from its site, is told", "[sim][world]") {
  const support::ScratchFolder folder;
  const auto load_with = [&](const std::string& geometry) {
    return load_world(
        folder, world_scenario_text(no_light, R"(<material name="m" reflectance="0.4"/>)", geometry,
                                    thermal_band));
  };
  const auto warned = load_with(ground + R"(<sphere material="m" radius_m="10" east_m="2e5"/>)");
  REQUIRE(warned.warnings.size() == 1);
  CHECK(warned.warnings[0].find("shadows finer than 0.07 m may be lost") != std::string::npos);
  const auto refused = support::message_of(
      [&] { (void)load_with(ground + R"(<sphere material="m" radius_m="10" east_m="1e7"/>)"); });
  CHECK(refused.find("shadows finer than a metre would be lost") != std::string::npos);
  const auto elsewhere = support::message_of(
      [&] { (void)load_with(R"(<plane material="m" size_x_m="9" size_y_m="9" north_m="5e5"/>)"); });
  CHECK(elsewhere.find("its nearest surface is 500 km from the site") != std::string::npos);
}

TEST_CASE("a night under a sky that still shines is told", "[sim][world]") {
  const support::ScratchFolder folder;
  std::string text = world_scenario_text(
      R"(<illumination><ephemeris solar_irradiance="1800" lunar_irradiance="0"/></illumination>
         <atmosphere><uniform sky_radiance="50"/></atmosphere>)",
      R"(<material name="m" reflectance="0.4"/>)", ground, thermal_band);
  CHECK(load_world(folder, text).warnings.empty());
  text.replace(text.find("T16:"), 4, "T05:");
  const auto warnings = load_world(folder, text).warnings;
  REQUIRE(warnings.size() == 1);
  CHECK(warnings[0].find("the sun is below the horizon") == 0);
  // What the full moon scatters is 2.5e-6 of the sun's; that is no mistake.
  text.replace(text.find("sky_radiance=\"50\""), 17, "sky_radiance=\"2e-4\"");
  CHECK(load_world(folder, text).warnings.empty());
}

TEST_CASE("a mistake without a place of its own names its object, its row or its band",
          "[sim][world]") {
  const support::ScratchFolder folder;
  std::ofstream{folder / "list.csv"} << "east_m,north_m\n1,2\n3,4\n";
  const std::string material = R"(<material name="m" reflectance="0.4"/>)";
  const auto flat = support::message_of([&] {
    (void)load_world(folder, world_scenario_text(no_light, material,
                                                 ground + R"(<instances name="trees" list="list.csv"
                                     on_terrain="false"><mesh file="none.obj" material="m"/>
                                     </instances>)",
                                                 thermal_band));
  });
  CHECK(flat.find("none.obj") != std::string::npos);
  const auto band = support::message_of([&] {
    (void)load_world(
        folder, world_scenario_text(no_light, material, ground,
                                    R"(<band_gaussian name="g" centre_um="1" fwhm_um="0.8"/>)"));
  });
  CAPTURE(band);
  CHECK(band.find("band g of array a: expected a Gaussian response") != std::string::npos);
}

TEST_CASE("a camera that sees nothing is told before anything is rendered", "[sim][world]") {
  const std::string sky =
      R"(<illumination><fixed/></illumination><atmosphere><uniform sky_radiance="5"/></atmosphere>)";
  const auto text = [&](const std::string& light) {
    return world_scenario_text(light, R"(<material name="m" reflectance="0.4"/>)",
                               R"(<plane material="m" size_x_m="10" size_y_m="10" up_m="900"/>)",
                               thermal_band);
  };
  const support::ScratchFolder folder;
  const auto dark = support::message_of([&] {
    Diagnostics diagnostics;
    check_view(load_world(folder, text(no_light)).world, diagnostics);
  });
  CHECK(dark ==
        (folder / "scenario.xml").string() +
            ": error: camera: array a meets no surface along any line of sight that was tried; "
            "does the camera look the right way?\n");
  Diagnostics diagnostics;
  check_view(load_world(folder, text(sky)).world, diagnostics);
  CHECK(diagnostics.messages().size() == 1);
}

TEST_CASE("heights that count from the terrain need terrain below", "[sim][world]") {
  const support::ScratchFolder folder;
  std::ofstream{folder / "ground.asc"} << "ncols 3\nnrows 3\nxllcorner -84.21\nyllcorner 36.39\n"
                                          "cellsize 0.01\n310 310 310\n310 310 310\n310 310 310\n";
  std::ofstream{folder / "ground.prj"} << R"(GEOGCS["WGS 84",DATUM["WGS_1984",SPHEROID["WGS 84",)"
                                          R"(6378137,298.257223563]],PRIMEM["Greenwich",0],)"
                                          R"(UNIT["degree",0.0174532925199433]])";
  const auto text = [&](const std::string& east_m) {
    return world_scenario_text(no_light, R"(<material name="m" reflectance="0.4"/>)",
                               R"(<terrain raster="ground.asc" material="m"/>
                            <sphere material="m" radius_m="2" on_terrain="true" east_m=")" +
                                   east_m + R"("/>)",
                               thermal_band);
  };
  const auto loaded = load_world(folder, text("100"));
  const auto hit = loaded.world.scene.geometry.intersect({{100.0, 0.0, 400.0}, {0.0, 0.0, -1.0}});
  REQUIRE(hit.has_value());
  // Site 300 m, terrain 310 m, radius 2 m. Posts lie about a kilometre apart, so that their facet
  // sags below the ellipsoid by up to its diagonal^2 / (8 R) = 1430^2 / (8 * 6.37e6) = 0.04 m.
  CHECK(hit->position.z <= 12.0);
  CHECK(hit->position.z >= 12.0 - 0.041);
  const auto message = support::message_of([&] { (void)load_world(folder, text("90000")); });
  CHECK(message.find("lies outside the terrain") != std::string::npos);
}

}  // namespace
}  // namespace nadir::sim
