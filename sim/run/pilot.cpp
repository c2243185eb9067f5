#include "sim/run/pilot.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <tuple>

namespace nadir::sim {
namespace {

// Enough that 95 % of all pixels are seen by some of them, few enough to cost little.
constexpr int first_pixels = 16;
// 7 degrees of freedom: a pixel's variance is known to 50 %, the mean of 100 pixels' to 5 %.
constexpr int pilot_replicates = 8;
constexpr int pilot_samples = 2;  // the least that a goal's first round has
constexpr int most_pilot_samples = 64;
// Pixels of the pilot have numbers of their own, apart from the audit's.
constexpr std::uint64_t pilot_salt = 0x70696C6F74ULL;

using PixelName = std::tuple<int, int, int>;

PixelName name_of_pixel(const PixelPlace& place) { return {place.array, place.line, place.sample}; }

/// Random pixels that have not been looked at.
std::vector<PixelPlace> new_pixels(const World& world, int count, std::uint64_t seed,
                                   const std::set<PixelName>& seen) {
  std::vector<PixelPlace> places = random_pixels(world, count, seed);
  std::erase_if(places,
                [&](const PixelPlace& place) { return seen.count(name_of_pixel(place)) > 0; });
  return places;
}

/// Looks at more pixels. What only the first look costs is not the rays': where it can be much,
/// there is a second one, and the first tells no more than that.
void look_at(const World& world, const RenderOptions& options, std::span<const PixelPlace> places,
             Diagnostics& diagnostics, Pilot& pilot) {
  ProbeResult probe = probe_pixels(world, options, places, diagnostics);
  if (pilot.pixels.empty() || world.heat) {
    const double touched_s = probe.cpu_s;
    pilot.wall_s += probe.wall_s;
    probe = probe_pixels(world, options, places, diagnostics);
    pilot.first_touch_s += std::max(0.0, touched_s - probe.cpu_s);
  }
  pilot.counters += probe.counters;
  pilot.cpu_s += probe.cpu_s;
  pilot.wall_s += probe.wall_s;
  for (ProbedPixel& pixel : probe.pixels) {
    pilot.paths += pixel.paths;
    pilot.pixels.push_back(std::move(pixel));
  }
}

std::vector<double> mean_seconds(const Pilot& pilot, std::size_t arrays) {
  std::vector<double> seconds(arrays, 0.0), paths(arrays, 0.0);
  for (const ProbedPixel& pixel : pilot.pixels) {
    const auto array = static_cast<std::size_t>(pixel.place.array);
    seconds[array] += pixel.cpu_s;
    paths[array] += pixel.paths;
  }
  for (std::size_t i = 0; i < arrays; ++i) {
    seconds[i] = paths[i] > 0.0 ? seconds[i] / paths[i] : std::numeric_limits<double>::quiet_NaN();
  }
  return seconds;
}

}  // namespace

Pilot run_pilot(const World& world, const RenderOptions& options, const PilotOptions& limits,
                Diagnostics& diagnostics) {
  RenderOptions few = options;
  few.sampling.replicates = pilot_replicates;
  few.sampling.samples_per_replicate = pilot_samples;
  few.goal = nullptr;
  few.time = nullptr;
  few.store = nullptr;
  few.progress = nullptr;
  Pilot pilot;
  const std::uint64_t seed = mix(options.seed, pilot_salt);
  const auto first = random_pixels(world, std::min(first_pixels, limits.most_pixels), seed);
  if (first.empty()) return pilot;
  look_at(world, few, first, diagnostics, pilot);
  std::set<PixelName> seen;
  for (const PixelPlace& place : first) seen.insert(name_of_pixel(place));
  const double left_s = limits.most_cpu_s - 2.0 * pilot.cpu_s - pilot.first_touch_s;
  const double path_s = std::max(pilot.cpu_s + 0.5 * pilot.first_touch_s, 1e-9) / pilot.paths;
  const double paths = left_s / path_s;  // that there is time for
  const double more = std::min(limits.most_pixels - static_cast<double>(first.size()),
                               paths / (pilot_replicates * pilot_samples));
  if (more >= 1.0) {
    // Rare bright paths are seen by many only: time that is left once there are pixels enough goes
    // there, and shows as well what stratified points gain over random ones.
    int& samples = few.sampling.samples_per_replicate;
    while (samples < most_pilot_samples && 2.0 * samples * pilot_replicates * more <= paths) {
      samples *= 2;
    }
    const auto rest = new_pixels(world, static_cast<int>(more), mix(seed, 1), seen);
    if (!rest.empty()) look_at(world, few, rest, diagnostics, pilot);
  }
  pilot.seconds_per_path = mean_seconds(pilot, world.camera.arrays.size());
  return pilot;
}

}  // namespace nadir::sim
