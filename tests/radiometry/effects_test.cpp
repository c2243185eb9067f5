#include <cmath>
#include <numbers>

#include "radiometry/effect_scene.hpp"
#include "radiometry/effect_shares.hpp"
#include "radiometry/volume_helpers.hpp"
#include "support/catch.hpp"

// What each effect leaves out, against closed forms. 2e-5 is the rounding of float lanes over a
// walk; 4.5 standard errors: of some 200 comparisons one in a thousand runs would fail by chance.

namespace nadir::radiometry::test {
namespace {

using std::numbers::inv_pi;
constexpr double pi = std::numbers::pi;

// Where sun and emission are of like size.
const spectral::Lanes midwave_effects{{3.8_um, 4.0_um, 4.2_um}};

/// A plane under sun, moon and sky, seen through air. The sun's irradiance is scaled to the size of
/// the emission.
struct LitPlane {
  double rho = 0.3, kelvin = 300.0, sun = 12.0, moon = 5.0;

  [[nodiscard]] SceneDescription build(Method method) const {
    SmallScene small;
    small.method = method;
    small.solver = {.initial_sample_count = 16, .mu_samples = 4, .phi_samples = 8};
    small.add(geometry::Plane{{0.0, 0.0, 0.0}, 1000.0, 1000.0},
              small.material(grey(rho), Kelvin{kelvin}));
    SceneDescription scene = small.build();
    scene.atmosphere = full_air();
    scene.illumination = {body("sun", 50.0, sun), body("moon", 20.0, moon)};
    return scene;
  }

  /// What a source adds to the image at a lane where the line of sight lets `left` through.
  [[nodiscard]] double part(Effect source, Micrometres wavelength, double left = 0.7) const {
    const auto black = [&](double k) { return spectral::planck(wavelength, Kelvin{k}).value; };
    const auto lit = [&](double irradiance, double elevation_deg) {
      return left * rho * inv_pi * 0.85 * irradiance * std::sin(degrees(elevation_deg).value);
    };
    switch (source) {
      case Effect::solar_reflection:
        return lit(sun, 50.0);
      case Effect::lunar_reflection:
        return lit(moon, 20.0);
      case Effect::sky_scattering:
        return left * rho * 0.6;
      case Effect::sky_emission:
        return left * rho * black(260.0);
      case Effect::surface_emission:
        return left * (1.0 - rho) * black(kelvin);
      case Effect::path_scattering:
        return 0.4;
      case Effect::path_emission:
        return 0.3 * black(285.0);
      default:
        return 0.0;  // of what this plane has not
    }
  }
  [[nodiscard]] double whole(Micrometres wavelength, double left = 0.7) const {
    double sum = 0.0;
    for (const Effect source : sources) sum += part(source, wavelength, left);
    return sum;
  }
};

TEST_CASE("an effect that is off takes its closed form out of the image", "[radiometry][effect]") {
  const Method method = GENERATE(Method::path, Method::generic);
  const LitPlane plane;
  const SceneDescription scene = plane.build(method);
  for (const Effect off : sources) {
    const auto seen =
        measure_effects(scene, midwave_effects, downward(), EffectSet::all().without(off));
    CAPTURE(name_of(off));
    for (int i = 0; i < midwave_effects.count(); ++i) {
      const double expected = plane.whole(midwave_effects[i]) - plane.part(off, midwave_effects[i]);
      CHECK(agree(seen.lanes[static_cast<std::size_t>(i)], expected));
    }
  }
}

TEST_CASE("without path transmittance the surface shows in full behind the air's own light",
          "[radiometry][effect]") {
  const Method method = GENERATE(Method::path, Method::generic);
  const LitPlane plane;
  const auto seen = measure_effects(plane.build(method), midwave_effects, downward(),
                                    EffectSet::all().without(Effect::path_transmittance));
  for (int i = 0; i < midwave_effects.count(); ++i) {
    CHECK(agree(seen.lanes[static_cast<std::size_t>(i)], plane.whole(midwave_effects[i], 1.0)));
  }
}

TEST_CASE("with every source off the image is black", "[radiometry][effect]") {
  const Method method = GENERATE(Method::path, Method::generic);
  const auto seen =
      measure_effects(LitPlane{}.build(method), midwave_effects, downward(), without_sources());
  for (const Estimate& lane : seen.lanes) CHECK(lane.mean == 0.0);
}

TEST_CASE("what the sensor sees beyond the scene belongs to its line of sight",
          "[radiometry][effect]") {
  const SceneDescription scene = LitPlane{}.build(GENERATE(Method::path, Method::generic));
  const geometry::Ray upward{{0.0, 0.0, 10.0}, {0.0, 0.0, 1.0}};
  const auto seen = [&](EffectSet effects) {
    return measure_effects(scene, midwave_effects, upward, effects, 2, 1).lanes[1].mean;
  };
  const EffectSet all = EffectSet::all();
  const double warm = spectral::planck(midwave_effects[1], 260.0_K).value;
  CHECK(seen(all) == Approx(0.6 + warm).epsilon(1e-6));
  CHECK(seen(all.without(Effect::path_scattering)) == Approx(warm).epsilon(1e-6));
  CHECK(seen(all.without(Effect::path_emission)) == Approx(0.6).epsilon(1e-6));
  CHECK(seen(all.without(Effect::sky_scattering).without(Effect::sky_emission)) ==
        Approx(0.6 + warm).epsilon(1e-6));
}

TEST_CASE("the sun's disc in the picture goes with solar reflection, dimmed by the line of sight",
          "[radiometry][effect]") {
  LitPlane plane;
  SceneDescription scene = plane.build(GENERATE(Method::path, Method::generic));
  scene.illumination = {body("sun", 50.0, 12.0, 0.25)};
  const geometry::Ray into_sun{{0.0, 0.0, 10.0}, scene.illumination.front().direction_enu};
  const auto seen = [&](EffectSet effects) {
    return measure_effects(scene, midwave_effects, into_sun, effects, 2, 1).lanes[0].mean;
  };
  const double disc = 12.0 / (pi * std::pow(std::sin(degrees(0.25).value), 2));
  const EffectSet sun = alone(Effect::solar_reflection);
  CHECK(seen(sun) == Approx(0.85 * disc).epsilon(1e-5));
  CHECK(seen(sun.without(Effect::path_transmittance)) == Approx(disc).epsilon(1e-5));
  CHECK(seen(sun.without(Effect::solar_reflection)) == 0.0);
}

TEST_CASE("shares of path and emission follow the effects", "[radiometry][effect]") {
  const LitPlane plane;
  const SceneDescription scene = plane.build(Method::path);
  Diagnostics diagnostics;
  const auto shares = [&](EffectSet effects) {
    const LitScene lit{scene, midwave_effects, diagnostics, effects};
    const auto found = effect_shares(lit, downward(), lit.intersect(downward(), Sampler{1, 0}));
    return std::pair{static_cast<double>(found.path[1]), static_cast<double>(found.emission[1])};
  };
  const auto part = [&](Effect source) { return plane.part(source, midwave_effects[1]); };
  const EffectSet all = EffectSet::all();
  const double path = part(Effect::path_scattering) + part(Effect::path_emission);
  CHECK(shares(all).first == Approx(path).epsilon(1e-6));
  CHECK(shares(all).second == Approx(part(Effect::surface_emission)).epsilon(1e-6));
  CHECK(shares(all.without(Effect::path_emission)).first == Approx(0.4).epsilon(1e-6));
  CHECK(shares(all.without(Effect::surface_emission)).second == 0.0);
}

// ---- shadows ----------------------------------------------------------------------------------

/// A plane under a black screen that hides a wide sun and a disc lamp behind it.
SceneDescription screened(Method method, bool sun, bool lamp) {
  SmallScene small;
  small.method = method;
  small.solver = {.initial_sample_count = 16, .mu_samples = 4, .phi_samples = 8};
  small.add(geometry::Plane{{0.0, 0.0, 0.0}, 100.0, 100.0}, small.material(grey(0.5), Kelvin{0.0}));
  const auto black = small.material(grey(0.0), Kelvin{0.0});
  small.add(geometry::Disc{{0.0, 0.0, 1.0}, {0.0, 0.0, 1.0}, 50.0}, black);
  if (lamp) small.add_disc_lamp({{0.0, 0.0, 2.0}, {0.0, 0.0, -1.0}, 1.0}, 7.0, black);
  if (sun) small.add_body(0.0, 60.0, 20.0, 10.0);
  return small.build();
}

TEST_CASE("without shadows sun and lamps shine through everything, and no ray is spent on them",
          "[radiometry][effect]") {
  const Method method = GENERATE(Method::path, Method::generic);
  const geometry::Ray below{{0.0, 0.0, 0.5}, {0.0, 0.0, -1.0}};
  const EffectSet unshadowed = EffectSet::all().without(Effect::shadows);
  // A disc of radiance L and angular radius a overhead: E = pi L sin^2 a, with tan a = 1 / 2.
  const double lamp_light = 0.5 * 7.0 / 5.0;
  const double sun_light = 0.5 * inv_pi * 10.0 * std::sin(degrees(60.0).value);
  const auto lit_by_sun =
      measure_effects(screened(method, true, false), midwave_effects, below, unshadowed, 16, 16);
  CHECK(agree(lit_by_sun.lanes[0], sun_light));
  CHECK(lit_by_sun.counters.target_rays == 0);
  const auto lit_by_lamp =
      measure_effects(screened(method, false, true), midwave_effects, below, unshadowed, 16, 16);
  CHECK(agree(lit_by_lamp.lanes[0], lamp_light));
  CHECK(lit_by_lamp.counters.lamp_rays == 0);
  const auto dark =
      measure_effects(screened(method, true, true), midwave_effects, below, EffectSet::all(), 4, 4);
  CHECK(dark.lanes[0].mean == 0.0);
  CHECK(dark.counters.target_rays > 0);
}

// ---- interreflection --------------------------------------------------------------------------

/// A closed room whose walls are alike, and its radiance as a black body's share.
SceneDescription room(Method method, double rho, bool min_samples = true) {
  SmallScene small;
  small.method = method;
  small.solver = {.initial_sample_count = 32,
                  .mu_samples = 4,
                  .phi_samples = 8,
                  .min_quad_samples = min_samples ? 1 : 0};
  small.add(geometry::Box{{-5.0, -5.0, -5.0}, {5.0, 5.0, 5.0}}, small.material(grey(rho), 300.0_K));
  return small.build();
}

TEST_CASE("without interreflection a furnace shows its walls and one reflection of them",
          "[radiometry][effect]") {
  const Method method = GENERATE(Method::path, Method::generic);
  const bool min_samples = GENERATE(true, false);
  const double rho = GENERATE(0.2, 0.9);
  const geometry::Ray inside{{0.3, 0.2, 0.1}, normalised(Vec3{0.2, 0.3, -1.0})};
  const auto seen = measure_effects(room(method, rho, min_samples), midwave_effects, inside,
                                    EffectSet::all().without(Effect::interreflection), 16, 16);
  for (int i = 0; i < midwave_effects.count(); ++i) {
    const double own = (1.0 - rho) * spectral::planck(midwave_effects[i], 300.0_K).value;
    CHECK(agree(seen.lanes[static_cast<std::size_t>(i)], own * (1.0 + rho)));
  }
  CHECK(seen.counters.full_samples == 0);
  CHECK(seen.counters.path_rays <= seen.counters.primary_rays);
  CHECK(seen.counters.bounce_limit_stops == 0);  // what was asked for is no bias
}

TEST_CASE("a clear pane before the sensor does not count as a reflection", "[radiometry][effect]") {
  const Method method = GENERATE(Method::path, Method::generic);
  SmallScene small;
  small.method = method;
  small.solver = {.initial_sample_count = 16, .mu_samples = 4, .phi_samples = 8};
  small.add(geometry::Plane{{0.0, 0.0, 0.0}, 1000.0, 1000.0},
            small.material(grey(0.4), Kelvin{0.0}));
  materials::Material pane = grey(0.0);
  pane.transmittance = spectral::Curve::constant(0.8);
  pane.scattering = materials::ClearSheet{};
  // So small that it is 4e-6 of what the plane sees above.
  small.add(geometry::Disc{{0.0, 0.0, 5.0}, {0.0, 0.0, 1.0}, 0.01},
            small.material(pane, Kelvin{0.0}));
  small.sky(3.0);
  small.add_body(0.0, 45.0, 1e-4, 10.0);
  const auto seen = measure_effects(small.build(), midwave_effects, downward(),
                                    EffectSet::all().without(Effect::interreflection), 16, 16);
  const double expected = 0.8 * 0.4 * (3.0 + inv_pi * 10.0 * std::sin(degrees(45.0).value));
  CHECK(agree(seen.lanes[0], expected));
}

TEST_CASE("without interreflection light from a volume is not reflected by a surface as well",
          "[radiometry][effect]") {
  const Method method = GENERATE(Method::path, Method::generic);
  // Under a black screen that hides the sun only haze could light the plane.
  SmallScene small;
  small.method = method;
  small.solver = {.initial_sample_count = 16, .mu_samples = 4, .phi_samples = 8};
  small.add(geometry::Plane{{0.0, 0.0, 0.0}, 500.0, 500.0}, small.material(grey(0.5), Kelvin{0.0}));
  small.add(geometry::Disc{{0.0, 0.0, 20.0}, {0.0, 0.0, 1.0}, 50.0},
            small.material(grey(0.0), Kelvin{0.0}));
  small.add_body(0.0, 60.0, 1e-4, 10.0);
  const auto none = spectral::Curve::constant(0.0);
  Volume haze = volume_test::slab(none, spectral::Curve::constant(0.01));
  haze.region =
      geometry::Region{geometry::Box{{-200.0, -200.0, 1.0}, {200.0, 200.0, 15.0}}, Affine{}};
  small.volumes = {haze};
  const geometry::Ray below{{0.0, 0.0, 0.5}, {0.0, 0.0, -1.0}};
  const auto all = measure_effects(small.build(), midwave_effects, below, EffectSet::all(), 4,
                                   method == Method::path ? 200 : 4);
  CHECK(all.lanes[0].mean > 0.0);
  CHECK(all.counters.volume_events > 0);
  const EffectSet once = EffectSet::all().without(Effect::interreflection);
  CHECK(measure_effects(small.build(), midwave_effects, below, once).lanes[0].mean == 0.0);
  // The other way round: what the sensor sees of the haze, lit by the sun, stays.
  const geometry::Ray along{{-190.0, 0.0, 8.0}, {0.0, 1.0, 0.0}};
  const auto seen = measure_effects(small.build(), midwave_effects, along, once);
  CHECK(seen.lanes[0].mean > 0.0);
}

TEST_CASE("a volume that is off neither dims nor scatters, and is not bound",
          "[radiometry][effect]") {
  const Method method = GENERATE(Method::path, Method::generic);
  SceneDescription scene = LitPlane{}.build(method);
  Volume smoke =
      volume_test::slab(spectral::Curve::constant(0.05), spectral::Curve::constant(0.02));
  smoke.medium.phase = materials::HenyeyGreenstein{};
  scene.volumes = {smoke};
  const LitPlane plane;
  const EffectSet clear = EffectSet::all().without(Effect::volumes);
  const auto seen = measure_effects(scene, midwave_effects, downward(20.0), clear);
  CHECK(agree(seen.lanes[1], plane.whole(midwave_effects[1])));
  CHECK(seen.counters.volume_events == 0);
  Diagnostics diagnostics;
  CHECK(LitScene{scene, midwave_effects, diagnostics, clear}.volumes().empty());
  CHECK_FALSE(LitScene{scene, midwave_effects, diagnostics}.volumes().empty());
}

// ---- leaves -----------------------------------------------------------------------------------

materials::Material leafy_mixture() {
  materials::Material material;
  material.name = "leaves and twigs";
  material.scattering =
      materials::Mixture{{{0.6, std::make_shared<const materials::Material>(leaf(0.4, 0.5))},
                          {0.4, std::make_shared<const materials::Material>(grey(0.1))}}};
  return material;
}

SceneDescription leaf_overhead(Method method, const materials::Material& material, double kelvin) {
  SmallScene small;
  small.method = method;
  small.solver = {.initial_sample_count = 16, .mu_samples = 4, .phi_samples = 8};
  small.add(geometry::Plane{{0.0, 0.0, 0.0}, 1000.0, 1000.0},
            small.material(material, Kelvin{kelvin}));
  small.add_body(0.0, 90.0, 1e-4, 10.0);
  return small.build();
}

TEST_CASE("without leaf transmission nothing comes through a leaf, and it emits as before",
          "[radiometry][effect]") {
  const Method method = GENERATE(Method::path, Method::generic);
  const bool mixed = GENERATE(false, true);
  const materials::Material material = mixed ? leafy_mixture() : leaf(0.4, 0.5);
  const double through = mixed ? 0.6 * 0.5 : 0.5, back = mixed ? 0.6 * 0.4 + 0.4 * 0.1 : 0.4;
  const EffectSet all = EffectSet::all(), opaque = all.without(Effect::leaf_transmission);
  const geometry::Ray from_below{{0.0, 0.0, -5.0}, {0.0, 0.0, 1.0}};
  const auto seen = [&](double kelvin, const geometry::Ray& ray, EffectSet effects) {
    return measure_effects(leaf_overhead(method, material, kelvin), midwave_effects, ray, effects)
        .lanes[1];
  };
  CHECK(agree(seen(0.0, from_below, all), through * inv_pi * 10.0));
  CHECK(seen(0.0, from_below, opaque).mean == 0.0);
  CHECK(agree(seen(0.0, downward(), opaque), back * inv_pi * 10.0));
  const double own = (1.0 - through - back) * spectral::planck(midwave_effects[1], 300.0_K).value;
  CHECK(agree(seen(300.0, from_below, opaque), own, 1e-4));  // mixture: tables of albedo
}

TEST_CASE("leaves that state emissivity and transmittance keep the reflectance that follows",
          "[radiometry][effect]") {
  materials::Material material = leaf(0.4, 0.5);
  material.reflectance.reset();
  material.emissivity = spectral::Curve::constant(0.2);  // so that 0.3 is reflected
  const auto seen =
      measure_effects(leaf_overhead(Method::path, material, 0.0), midwave_effects, downward(),
                      EffectSet::all().without(Effect::leaf_transmission));
  CHECK(agree(seen.lanes[0], 0.3 * inv_pi * 10.0));
}

}  // namespace
}  // namespace nadir::radiometry::test
