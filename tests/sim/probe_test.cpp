#include "sim/run/probe.hpp"

#include <algorithm>
#include <numeric>
#include <set>
#include <tuple>

#include "sim/goal_scene.hpp"
#include "support/catch.hpp"

namespace nadir::sim {

using test::plain_world;
using test::rendered;

TEST_CASE("a probed pixel is the pixel that a run renders", "[sim][probe]") {
  const support::ScratchFolder folder;
  const World world = plain_world({.samples = 6, .lines = 5}, folder);
  RenderOptions options;
  options.seed = 9;
  const ArrayImage image = rendered(world, options);
  const std::vector<PixelPlace> places{{0, 5, 4}, {0, 0, 0}, {0, 3, 1}};
  Diagnostics diagnostics;
  for (const int threads : {1, 2}) {
    options.threads = threads;
    const ProbeResult found = probe_pixels(world, options, places, diagnostics);
    REQUIRE(found.pixels.size() == 3);
    for (std::size_t i = 0; i < places.size(); ++i) {
      const ProbedPixel& pixel = found.pixels[i];
      CHECK(pixel.place.sample == places[i].sample);
      const auto at = static_cast<std::size_t>(places[i].line * 6 + places[i].sample);
      CHECK(static_cast<float>(pixel.bands.at(0).mean) == image.bands[0].radiance[at]);
      CHECK(static_cast<float>(pixel.bands[0].standard_error) == image.bands[0].standard_error[at]);
      const auto& replicates = pixel.replicates.at(0);
      REQUIRE(replicates.size() == 4);
      CHECK(std::accumulate(replicates.begin(), replicates.end(), 0.0) / 4.0 ==
            Approx(pixel.bands[0].mean).epsilon(1e-14));
      CHECK(pixel.paths == 8);
      CHECK(pixel.cpu_s > 0.0);
    }
    CHECK(found.counters.primary_rays == 3 * 8);
    CHECK(found.counters.truth_rays == 0);
  }
}

TEST_CASE("random pixels are drawn once each, in order", "[sim][probe]") {
  const support::ScratchFolder folder;
  const World world = plain_world({.samples = 13, .lines = 7}, folder);
  const auto key = [](const PixelPlace& p) { return std::tuple{p.array, p.line, p.sample}; };
  for (const int count : {0, 1, 40, 91, 1000}) {
    const auto places = random_pixels(world, count, 3);
    CHECK(places.size() == static_cast<std::size_t>(std::min(count, 91)));
    std::set<std::tuple<int, int, int>> different;
    for (const PixelPlace& place : places) {
      CHECK((place.sample >= 0 && place.sample < 13 && place.line >= 0 && place.line < 7));
      different.insert(key(place));
    }
    CHECK(different.size() == places.size());
    CHECK(std::is_sorted(places.begin(), places.end(),
                         [&](const auto& a, const auto& b) { return key(a) < key(b); }));
  }
}

TEST_CASE("every pixel is as likely to be drawn as any other", "[sim][probe]") {
  const support::ScratchFolder folder;
  const World world = plain_world({.samples = 5, .lines = 4}, folder);
  std::vector<int> counts(20);
  constexpr int draws = 2000;
  for (int seed = 0; seed < draws; ++seed) {
    for (const PixelPlace& place : random_pixels(world, 5, static_cast<std::uint64_t>(seed))) {
      ++counts[static_cast<std::size_t>(place.line * 5 + place.sample)];
    }
  }
  // 500 times each; standard deviation sqrt(2000 / 4 * 3 / 4) = 19, five of them.
  for (const int count : counts) CHECK(std::abs(count - 500) < 97);
}

}  // namespace nadir::sim
