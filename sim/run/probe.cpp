#include "sim/run/probe.hpp"

#include <algorithm>
#include <chrono>
#include <ctime>
#include <memory>
#include <mutex>
#include <set>
#include <utility>

#include "core/random.hpp"
#include "sim/run/array_job.hpp"
#include "sim/run/tiles.hpp"

namespace nadir::sim {
namespace {

double thread_cpu_s() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

RenderOptions without_truth(RenderOptions options) {
  options.truth = false;
  options.sky_view = options.fractions = false;
  options.frame = nullptr;
  options.store = nullptr;
  return options;
}

/// The arrays that have pixels among the places, by number; null where one has none.
std::vector<std::unique_ptr<ArrayJob>> jobs_of(const World& world, const RenderOptions& options,
                                               std::span<const PixelPlace> places,
                                               Diagnostics& diagnostics) {
  const CameraPlan plan = plan_of(world.camera, options);
  std::vector<std::unique_ptr<ArrayJob>> jobs(world.camera.arrays.size());
  for (const PixelPlace& place : places) {
    const auto number = static_cast<std::size_t>(place.array);
    if (jobs.at(number)) continue;
    jobs[number] = std::make_unique<ArrayJob>(
        array_job(world.scene, world.camera, number, plan.arrays[number], options, diagnostics));
  }
  return jobs;
}

/// Every place as a tile of one pixel, whose `array` is the place's number.
std::vector<Tile> tiles_of_places(std::span<const PixelPlace> places) {
  std::vector<Tile> tiles;
  for (std::size_t i = 0; i < places.size(); ++i) {
    tiles.push_back({static_cast<int>(i), places[i].sample, places[i].line, 1, 1});
  }
  return tiles;
}

ProbedPixel probe(const ArrayJob& job, const RenderOptions& options, const PixelPlace& place,
                  radiometry::Counters& counters) {
  const double start = thread_cpu_s();
  PixelRenderer renderer{job, options, {round_key(options.seed, job.number, 0), false}};
  PixelMeasure measure;
  renderer.measure(place.sample, place.line, measure);
  counters = renderer.counters();
  return {place, std::move(measure.bands), std::move(measure.replicates), measure.paths,
          thread_cpu_s() - start};
}

std::uint64_t pixels_in(const sensor::DetectorArray& array) {
  return static_cast<std::uint64_t>(array.samples) * static_cast<std::uint64_t>(array.lines);
}

/// How many of the pixels each array gets: in proportion, at least one each while there are some.
std::vector<std::uint64_t> counts_of(const World& world, std::uint64_t count) {
  std::uint64_t all = 0, left = count;
  for (const auto& array : world.camera.arrays) all += pixels_in(array);
  std::vector<std::uint64_t> counts;
  for (const auto& array : world.camera.arrays) {
    const auto share = static_cast<std::uint64_t>(static_cast<double>(count) *
                                                      static_cast<double>(pixels_in(array)) /
                                                      static_cast<double>(all) +
                                                  0.5);
    counts.push_back(std::min({std::max<std::uint64_t>(share, 1), pixels_in(array), left}));
    left -= counts.back();
  }
  return counts;
}

}  // namespace

ProbeResult probe_pixels(const World& world, const RenderOptions& options,
                         std::span<const PixelPlace> places, Diagnostics& diagnostics) {
  const RenderOptions render = without_truth(options);
  const auto jobs = jobs_of(world, render, places, diagnostics);
  ProbeResult result;
  result.pixels.resize(places.size());
  std::mutex mutex;
  const auto start = std::chrono::steady_clock::now();
  for_each_tile(tiles_of_places(places), render.threads, [&](const Tile& tile) {
    const auto number = static_cast<std::size_t>(tile.array);
    radiometry::Counters counters;
    result.pixels[number] = probe(*jobs[static_cast<std::size_t>(places[number].array)], render,
                                  places[number], counters);
    const std::scoped_lock lock{mutex};
    result.counters += counters;
    result.cpu_s += result.pixels[number].cpu_s;
  });
  result.wall_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return result;
}

std::vector<PixelPlace> random_pixels(const World& world, int count, std::uint64_t seed) {
  std::vector<PixelPlace> places;
  const auto counts = counts_of(world, static_cast<std::uint64_t>(std::max(count, 0)));
  for (std::size_t a = 0; a < counts.size(); ++a) {
    const sensor::DetectorArray& array = world.camera.arrays[a];
    const std::uint64_t pixels = pixels_in(array);
    // Floyd's algorithm draws so many different numbers: CACM 30, 754 (1987).
    std::set<std::uint64_t> chosen;
    Rng rng{seed, a};
    for (std::uint64_t last = pixels - counts[a]; last < pixels; ++last) {
      const auto drawn = static_cast<std::uint64_t>(rng.next() * static_cast<double>(last + 1));
      if (!chosen.insert(std::min(drawn, last)).second) chosen.insert(last);
    }
    for (const std::uint64_t pixel : chosen) {
      const auto samples = static_cast<std::uint64_t>(array.samples);
      places.push_back({static_cast<int>(a), static_cast<int>(pixel % samples),
                        static_cast<int>(pixel / samples)});
    }
  }
  return places;
}

}  // namespace nadir::sim
