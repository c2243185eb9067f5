#include "sim/plan/effect_bounds.hpp"

#include <array>
#include <cmath>
#include <numbers>

#include "radiometry/small_scene.hpp"
#include "sim/plan/light_envelope.hpp"
#include "support/catch.hpp"

using namespace nadir;
using namespace nadir::sim;
using radiometry::Effect;
using radiometry::EffectSet;
namespace small = radiometry::test;

namespace {

constexpr double pi = std::numbers::pi;

double bound(Effect effect, const SceneFacts& facts, double floor) {
  const ArrayFacts& array = facts.arrays.front();
  const BandFacts& band = array.bands.front();
  return effect_bound(effect,
                      {facts, array, band, floor, band.least_emissivity * band.coldest_emission});
}

/// Two walls of a furrow under sun, sky and their own heat at 10 um, and the same as facts.
struct Furrow {
  double rho = 0.0, irradiance = 0.0, sky = 0.0;
  static constexpr double wavelength_um = 10.0, coldest_k = 290.0, warmest_k = 310.0;

  [[nodiscard]] radiometry::SceneDescription scene() const {
    small::SmallScene scene;
    scene.method = radiometry::Method::path;
    const auto cold = scene.material(small::grey(rho), Kelvin{coldest_k});
    const auto warm = scene.material(small::grey(rho), Kelvin{warmest_k});
    scene.add(geometry::Disc{{0.0, 0.0, 0.0}, {0.5, 0.0, 0.8}, 3.0}, cold);
    scene.add(geometry::Disc{{0.5, 0.0, 0.0}, {-0.6, 0.0, 0.8}, 3.0}, warm);
    scene.add_body(100.0, 50.0, 0.27, irradiance);
    scene.sky(sky);
    return scene.build();
  }
  [[nodiscard]] SceneFacts facts() const {
    const auto planck = [](double kelvin) {
      return spectral::planck(Micrometres{wavelength_um}, Kelvin{kelvin}).value;
    };
    BandFacts band;
    band.least_reflectance = band.greatest_reflectance = rho;
    band.least_emissivity = band.greatest_emissivity = 1.0 - rho;
    band.coldest_emission = planck(coldest_k);
    band.warmest_emission = planck(warmest_k);
    band.sun_irradiance = irradiance;
    band.sky_scattering = band.least_sky_scattering = sky;
    SceneFacts facts;
    facts.has_sun = true;
    facts.arrays.push_back({"a", {band}});
    return facts;
  }
};

double seen(const radiometry::SceneDescription& scene, double x, EffectSet effects) {
  Diagnostics diagnostics;
  const radiometry::LitScene lit{scene, spectral::Lanes{{Micrometres{Furrow::wavelength_um}}},
                                 diagnostics, effects};
  const geometry::Ray ray{{x, 0.1, 10.0}, {0.0, 0.0, -1.0}};
  return small::measure_with(radiometry::PathSolver{lit}, lit, ray, 4, 256, 3).lanes[0].mean;
}

}  // namespace

TEST_CASE("no effect changes a pixel by more than its bound", "[plan][effects][bounds]") {
  const Furrow furrow =
      GENERATE(Furrow{0.1, 0.3, 0.5}, Furrow{0.5, 20.0, 3.0}, Furrow{0.9, 1000.0, 100.0});
  const SceneFacts facts = furrow.facts();
  const auto scene = furrow.scene();
  const double floor = floor_radiance(facts.arrays[0].bands[0], {});
  CAPTURE(furrow.rho, floor);
  for (const double x : {-0.7, 0.25, 1.1}) {
    const double all = seen(scene, x, EffectSet::all());
    for (const Effect effect :
         {Effect::solar_reflection, Effect::sky_scattering, Effect::surface_emission,
          Effect::interreflection, Effect::shadows}) {
      const double without = seen(scene, x, EffectSet::all().without(effect));
      const double change = std::abs(all - without) / std::max(all, floor);
      CAPTURE(radiometry::name_of(effect), x, all, without);
      // 1 %: noise of 1024 paths, of which some effects have most
      CHECK(change <= 1.01 * bound(effect, facts, floor) + 0.01);
    }
  }
}

TEST_CASE("the bound of direct light on one flat surface is what a pixel shows",
          "[plan][effects][bounds]") {
  SceneFacts facts = Furrow{0.3, 50.0, 0.0}.facts();
  facts.one_convex_surface = true;
  CHECK(bound(Effect::solar_reflection, facts, 100.0) ==
        Approx(0.3 * 50.0 / pi / 100.0).epsilon(1e-12));
  CHECK(bound(Effect::interreflection, facts, 100.0) == 0.0);
  CHECK(bound(Effect::shadows, facts, 100.0) == 0.0);
}

TEST_CASE("light between surfaces is bounded by the geometric series", "[plan][effects][bounds]") {
  SceneFacts facts = Furrow{0.5, 0.0, 8.0}.facts();
  BandFacts& band = facts.arrays[0].bands[0];
  band.coldest_emission = band.warmest_emission = 0.0;
  // first 0.5 * 8 = 4, of all orders 8; the second and higher ones 4
  CHECK(bound(Effect::sky_scattering, facts, 1.0) == Approx(8.0).epsilon(1e-12));
  CHECK(bound(Effect::interreflection, facts, 1.0) == Approx(4.0).epsilon(1e-12));
  band.greatest_reflectance = 1.0;  // white and closed: no bound
  CHECK(std::isinf(bound(Effect::sky_scattering, facts, 1.0)));
}

TEST_CASE("without the path's transmittance its loss is there", "[plan][effects][bounds]") {
  SceneFacts facts = Furrow{0.5, 0.0, 8.0}.facts();
  facts.arrays[0].bands[0].path_loss = 0.2;  // (1 - 0.8) / 0.8
  CHECK(bound(Effect::path_transmittance, facts, 1.0) == Approx(0.25).epsilon(1e-12));
  facts.arrays[0].bands[0].path_loss = 1.0;
  CHECK(std::isinf(bound(Effect::path_transmittance, facts, 1.0)));
}

TEST_CASE("the floor is stated, or the sensor's noise, or the scene's darkest surface",
          "[plan][effects][bounds]") {
  BandFacts band = Furrow{0.3, 50.0, 2.0}.facts().arrays[0].bands[0];
  AccuracyInput accuracy;
  // emission, and a sky of 2 on a reflectance of 0.3
  CHECK(floor_radiance(band, accuracy) ==
        Approx(0.7 * band.coldest_emission + 0.3 * 2.0).epsilon(1e-12));
  band.noise_radiance = 0.01;
  CHECK(floor_radiance(band, accuracy) == Approx(0.5 * 0.01 / 0.01).epsilon(1e-12));
  accuracy.floor_radiance = 7.0;
  CHECK(floor_radiance(band, accuracy) == 7.0);
  CHECK(floor_radiance(BandFacts{}, {}) > 0.0);
}

TEST_CASE("the optical depth of molecules is that of Hansen and Travis", "[plan][effects]") {
  // Bodhaine et al., J. Atmos. Oceanic Technol. 16, 1854 (1999), table 3: 0.0972 at 0.55 um; the
  // two formulas are 1 % apart.
  CHECK(rayleigh_depth(Micrometres{0.55}, 1013.25) == Approx(0.0972).epsilon(0.01));
}

TEST_CASE("light of twilight falls with the body and ends at 18 degrees", "[plan][effects]") {
  double before = 1.0;
  for (double elevation = 1.0; elevation > -18.0; elevation -= 0.25) {
    const double share = twilight_share(degrees(elevation));
    CHECK(share <= before);
    before = share;
  }
  CHECK(before > 0.0);
  CHECK(twilight_share(degrees(-18.1)) == 0.0);
}

TEST_CASE("air scatters no more light onto the ground than comes in", "[plan][effects]") {
  for (const double depth : {0.0, 1e-8, 0.1, 1.0, 1e3}) {
    const double share = scattered_share({depth, 0.0}, degrees(30.0));
    CHECK(share >= 0.0);
    CHECK(share <= 0.5 * (1.0 + 1e-12));  // sine of 30 degrees
    CHECK((depth == 0.0) == (share == 0.0));
  }
}
