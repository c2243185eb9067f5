// What does one draw from many lamps cost, and how well does it stand for all of them? README.md
// says how to read the rows.

#include <benchmark/benchmark.h>

#include <cmath>
#include <vector>

#include "core/random.hpp"
#include "radiometry/lamps/bound_lamps.hpp"

namespace nadir::bench {
namespace {

constexpr double spacing_m = 30.0, height_m = 8.0;
const Vec3 up{0.0, 0.0, 1.0};

/// Street lamps on a square grid about the origin, `columns` wide; they shine down like cos.
std::vector<radiometry::Lamp> street_grid(int count, int columns) {
  std::vector<radiometry::Lamp> lamps;
  const int rows = count / columns;
  for (int i = 0; i < count; ++i) {
    const double x = i % columns - 0.5 * (columns - 1), y = i / columns - 0.5 * (rows - 1);
    lamps.push_back(
        {.form = radiometry::PointLamp{.position = {spacing_m * x, spacing_m * y, height_m},
                                       .shape = radiometry::CosinePower{1.0, 1.4}},
         .flux = spectral::Curve::constant(40.0)});
  }
  return lamps;
}

spectral::Lanes sixteen_lanes() {
  std::vector<Micrometres> wavelengths;
  for (int i = 0; i < 16; ++i) wavelengths.emplace_back(0.45 + 0.02 * i);
  return spectral::Lanes{std::move(wavelengths)};
}

/// Places on the ground between the lamps in the middle of the grid.
std::vector<Vec3> places(int count) {
  Rng rng{3};
  std::vector<Vec3> all;
  for (int i = 0; i < count; ++i) {
    const double x = rng.next(), y = rng.next();
    all.push_back({2.0 * spacing_m * (x - 0.5), spacing_m * (y - 0.5), 0.0});
  }
  return all;
}

double received(const std::optional<radiometry::LampSample>& s) {
  return s ? static_cast<double>(s->irradiance[0]) * std::max(0.0, dot(s->direction, up)) : 0.0;
}

/// Error of the mean of 16 draws with spread random numbers, relative, root mean square over
/// places.
double relative_rms_of_16(const radiometry::BoundLamps& lamps, std::uint32_t count) {
  constexpr int draws = 16, tries = 20;
  Rng rng{4};
  double sum = 0.0;
  const std::vector<Vec3> at = places(100);
  for (const Vec3& place : at) {
    double exact = 0.0;
    for (std::uint32_t i = 0; i < count; ++i) exact += received(lamps.sample_of(i, place, {}));
    for (int k = 0; k < tries; ++k) {
      double mean = 0.0;
      for (int j = 0; j < draws; ++j) {
        mean += received(lamps.sample(place, up, (j + rng.next()) / draws, {})) / draws;
      }
      sum += (mean / exact - 1.0) * (mean / exact - 1.0);
    }
  }
  return std::sqrt(sum / (tries * static_cast<double>(at.size())));
}

void draw_from_street(benchmark::State& state) {
  const auto count = static_cast<int>(state.range(0));
  const int columns = count >= 100 ? static_cast<int>(std::lround(std::sqrt(count))) : count / 2;
  const radiometry::BoundLamps lamps{street_grid(count, columns), sixteen_lanes()};
  const std::vector<Vec3> at = places(4096);
  Rng rng{5};
  std::vector<double> choices;
  for (std::size_t i = 0; i < at.size(); ++i) choices.push_back(rng.next());
  for ([[maybe_unused]] auto _ : state) {
    for (std::size_t i = 0; i < at.size(); ++i) {
      benchmark::DoNotOptimize(lamps.sample(at[i], up, choices[i], {}));
    }
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(at.size()));
  state.counters["ns_per_sample"] = benchmark::Counter(
      static_cast<double>(state.iterations()) * static_cast<double>(at.size()) * 1e-9,
      benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
  state.counters["relative_rms_of_16"] =
      relative_rms_of_16(lamps, static_cast<std::uint32_t>(count));
}
BENCHMARK(draw_from_street)->Arg(10)->Arg(100)->Arg(10000)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace nadir::bench

BENCHMARK_MAIN();
