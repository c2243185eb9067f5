#include <algorithm>
#include <bit>
#include <cmath>

#include "sim/goal_scene.hpp"
#include "sim/run/merge_images.hpp"
#include "sim/run/strip_renderer.hpp"
#include "support/catch.hpp"

// Rendering to a goal: rounds, kept tiles, and whether the stated errors hold.

namespace nadir::sim {
namespace {

using test::goal_of;
using test::MemoryStore;
using test::plain_world;
using test::rendered;

bool same_planes(const ArrayImage& a, const ArrayImage& b) {
  return a.bands[0].radiance == b.bands[0].radiance &&
         a.bands[0].standard_error == b.bands[0].standard_error &&
         a.bands[0].brightness_temperature == b.bands[0].brightness_temperature &&
         a.bands[0].brightness_temperature_error == b.bands[0].brightness_temperature_error &&
         a.pixel_paths == b.pixel_paths && a.truth.material == b.truth.material &&
         a.truth.range_m == b.truth.range_m;
}

RenderOptions fixed_options(int samples = 4) {
  RenderOptions options;
  options.sampling.replicates = 4;
  options.sampling.samples_per_replicate = samples;
  return options;
}

/// The share of pixels that differ from a reference by no more than twice the joint error.
double share_inside(const ArrayImage& image, const ArrayImage& reference) {
  double inside = 0.0;
  for (std::size_t i = 0; i < image.pixels(); ++i) {
    const double off = std::abs(image.bands[0].radiance[i] - reference.bands[0].radiance[i]);
    const double joint =
        std::hypot(image.bands[0].standard_error[i], reference.bands[0].standard_error[i]);
    inside += off <= 2.0 * joint ? 1.0 : 0.0;
  }
  return inside / static_cast<double>(image.pixels());
}

}  // namespace

TEST_CASE("every pixel meets its goal, with no fewer paths than the least", "[sim][goal]") {
  const support::ScratchFolder folder;
  const World world = plain_world({.samples = 8, .lines = 6}, folder);
  const SamplingGoal goal = goal_of(0.05);
  RenderOptions options;
  options.goal = &goal;
  Diagnostics diagnostics;
  const auto result = render(world.scene, world.camera, options, diagnostics);
  const ArrayImage& image = result.images.at(0);
  REQUIRE(image.pixel_paths.size() == image.pixels());
  for (std::size_t i = 0; i < image.pixels(); ++i) {
    CHECK(image.pixel_paths[i] >= 32);
    CHECK(image.bands[0].standard_error[i] <= 0.05001F * image.bands[0].radiance[i]);
    CHECK(image.bands[0].standard_error[i] > 0.0F);
    CHECK(image.bands[0].brightness_temperature_error[i] > 0.0F);
  }
  CHECK(result.outcome.arrays.at(0).met == 1.0);
  CHECK(result.outcome.arrays[0].pixels == 48);
  CHECK(result.outcome.arrays[0].most_paths ==
        *std::max_element(image.pixel_paths.begin(), image.pixel_paths.end()));
}

TEST_CASE("a goal out of reach ends at the most samples and says so", "[sim][goal]") {
  const support::ScratchFolder folder;
  const World world = plain_world({.samples = 2, .lines = 2}, folder);
  const SamplingGoal goal = goal_of(1e-6, 16);
  RenderOptions options;
  options.goal = &goal;
  Diagnostics diagnostics;
  const auto result = render(world.scene, world.camera, options, diagnostics);
  CHECK(result.outcome.arrays.at(0).met == 0.0);
  CHECK(result.outcome.arrays[0].bands.at(0).worst > 1e-4);
  for (const auto paths : result.images.at(0).pixel_paths) CHECK(paths == 16 * 16);
}

TEST_CASE("the number of threads shows in no bit of an image sampled to a goal", "[sim][goal]") {
  const support::ScratchFolder folder;
  const World world = plain_world({.samples = 20, .lines = 6}, folder);
  const SamplingGoal goal = goal_of(0.1);
  RenderOptions options;
  options.goal = &goal;
  options.threads = 1;
  const ArrayImage one = rendered(world, options);
  options.threads = 2;
  CHECK(same_planes(one, rendered(world, options)));
}

TEST_CASE("tiles that are kept are not computed again, and give the same bytes", "[sim][goal]") {
  const support::ScratchFolder folder;
  const World world = plain_world({.samples = 20, .lines = 6}, folder);
  const SamplingGoal goal = goal_of(0.1);
  for (const bool to_goal : {false, true}) {
    MemoryStore store;
    RenderOptions options = fixed_options();
    if (to_goal) options.goal = &goal;
    Diagnostics diagnostics;
    const auto bare = render(world.scene, world.camera, options, diagnostics);
    options.store = &store;
    const ArrayImage first = rendered(world, options);
    CHECK(same_planes(first, bare.images[0]));
    const int tiles = store.kept_tiles;
    CHECK(tiles > 1);
    // As if the run had been killed before its last tile.
    store.tiles.erase(std::prev(store.tiles.end()));
    const auto again = render(world.scene, world.camera, options, diagnostics);
    CHECK(same_planes(first, again.images[0]));
    CHECK(store.found_tiles == tiles - 1);
    CHECK(store.kept_tiles == tiles + 1);
    CHECK(again.counters.rays() == bare.counters.rays());
  }
}

TEST_CASE("another round is independent and merges with the first", "[sim][goal]") {
  const support::ScratchFolder folder;
  const World world = plain_world({.samples = 6, .lines = 6}, folder);
  MemoryStore store;
  RenderOptions options = fixed_options();
  options.store = &store;
  const ArrayImage first = rendered(world, options);
  options.rounds = {1, 2};
  const ArrayImage both = rendered(world, options);
  ArrayImage expected = first;
  // The second round by itself, from the tiles that were kept.
  ArrayImage second = first;
  for (const auto& [key, record] : store.tiles) {
    if (key.round == 1) paste(second, record.pixels);
  }
  CHECK(second.bands[0].radiance != first.bands[0].radiance);
  merge(expected, second, {});
  CHECK(both.bands[0].radiance == expected.bands[0].radiance);
  CHECK(both.bands[0].standard_error == expected.bands[0].standard_error);
  CHECK(both.pixel_paths.empty());  // all pixels have as many
  CHECK(both.paths == 32);
  CHECK(both.truth.material == first.truth.material);
  for (const auto& [key, record] : store.tiles) {
    CHECK(record.pixels.truth.material.empty() == (key.round > 0));
  }
}

TEST_CASE("a round that was kept in part is merged where it is there", "[sim][goal]") {
  const support::ScratchFolder folder;
  const World world = plain_world({.samples = 20, .lines = 6}, folder);
  MemoryStore store;
  RenderOptions options = fixed_options();
  options.store = &store;
  options.rounds = {0, 2};
  (void)rendered(world, options);
  store.tiles.erase(std::prev(store.tiles.end()));  // of round 1
  options.rounds = {2, 2};
  const int kept = store.kept_tiles;
  const ArrayImage image = rendered(world, options);
  CHECK(store.kept_tiles == kept);  // nothing is computed
  const auto with = std::count(image.pixel_paths.begin(), image.pixel_paths.end(), 32U);
  const auto without = std::count(image.pixel_paths.begin(), image.pixel_paths.end(), 16U);
  CHECK(with + without == 120);
  CHECK(without > 0);
  CHECK(with > 0);
}

TEST_CASE("what is stated of systematic errors is a plane of its own", "[sim][goal]") {
  const support::ScratchFolder folder;
  const World world = plain_world({.samples = 2, .lines = 2}, folder);
  SamplingGoal goal = goal_of(0.5);
  const std::vector<std::vector<double>> bias{{0.02}};
  RenderOptions options = fixed_options();
  options.bias = &bias;
  CHECK(rendered(world, options).bands[0].bias.empty());
  options.goal = &goal;
  const ArrayImage image = rendered(world, options);
  CHECK(image.bands[0].bias.at(0) == Approx(0.02 * image.bands[0].radiance[0]).epsilon(1e-6));
  goal.bands[0][0].floor_radiance = 1000.0;
  CHECK(rendered(world, options).bands[0].bias.at(0) == Approx(20.0).epsilon(1e-6));
}

TEST_CASE("the stated errors hold over a plain with a warm sphere", "[sim][goal]") {
  const support::ScratchFolder folder;
  const World world = plain_world({.samples = 10, .lines = 10}, folder);
  const SamplingGoal goal = goal_of(0.1);
  RenderOptions options, reference = fixed_options(128);
  options.goal = &goal;
  reference.seed = 2;
  reference.sampling.replicates = 16;
  options.truth = reference.truth = false;
  // 95 % are promised; of 100 pixels, 2.2 % more or less: two of these.
  CHECK(share_inside(rendered(world, options), rendered(world, reference)) > 0.9);
}

TEST_CASE("a light that few paths find is not missed", "[sim][goal]") {
  // One path in 300 meets the sphere, which is 7 % of the light: of 32 paths, nine pixels in ten
  // see nothing of it, and with those alone 60 % of the pixels would be wrong beyond their errors.
  const support::ScratchFolder folder;
  const World world = plain_world(
      {.sphere_k = 1000.0, .radius_m = 14.0, .distance_m = 90.0, .samples = 10, .lines = 10},
      folder);
  const SamplingGoal goal = goal_of(0.05);
  RenderOptions options, reference = fixed_options(128);
  options.goal = &goal;
  reference.seed = 2;
  reference.sampling.replicates = 16;
  options.truth = reference.truth = false;
  CHECK(share_inside(rendered(world, options), rendered(world, reference)) > 0.9);  // as above
}

TEST_CASE("small tiles look longer, large ones as long as the goal says", "[sim][goal]") {
  const SamplingGoal goal = goal_of(0.01);
  CHECK(first_look(goal, 256) == 2);
  CHECK(first_look(goal, 16) == 4);
  CHECK(first_look(goal, 1) == 64);
  CHECK(first_look(goal_of(0.01, 16), 1) == 16);
}

}  // namespace nadir::sim
