#include <cmath>
#include <numbers>

#include "core/error.hpp"
#include "radiometry/effect_scene.hpp"
#include "radiometry/volume_helpers.hpp"
#include "support/catch.hpp"

// Effects that bring light add up; what is off is neither bound nor traced.

namespace nadir::radiometry::test {
namespace {

const spectral::Lanes midwave{{3.8_um, 4.0_um, 4.2_um}};

/// A corner of warm walls and leaves, under sun, moon, an overcast sky and two lamps.
SceneDescription corner(Method method) {
  SmallScene small;
  small.method = method;
  small.solver = {.initial_sample_count = 6, .max_bounces = 1, .mu_samples = 2, .phi_samples = 6};
  small.add(geometry::Plane{{0.0, 0.0, 0.0}, 100.0, 100.0}, small.material(grey(0.4), 300.0_K));
  small.add(geometry::Box{{2.0, -4.0, 0.0}, {3.0, 4.0, 3.0}}, small.material(grey(0.7), 310.0_K));
  small.add(geometry::Disc{{-2.0, 0.0, 2.0}, {0.3, 0.0, 0.9539392014169457}, 1.5},
            small.material(leaf(0.4, 0.4), 295.0_K));
  small.add_disc_lamp({{0.0, 3.0, 3.0}, {0.0, 0.0, -1.0}, 0.5}, 20.0,
                      small.material(grey(0.1), 290.0_K));
  small.lamps.push_back(nadir::test::point_lamp({0.0, -2.0, 1.5}, 30.0));
  SceneDescription scene = small.build();
  atmosphere::Uniform air = full_air();
  air.sky_shape = atmosphere::SkyShape::overcast;
  scene.atmosphere = air;
  scene.illumination = {body("sun", 50.0, 12.0, 0.3), body("moon", 20.0, 5.0, 0.3)};
  return scene;
}

const geometry::Ray into_corner{{-6.0, 0.5, 4.0}, normalised(Vec3{0.75, -0.03, -0.45})};

TEST_CASE("images of single sources add up to the image of all", "[radiometry][effect]") {
  const Method method = GENERATE(Method::path, Method::generic);
  SceneDescription scene = corner(method);
  const bool hazy = GENERATE(false, true);
  if (hazy) {
    scene.volumes = {
        volume_test::slab(spectral::Curve::constant(0.005), spectral::Curve::constant(0.02))};
  }
  constexpr int replicates = 16, samples = 8;
  const auto seen = [&](EffectSet effects) {
    return measure_effects(scene, midwave, into_corner, effects, replicates, samples);
  };
  const Measured all = seen(EffectSet::all());
  double sum = 0.0, variance = std::pow(all.lanes[1].standard_error, 2);
  for (const Effect source : sources) {
    const Estimate part = seen(alone(source)).lanes[1];
    CAPTURE(name_of(source));
    CHECK(part.mean > 0.0);
    sum += part.mean;
    variance += std::pow(part.standard_error, 2);
  }
  CAPTURE(hazy, sum, all.lanes[1].mean);
  CHECK(std::abs(sum - all.lanes[1].mean) < 4.5 * std::sqrt(variance));
  CHECK(std::sqrt(variance) < 0.05 * sum);  // so that a source counted twice would show
}

TEST_CASE("under an even sky the walks of single sources are the same, and add up to rounding",
          "[radiometry][effect]") {
  SceneDescription scene = corner(Method::path);
  scene.atmosphere = full_air();
  const auto seen = [&](EffectSet effects) {
    return measure_effects(scene, midwave, into_corner, effects, 8, 8).lanes;
  };
  const auto all = seen(EffectSet::all());
  std::vector<double> sum(all.size(), 0.0);
  for (const Effect source : sources) {
    const auto part = seen(alone(source));
    for (std::size_t lane = 0; lane < sum.size(); ++lane) sum[lane] += part[lane].mean;
  }
  for (std::size_t lane = 0; lane < sum.size(); ++lane) {
    CHECK(sum[lane] == Approx(all[lane].mean).epsilon(2e-6));  // float lanes
  }
}

TEST_CASE("effects that are off send no rays", "[radiometry][effect]") {
  const Method method = GENERATE(Method::path, Method::generic);
  const SceneDescription scene = corner(method);
  const auto counted = [&](EffectSet effects) {
    return measure_effects(scene, midwave, into_corner, effects, 2, 8).counters;
  };
  const EffectSet all = EffectSet::all();
  const Counters full = counted(all);
  CHECK(full.target_rays > 0);
  CHECK(full.lamp_rays > 0);
  const Counters moonlit = counted(all.without(Effect::solar_reflection));
  CHECK(moonlit.target_rays < full.target_rays);
  CHECK(moonlit.target_rays > 0);
  const EffectSet no_bodies =
      all.without(Effect::solar_reflection).without(Effect::lunar_reflection);
  CHECK(counted(no_bodies).target_rays == 0);
  CHECK(counted(all.without(Effect::lamps)).lamp_rays == 0);
  CHECK(counted(all.without(Effect::shadows)).target_rays == 0);
  CHECK(counted(all.without(Effect::shadows)).lamp_rays == 0);
  const Counters once = counted(all.without(Effect::interreflection));
  CHECK(once.rays() < full.rays());
  CHECK(once.full_samples == 0);
}

TEST_CASE("effects that are off are not bound", "[radiometry][effect]") {
  const SceneDescription scene = corner(Method::path);
  Diagnostics diagnostics;
  const auto lit = [&](EffectSet effects) {
    return LitScene{scene, midwave, diagnostics, effects};
  };
  const EffectSet all = EffectSet::all();
  CHECK(lit(all).effects() == all);
  CHECK(lit(all).targets().size() == 2);
  const LitScene night = lit(all.without(Effect::solar_reflection));
  CHECK(night.effects() == all.without(Effect::solar_reflection));
  CHECK(night.targets().size() == 1);
  CHECK(lit(all.without(Effect::lunar_reflection)).targets().size() == 1);
  CHECK_FALSE(lit(all).lamps().empty());
  CHECK(lit(all.without(Effect::lamps)).lamps().empty());
  CHECK_FALSE(lit(all).sky_distribution().empty());  // overcast
  CHECK(lit(all.without(Effect::sky_scattering)).sky_distribution().empty());
  constexpr std::uint32_t leaves = 2;
  CHECK(lit(all).material(leaves).traits.transmits);
  CHECK_FALSE(lit(all.without(Effect::leaf_transmission)).material(leaves).traits.transmits);
}

TEST_CASE("without surface emission no table of Planck's law is made", "[radiometry][effect]") {
  SmallScene small;
  thermal::MappedTemperature map;
  map.frame.origin = {-1.0, 0.5};
  map.frame.step = {1.0, -1.0};
  map.frame.columns = 2;
  map.frame.rows = 1;
  map.kelvin = {280.0F, 320.0F};
  small.add(geometry::Plane{{}, 2.0, 1.0}, small.material(grey(0.3), map));
  const SceneDescription scene = small.build();
  Diagnostics diagnostics;
  const EffectSet all = EffectSet::all();
  CHECK(LitScene{scene, midwave, diagnostics, all}.emission_varies());
  const LitScene cold{scene, midwave, diagnostics, all.without(Effect::surface_emission)};
  CHECK_FALSE(cold.emission_varies());
  CHECK_FALSE(cold.emits());
}

/// Whether a scene can be lit at lanes that the curve of one of its parts does not cover.
bool binds(const SceneDescription& scene, EffectSet effects) {
  Diagnostics diagnostics;
  try {
    const LitScene lit{scene, midwave, diagnostics, effects};
    return true;
  } catch (const InputError&) {
    return false;
  }
}

TEST_CASE("the curves of what is off are never looked up", "[radiometry][effect]") {
  const spectral::Curve visible_only{{0.4, 0.7}, {1.0, 1.0}, spectral::Outside::reject};
  SceneDescription scene = SmallScene{}.build();
  const Effect effect = GENERATE(Effect::solar_reflection, Effect::lunar_reflection, Effect::lamps,
                                 Effect::volumes, Effect::path_scattering);
  if (effect == Effect::solar_reflection) scene.illumination = {body("sun", 45.0, 1.0)};
  if (effect == Effect::lunar_reflection) scene.illumination = {body("moon", 45.0, 1.0)};
  for (auto& light : scene.illumination) light.irradiance = visible_only;
  if (effect == Effect::lamps) {
    scene.lamps = {nadir::test::point_lamp({0.0, 0.0, 1.0}, 1.0)};
    scene.lamps.front().flux = visible_only;
  }
  if (effect == Effect::volumes) {
    scene.volumes = {volume_test::slab(visible_only, visible_only)};
  }
  if (effect == Effect::path_scattering) {
    atmosphere::Uniform air = full_air();
    air.path_radiance = visible_only;
    scene.atmosphere = air;
  }
  CAPTURE(name_of(effect));
  CHECK_FALSE(binds(scene, EffectSet::all()));
  CHECK(binds(scene, EffectSet::all().without(effect)));
}

}  // namespace
}  // namespace nadir::radiometry::test
