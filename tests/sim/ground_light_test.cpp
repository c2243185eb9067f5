#include "sim/run/ground_light.hpp"

#include <utility>
#include <vector>

#include "core/error.hpp"
#include "radiometry/small_scene.hpp"
#include "spectral/planck.hpp"
#include "support/catch.hpp"

namespace nadir::sim {
namespace {

using radiometry::test::grey;
using radiometry::test::SmallScene;

const std::vector<Micrometres> visible_and_thermal{Micrometres{0.55}, Micrometres{10.0},
                                                   Micrometres{10.0}, Micrometres{11.0}};

atmosphere::GroundLight light_of(SmallScene scene, const GroundAbout& about = {}) {
  Diagnostics diagnostics;
  auto light = ground_light(scene.build(), about, visible_and_thermal, diagnostics);
  CHECK(diagnostics.messages().empty());
  REQUIRE(light.reflectance.size() == visible_and_thermal.size());
  REQUIRE(light.emission.size() == visible_and_thermal.size());
  return light;
}

double planck_at(std::size_t lane, double kelvin) {
  return spectral::planck(visible_and_thermal[lane], Kelvin{kelvin}).value;
}

/// Two squares side by side, one three times as large as the other.
SmallScene fields() {
  SmallScene scene;
  const auto dark = scene.material(grey(0.1), Kelvin{300.0});
  const auto bright = scene.material(grey(0.5), Kelvin{280.0});
  scene.add(geometry::Plane{{-10.0, 0.0, 0.0}, 60.0, 80.0}, dark);
  scene.add(geometry::Plane{{30.0, 0.0, 0.0}, 20.0, 80.0}, bright);
  return scene;
}

}  // namespace

TEST_CASE("the ground about is the mean of what the scene shows from above", "[sim][ground]") {
  const auto light = light_of(fields());
  for (std::size_t lane = 0; lane < visible_and_thermal.size(); ++lane) {
    // The grid's places fall to three quarters on the large field, exactly. Float: 1e-6.
    CHECK(light.reflectance[lane] == Approx(0.75 * 0.1 + 0.25 * 0.5).epsilon(1e-6));
    const double emission =
        0.75 * 0.9 * planck_at(lane, 300.0) + 0.25 * 0.5 * planck_at(lane, 280.0);
    CHECK(light.emission[lane] == Approx(emission).epsilon(1e-5).margin(1e-30));
  }
}

TEST_CASE("what lies under a roof does not count, nor does a gap", "[sim][ground]") {
  SmallScene scene = fields();
  const auto white = scene.material(grey(1.0), Kelvin{0.0});
  scene.add(geometry::Plane{{0.0, 0.0, 10.0}, 80.0, 40.0}, white);  // half of both
  const auto light = light_of(std::move(scene));
  CHECK(light.reflectance[0] == Approx(0.5 + 0.5 * 0.2).epsilon(1e-6));

  SmallScene apart;
  const auto grass = apart.material(grey(0.3), Kelvin{290.0});
  apart.add(geometry::Plane{{-100.0, 0.0, 0.0}, 20.0, 20.0}, grass);
  apart.add(geometry::Plane{{100.0, 0.0, 0.0}, 20.0, 20.0}, grass);
  CHECK(light_of(std::move(apart)).reflectance[0] == Approx(0.3).epsilon(1e-6));
}

TEST_CASE("what the user says of the ground replaces what is seen", "[sim][ground]") {
  GroundAbout about;
  about.reflectance = spectral::Curve::constant(0.8);
  auto light = light_of(fields(), about);
  for (std::size_t lane = 0; lane < visible_and_thermal.size(); ++lane) {
    CHECK(light.reflectance[lane] == Approx(0.8).epsilon(1e-6));
    const double black = 0.75 * planck_at(lane, 300.0) + 0.25 * planck_at(lane, 280.0);
    CHECK(light.emission[lane] == Approx(0.2 * black).epsilon(1e-5).margin(1e-30));
  }
  about.temperature = Kelvin{310.0};
  light = light_of(fields(), about);
  CHECK(light.emission[1] == Approx(0.2 * planck_at(1, 310.0)).epsilon(1e-5));
  about.reflectance.reset();
  light = light_of(fields(), about);
  CHECK(light.reflectance[1] == Approx(0.2).epsilon(1e-6));
  CHECK(light.emission[1] == Approx(0.8 * planck_at(1, 310.0)).epsilon(1e-5));
}

TEST_CASE("a scene without ground is black, and says so", "[sim][ground]") {
  SmallScene scene;
  scene.material(grey(0.5), Kelvin{300.0});
  Diagnostics diagnostics;
  const auto light = ground_light(scene.build(), {}, visible_and_thermal, diagnostics);
  for (std::size_t lane = 0; lane < visible_and_thermal.size(); ++lane) {
    CHECK(light.reflectance[lane] == 0.0F);
    CHECK(light.emission[lane] == 0.0F);
  }
  CHECK(diagnostics.messages() == std::vector<std::string>{"the scene shows no surface from above: "
                                                           "the ground about it counts as black"});
}

TEST_CASE("the ground's spectrum must cover the lanes", "[sim][ground]") {
  SmallScene scene = fields();
  GroundAbout about;
  about.reflectance = spectral::Curve{{0.4, 2.5}, {0.1, 0.3}, spectral::Outside::reject};
  Diagnostics diagnostics;
  CHECK_THROWS_AS(ground_light(scene.build(), about, visible_and_thermal, diagnostics), InputError);
}

TEST_CASE("more lanes than a block holds keep their order", "[sim][ground]") {
  SmallScene scene;
  materials::Material ramp;
  ramp.name = "ramp";
  ramp.reflectance = spectral::Curve{{0.4, 1.4}, {0.0, 1.0}, spectral::Outside::reject};
  scene.add(geometry::Plane{{}, 10.0, 10.0}, scene.material(ramp, Kelvin{0.0}));
  std::vector<Micrometres> wavelengths;
  for (int i = 0; i < 600; ++i) wavelengths.emplace_back(0.4 + (i / 3) * 0.005);
  Diagnostics diagnostics;
  const auto light = ground_light(scene.build(), {}, wavelengths, diagnostics);
  REQUIRE(light.reflectance.size() == 600);
  for (std::size_t i = 0; i < 600; ++i) {
    CHECK(light.reflectance[i] ==
          Approx(static_cast<double>(i / 3) * 0.005).epsilon(0.0).margin(1e-6));
  }
}

}  // namespace nadir::sim
