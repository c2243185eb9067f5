// What does a look-up of the air cost a ray? A table of the size that the solver makes by default:
// 12 zenith angles on either side of the horizon, 13 azimuths, 10 shares of the way, the sun, and
// air, haze and the haze above it as kinds. Directions and ways at random; the table's values do
// not matter.

#include <benchmark/benchmark.h>

#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

#include "atmosphere/paths/path_measure.hpp"
#include "atmosphere/paths/spherical_path.hpp"
#include "atmosphere/table/bound_air_table.hpp"
#include "core/random.hpp"

namespace nadir::bench {
namespace {

using atmosphere::AirTable;

constexpr double height_m = 1500.0;

AirTable::View view(double at_m, bool below, std::vector<double> share, std::size_t lanes) {
  AirTable::View v;
  v.height_m = at_m;
  const double horizon = std::acos(atmosphere::horizon_mu(0.0, at_m));
  constexpr int nodes = 12;
  // closer towards the horizon
  for (int i = 0; i < nodes; ++i) {
    const double x = 1.0 - i / (nodes - 1.0);
    v.zenith_rad.push_back(horizon * (1.0 - x * x));
  }
  for (int i = 0; below && i < nodes; ++i) {
    const double x = i / (nodes - 1.0);
    v.zenith_rad.push_back(horizon + (std::numbers::pi - horizon) * x * x);
  }
  for (int i = 0; i < 13; ++i) v.azimuth_rad.push_back(std::numbers::pi * i / 12.0);
  v.share = std::move(share);
  const std::size_t values = v.places() * lanes;
  constexpr std::size_t kinds = 3;
  v.extinction.assign(values, 3e-5F);
  v.first.assign(kinds * values, 100.0F);
  v.smooth.assign(v.azimuth_rad.size() * values, 10.0F);
  v.even.assign(values, 1.0F);
  v.ground.assign(values, 0.1F);
  return v;
}

atmosphere::BoundAirTable air(int lanes) {
  AirTable table;
  const auto n = static_cast<std::size_t>(lanes);
  std::vector<Micrometres> wavelengths;
  for (int i = 0; i < lanes; ++i) {
    wavelengths.emplace_back(0.4 + 0.01 * i);
    table.lanes.push_back({wavelengths.back().value, {}, 1.0});
  }
  table.top_m = 100e3;
  const std::vector<float> one(n, 1.0F), half(n, 0.5F), tenth(n, 0.1F);
  table.bodies.push_back({"sun", 0.7, 2.0, one, half, half});
  table.kinds = 3;
  for (int i = 0; i <= 64; ++i) table.phase_grid.push_back(i / 64.0);
  table.phase.assign(3 * table.phase_grid.size() * n, 0.08F);
  std::vector<double> share;
  for (int i = 1; i <= 10; ++i) share.push_back(i / 10.0);
  table.sky = view(0.0, false, {1.0}, n);
  table.views.push_back(view(height_m, true, share, n));
  table.spherical_albedo = tenth;
  table.even_ground_irradiance = one;
  return {std::make_shared<const AirTable>(std::move(table)),
          {tenth, tenth},
          spectral::Lanes{std::move(wavelengths)}};
}

struct Ray {
  Vec3 direction;
  double length_m;
};

/// Directions of a hemisphere, `sign` up or down, and ways within it up to the ground.
std::vector<Ray> rays(double sign) {
  std::vector<Ray> found;
  Rng random{1};
  for (int i = 0; i < 1024; ++i) {
    const double mu = 0.02 + 0.98 * random.next(), phi = 2.0 * std::numbers::pi * random.next();
    const double s = std::sqrt(1.0 - mu * mu);
    found.push_back({{s * std::cos(phi), s * std::sin(phi), sign * mu},
                     (0.2 + 0.8 * random.next()) * height_m / mu});
  }
  return found;
}

void sky(benchmark::State& state) {
  const auto table = air(static_cast<int>(state.range(0)));
  const auto at = rays(1.0);
  std::size_t i = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(table.sky(at[i++ % at.size()].direction));
  }
}
BENCHMARK(sky)->Arg(16)->Arg(64)->Arg(128);

void path(benchmark::State& state) {
  const auto table = air(static_cast<int>(state.range(0)));
  const auto at = rays(-1.0);
  std::size_t i = 0;
  for (auto _ : state) {
    const Ray& ray = at[i++ % at.size()];
    benchmark::DoNotOptimize(table.path({0.0, 0.0, height_m}, ray.direction, ray.length_m));
  }
}
BENCHMARK(path)->Arg(16)->Arg(64)->Arg(128);

void beyond(benchmark::State& state) {
  const auto table = air(static_cast<int>(state.range(0)));
  const auto at = rays(-1.0);
  std::size_t i = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(table.beyond({0.0, 0.0, height_m}, at[i++ % at.size()].direction));
  }
}
BENCHMARK(beyond)->Arg(16)->Arg(64);

void measure(benchmark::State& state) {
  double length_m = 2000.0, sum = 0.0;
  for (auto _ : state) {
    length_m = length_m < 1e6 ? length_m * 1.01 : 2000.0;
    sum += atmosphere::air_measure_m(1500.0, 10.0, length_m);
  }
  benchmark::DoNotOptimize(sum);
}
BENCHMARK(measure);

}  // namespace
}  // namespace nadir::bench

BENCHMARK_MAIN();
