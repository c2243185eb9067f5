// What does a column of heat cost, and what are step and nodes worth?
//
// Without arguments: processor time a stage by number of nodes (Google Benchmark; a step has two
// stages), with a cheap flux (radiation and a fixed film) and with one that has natural convection
// and evaporation.
// With --table: CSV of error against step and nodes for a summer's day on asphalt over soil, in the
// open and where a shadow passes at noon, against a very fine reference.

#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <numbers>
#include <string_view>
#include <type_traits>
#include <vector>

#include "core/constants.hpp"
#include "thermal/conduction/column.hpp"

namespace nadir::bench {
namespace {

using thermal::Column;
using thermal::GridSettings;
using thermal::LayerStack;
using thermal::SurfaceFlux;

constexpr double day_s = 86400.0;
constexpr double sigma = si::stefan_boltzmann;

LayerStack road() {
  return {{{{0.75, 2110.0, 920.0}, 0.10, 0.0}, {{1.0, 1700.0, 1200.0}, 1.0, 0.0}},
          thermal::AdiabaticBack{}};
}

// ---- cost of a stage ----------------------------------------------------------------------------

/// Radiation and a fixed film.
struct CheapFlux {
  double load_w_m2 = 900.0;
  SurfaceFlux operator()(int stage, double t) const {
    const double absorbed = load_w_m2 + 20.0 * stage;
    const double t3 = t * t * t;
    return {absorbed - 0.95 * sigma * t3 * t - 12.0 * (t - 298.0), -0.95 * 4.0 * sigma * t3 - 12.0};
  }
};

/// With natural convection and evaporation (Magnus' formula): a root and an exponential more.
struct DearFlux {
  CheapFlux cheap;
  SurfaceFlux operator()(int stage, double t) const {
    SurfaceFlux flux = cheap(stage, t);
    const double warmer = t - 298.0, root = std::cbrt(std::abs(warmer));
    flux.w_m2 -= 1.5 * root * warmer;
    flux.per_k_w_m2_k -= 1.5 * 4.0 / 3.0 * root;
    const double from = t - 30.03;
    const double pressure = 6.112 * std::exp(17.62 * (t - 273.15) / from);
    flux.w_m2 -= 3.0 * (pressure - 12.0);
    flux.per_k_w_m2_k -= 3.0 * pressure * 17.62 * 243.12 / (from * from);
    return flux;
  }
};

/// A stack of about as many nodes as asked for.
GridSettings settings_for(std::size_t nodes) {
  GridSettings settings;
  for (double growth = 3.0; growth > 1.01; growth = 1.0 + 0.98 * (growth - 1.0)) {
    settings = {.first_fraction = (growth - 1.0) / 6.0, .growth = growth, .least_per_layer = 1};
    if (make_grid(road(), settings).nodes() >= nodes) break;
  }
  return settings;
}

/// Loads of a clear day, every ten minutes.
template <class Flux>
std::vector<Flux> day_of() {
  std::vector<Flux> loads(144);
  for (std::size_t i = 0; i < loads.size(); ++i) {
    const double angle = 2.0 * std::numbers::pi * static_cast<double>(i) / 144.0;
    const double load = 400.0 + std::max(0.0, -700.0 * std::cos(angle));
    if constexpr (std::is_same_v<Flux, CheapFlux>) {
      loads[i].load_w_m2 = load;
    } else {
      loads[i].cheap.load_w_m2 = load;
    }
  }
  return loads;
}

template <class Flux>
void stage(benchmark::State& state) {
  const auto asked = static_cast<std::size_t>(state.range(0));
  const LayerStack sheet{{{{45.0, 7800.0, 500.0}, 0.001, 0.0}}, thermal::AdiabaticBack{}};
  const Column column(asked == 1 ? sheet : road(), settings_for(asked), Seconds{600.0});
  std::vector<double> temperature(column.nodes(), 298.0);
  constexpr std::array<double, 2> no_room{};
  const std::vector<Flux> loads = day_of<Flux>();
  std::size_t step = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(column.advance(temperature, loads[step], no_room));
    step = (step + 1) % loads.size();
  }
  state.counters["nodes"] = static_cast<double>(column.nodes());
  state.counters["per_stage"] =  // a step has two
      benchmark::Counter(2.0 * static_cast<double>(state.iterations()),
                         benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}
BENCHMARK_TEMPLATE(stage, CheapFlux)->Arg(1)->Arg(5)->Arg(10)->Arg(20)->Arg(40)->Arg(80);
BENCHMARK_TEMPLATE(stage, DearFlux)->Arg(1)->Arg(5)->Arg(10)->Arg(20)->Arg(40)->Arg(80);

// ---- error against step and nodes ---------------------------------------------------------------

/// A clear summer's day at 35 degrees north, sun overhead at noon within 12 degrees, some wind.
struct Summer {
  bool shadow = false;

  [[nodiscard]] SurfaceFlux operator()(double time_s, double t) const {
    const double hour = std::fmod(time_s, day_s) / 3600.0;
    const double height = 0.30 + 0.68 * std::cos(2.0 * std::numbers::pi * (hour - 12.0) / 24.0);
    double sun = 0.0;
    if (height > 0.0) {
      const bool hidden = shadow && hour > 12.2 && hour < 13.4;
      const double direct = hidden ? 0.0 : 950.0 * std::exp(-0.12 / height) * height;
      sun = 0.88 * (direct + 90.0 * std::sqrt(height));
    }
    const double air = 298.0 - 7.0 * std::cos(2.0 * std::numbers::pi * (hour - 3.0) / 24.0);
    const double warmer = t - air, root = std::cbrt(std::abs(warmer)), t3 = t * t * t;
    return {sun + 0.95 * (345.0 - sigma * t3 * t) - (10.0 + 1.5 * root) * warmer,
            -0.95 * 4.0 * sigma * t3 - 10.0 - 1.5 * 4.0 / 3.0 * root};
  }
};

struct Run {
  std::vector<double> surface_k;  // at every full hour of the last day
  std::size_t nodes = 0;
  double cpu_us_per_day = 0.0;
};

Run run(const Summer& summer, const GridSettings& grid, double step_s) {
  constexpr int days = 4;
  const Column column(road(), grid, Seconds{step_s});
  std::vector<double> temperature(column.nodes(), 300.0);
  constexpr std::array<double, 2> no_room{};
  Run result;
  result.nodes = column.nodes();
  const int steps = static_cast<int>(std::lround(days * day_s / step_s));
  const int an_hour = static_cast<int>(std::lround(3600.0 / step_s));
  const std::clock_t begin = std::clock();
  for (int i = 0; i < steps; ++i) {
    const double time_s = i * step_s;
    column.advance(
        temperature,
        [&](int s, double t) {
          return summer(time_s + (s == 0 ? Column::gamma : 1.0) * step_s, t);
        },
        no_room);
    if ((i + 1) % an_hour == 0 && i + 1 > (days - 1) * 24 * an_hour) {
      result.surface_k.push_back(temperature[0]);
    }
  }
  result.cpu_us_per_day = 1e6 * static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC / days;
  return result;
}

/// Intervals that all shrink together: the default's 0.05 at 1.3.
GridSettings graded(double growth) {
  return {.first_fraction = (growth - 1.0) / 6.0, .growth = growth, .least_per_layer = 1};
}

void print_row(const char* scene, double step_s, double growth, const Run& row, const Run& truth) {
  double squares = 0.0, most = 0.0;
  for (std::size_t i = 0; i < truth.surface_k.size(); ++i) {
    const double error = row.surface_k[i] - truth.surface_k[i];
    squares += error * error;
    most = std::max(most, std::abs(error));
  }
  std::printf("%s,%g,%g,%zu,%.5f,%.5f,%.2f\n", scene, step_s, growth, row.nodes,
              std::sqrt(squares / static_cast<double>(truth.surface_k.size())), most,
              row.cpu_us_per_day);
}

void print_table() {
  std::printf("scene,step_s,growth,nodes,rms_k,max_k,cpu_us_per_day\n");
  for (const bool shadow : {false, true}) {
    const Summer summer{shadow};
    const char* scene = shadow ? "shadow" : "open";
    const Run truth = run(summer, graded(1.04), 5.0);
    for (const double growth : {1.04, 1.1, 1.2, 1.3, 1.5, 1.7, 2.0}) {
      for (const double step_s : {60.0, 120.0, 300.0, 600.0, 900.0, 1200.0, 1800.0, 3600.0}) {
        print_row(scene, step_s, growth, run(summer, graded(growth), step_s), truth);
      }
    }
  }
}

}  // namespace
}  // namespace nadir::bench

int main(int argc, char** argv) {
  if (argc == 2 && std::string_view{argv[1]} == "--table") {
    nadir::bench::print_table();
    return 0;
  }
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
}
