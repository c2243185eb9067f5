// What the heat balance of a million cells costs, and what its settings are worth.
//
//     heat_solve [--cells N] [--threads N]
//
// A hilly terrain of triangles, a cell each, with two hundred boxes that throw shadows; 48 hours of
// weather at steps of 10 minutes, a shadow ray at each of them, spin-up on top. Prints the time on
// the clock and of the processor, memory, and how much of it is rays.
//
//     heat_solve --table
//
// Error of the surface's temperature at the picture, over some hundred cells in sun, shade and
// former shade, with the processor's time a cell: a row a setting, one thing at a time. CSV; errors
// against a run in which this one setting is fine ("own") and against one in which all are ("all").
#include <oneapi/tbb/global_control.h>
#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

#include "core/random.hpp"
#include "geometry/scene_builder.hpp"
#include "thermal/solve/heat_solver.hpp"
#include "thermal/weather/clear_sky.hpp"

namespace {

using namespace nadir;
using namespace nadir::thermal;

constexpr double day_s = 86400.0;
constexpr double picture_hour = 15.0;  // of the sun
constexpr double quad_m = 2.0;
constexpr std::uint32_t soil = 0, roof = 1;

struct Timer {
  std::chrono::steady_clock::time_point clock = std::chrono::steady_clock::now();
  double processor = processor_s();

  static double processor_s() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    const auto seconds = [](const timeval& t) {
      return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
    };
    return seconds(usage.ru_utime) + seconds(usage.ru_stime);
  }
  [[nodiscard]] double wall() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - clock).count();
  }
  [[nodiscard]] double used() const { return processor_s() - processor; }
};

double peak_mb() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

// ---- scene --------------------------------------------------------------------------------------

double height(double x, double y) {
  return 12.0 * std::sin(x / 90.0) * std::cos(y / 70.0) + 3.0 * std::sin(x / 17.0 + y / 23.0);
}

geometry::TriangleMesh terrain(int quads) {
  geometry::TriangleMesh mesh;
  for (int j = 0; j <= quads; ++j) {
    for (int i = 0; i <= quads; ++i) {
      const double x = quad_m * (i - quads / 2), y = quad_m * (j - quads / 2);
      mesh.positions.push_back({x, y, height(x, y)});
    }
  }
  const auto at = [&](int i, int j) { return static_cast<std::uint32_t>(j * (quads + 1) + i); };
  for (int j = 0; j < quads; ++j) {
    for (int i = 0; i < quads; ++i) {
      mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  return mesh;
}

geometry::Scene make_scene(int quads, int boxes) {
  geometry::SceneBuilder builder;
  builder.add({terrain(quads), {soil}}, {}, 0);
  Rng rng{5};
  const double half = 0.5 * quad_m * quads;
  for (int i = 0; i < boxes; ++i) {
    const double x = half * (1.8 * rng.next() - 0.9), y = half * (1.8 * rng.next() - 0.9);
    const double size = 4.0 + 8.0 * rng.next(), top = height(x, y) + 5.0 + 20.0 * rng.next();
    const geometry::Box box{{x - size, y - size, height(x, y) - 10.0}, {x + size, y + size, top}};
    builder.add({box, {roof}}, {}, 1);
  }
  return builder.build();
}

// ---- sun, weather, materials --------------------------------------------------------------------

/// Latitude 45 degrees, declination 10 degrees.
Vec3 sun_at(double time_s) {
  const double angle = (picture_hour - 12.0 + time_s / 3600.0) * std::numbers::pi / 12.0;
  const double d = 10.0 * radians_per_degree, l = 45.0 * radians_per_degree;
  return {-std::cos(d) * std::sin(angle),
          std::cos(l) * std::sin(d) - std::sin(l) * std::cos(d) * std::cos(angle),
          std::sin(l) * std::sin(d) + std::cos(l) * std::cos(d) * std::cos(angle)};
}

SunTrack make_track(double interval_s, double days) {
  SunTrack track;
  const auto moments = static_cast<int>(std::lround(days * day_s / interval_s));
  for (int i = -moments; i <= 0; ++i) {
    track.time_s.push_back(i * interval_s);
    track.direction.push_back(sun_at(i * interval_s));
    track.epoch.push_back(geometry::at_the_picture);
  }
  return track;
}

Weather make_weather(double days) {
  ClearSkyLight light;
  for (int i = 0; i <= 40; ++i) {
    const double mu = i / 40.0;
    // A. B. Meinel, M. P. Meinel, "Applied Solar Energy" (1976): direct light by air mass
    const double mass = 1.0 / (mu + 0.02);
    light.cos_zenith.push_back(mu);
    light.direct_normal_w_m2.push_back(1361.0 * std::pow(0.7, std::pow(mass, 0.678)));
    light.diffuse_horizontal_w_m2.push_back(110.0 * std::sqrt(mu));
  }
  std::vector<SunMoment> sun;
  const auto moments = static_cast<int>(std::lround(days * 288.0));
  for (int i = -moments; i <= 0; ++i) sun.push_back({300.0 * i, sun_at(300.0 * i).z, 1.0});
  return clear_sky_weather({}, light, sun);
}

HeatModel make_model(double days) {
  HeatModel model;
  model.weather = make_weather(days);
  model.sun = make_track(600.0, days);
  HeatMaterial ground, cover;
  ground.layers.layers = {{{0.8, 1600.0, 1000.0}, 0.5, 0.0}};
  cover.layers.layers = {{{0.17, 1100.0, 1500.0}, 0.01, 0.0}, {{1.7, 2300.0, 900.0}, 0.2, 0.0}};
  cover.layers.back = RoomBack{Kelvin{294.0}, 0.0, 8.3};
  model.materials = {ground, cover};
  model.surroundings = {{0.2, 0.95, OfItsHeatBalance{}}, {0.3, 0.9, OfItsHeatBalance{}}};
  model.settings.history_s = days * day_s;
  model.settings.resolution_m = 100.0;  // a cell each
  return model;
}

// ---- a million cells ----------------------------------------------------------------------------

/// What rays alone take of a cell, from a hundredth of them.
double exposure_us(const geometry::Scene& scene, const HeatModel& model, std::uint64_t cells) {
  Exposure exposure;
  const std::uint64_t stride = 101;
  const Timer timer;
  double done = 0.0;
  for (std::uint64_t facet = 0; facet < cells; facet += stride) {
    const SurfaceCell cell{&scene, facet, false, {}, 0};
    expose(scene, cell, model.sun, model.settings.exposure, 1, exposure);
    done += 1.0;
  }
  return 1e6 * timer.used() / done;
}

void solve_many(std::uint64_t cells) {
  const auto quads = static_cast<int>(std::ceil(std::sqrt(0.5 * static_cast<double>(cells))));
  const Timer building;
  const geometry::Scene scene = make_scene(quads, 200);
  const HeatModel model = make_model(2.0);
  std::printf("scene: %llu facets, built in %.1f s; peak memory %.0f MB\n",
              static_cast<unsigned long long>(scene.facets()), building.wall(), peak_mb());
  const double rays_us = exposure_us(scene, model, cells);

  const HeatSolver solver{scene, model};
  std::vector<geometry::Hit> hits;
  constexpr std::size_t batch = 1U << 16;
  const Timer timer;
  for (std::uint64_t facet = 0; facet < cells; ++facet) {
    hits.push_back(scene.on_facet(facet, {1.0 / 3.0, 1.0 / 3.0}, false));
    if (hits.size() < batch && facet + 1 < cells) continue;
    solver.solve_ahead(hits);
    hits.clear();
  }
  const double wall = timer.wall(), used = timer.used();
  const HeatCounters counters = solver.counters();
  const auto n = static_cast<double>(counters.cells_ahead);
  std::printf("cells %.0f: %.1f s on the clock, %.1f s of the processor, peak memory %.0f MB\n", n,
              wall, used, peak_mb());
  std::printf(
      "a cell: %.1f us, of which %.1f us rays (%.0f, %.0f ns each) and %.1f us the balance "
      "(%.0f steps, %.0f ns each)\n",
      1e6 * used / n, rays_us, static_cast<double>(counters.rays) / n,
      1e3 * rays_us * n / static_cast<double>(counters.rays), 1e6 * used / n - rays_us,
      static_cast<double>(counters.steps) / n,
      1e3 * (1e6 * used / n - rays_us) * n / static_cast<double>(counters.steps));
  std::printf("longest spin-up %d days, %llu cells do not repeat\n", counters.longest_spin_up_days,
              static_cast<unsigned long long>(counters.not_repeating));
  for (const std::string& caution : solver.cautions()) std::printf("%s\n", caution.c_str());
  const Timer trying;
  const HeatError error = solver.error(64);
  std::printf("of %zu cells, along other rays: %.2f K rms, %.2f K at most, in %.3f s\n",
              error.cells, error.rms_k, error.largest_k, trying.wall());
  double sum = 0.0;
  const Timer looking;
  for (std::uint64_t facet = 0; facet < cells; facet += 7) {
    geometry::Hit hit;
    hit.facet = facet;
    hit.uv = {1.0 / 3.0, 1.0 / 3.0};
    sum += solver.at(hit).value;
  }
  const double asked = std::ceil(static_cast<double>(cells) / 7.0);
  std::printf("a look-up: %.1f ns; mean temperature %.3f K\n", 1e9 * looking.used() / asked,
              sum / asked);
}

// ---- accuracy against time ----------------------------------------------------------------------

using Change = std::function<void(HeatModel&, double)>;

/// A setting, what it is tried with, and what is fine.
struct Setting {
  const char* name;
  std::vector<double> values;
  double fine;
  Change change;
};

std::vector<Setting> all_settings() {
  return {
      {"step_s",
       {60, 300, 600, 900, 1800, 3600},
       60,
       [](HeatModel& m, double s) { m.settings.step_s = s; }},
      {"growth (first interval with it)",
       {1.1, 1.2, 1.3, 1.5, 2.0, 3.0},
       1.05,
       [](HeatModel& m, double growth) {
         m.settings.grid = {0.05 * (growth - 1.0) / 0.3, growth, 1};
       }},
      {"shadow_interval_s",
       {60, 300, 600, 900, 1800, 3600},
       30,
       [](HeatModel& m, double s) { m.sun = make_track(s, 1.0); }},
      {"sky_rays",
       {8, 16, 32, 64, 128, 256, 1024},
       4096,
       [](HeatModel& m, double n) { m.settings.exposure.sky_rays = static_cast<int>(n); }},
      {"surroundings",
       {0, 2, 4, 8, 16},
       64,
       [](HeatModel& m, double n) { m.settings.exposure.surroundings = static_cast<int>(n); }},
      {"spin_up_k",
       {0.5, 0.2, 0.05, 0.01},
       1e-4,
       [](HeatModel& m, double k) { m.settings.spin_up_k = k; }},
  };
}

HeatModel finest() {
  HeatModel model = make_model(1.0);
  model.sun = make_track(60.0, 1.0);
  model.settings.step_s = 60.0;
  model.settings.grid = {0.01, 1.06, 2};
  model.settings.spin_up_k = 1e-3;
  model.settings.exposure = {4096, 64, 600.0};
  return model;
}

struct Solved {
  std::vector<double> kelvin;
  double us = 0.0;
};
Solved solved(const geometry::Scene& scene, const HeatModel& model,
              const std::vector<geometry::Hit>& hits) {
  const HeatSolver solver{scene, model};
  Solved result;
  const Timer timer;
  for (const auto& hit : hits) result.kelvin.push_back(solver.at(hit).value);
  result.us = 1e6 * timer.used() / static_cast<double>(hits.size());
  return result;
}

/// Ground within reach of the boxes' shadows.
std::vector<geometry::Hit> sampled(const geometry::Scene& scene, int quads) {
  std::vector<geometry::Hit> hits;
  Rng rng{9};
  const auto half = 0.4 * quad_m * quads;
  while (hits.size() < 400) {
    const Vec3 from{half * (2.0 * rng.next() - 1.0), half * (2.0 * rng.next() - 1.0), 500.0};
    const auto hit = scene.intersect({from, {0.0, 0.0, -1.0}});
    if (hit && hit->material == soil) hits.push_back(*hit);
  }
  return hits;
}

struct Error {
  double rms = 0.0, median = 0.0, largest = 0.0;
};
Error error_of(const Solved& one, const Solved& truth) {
  std::vector<double> errors;
  double squares = 0.0;
  for (std::size_t i = 0; i < truth.kelvin.size(); ++i) {
    errors.push_back(std::abs(one.kelvin[i] - truth.kelvin[i]));
    squares += errors[i] * errors[i];
  }
  std::sort(errors.begin(), errors.end());
  return {std::sqrt(squares / static_cast<double>(errors.size())), errors[errors.size() / 2],
          errors.back()};
}

void print_table() {
  constexpr int quads = 100;
  const geometry::Scene scene = make_scene(quads, 25);
  const auto hits = sampled(scene, quads);
  const Solved truth = solved(scene, finest(), hits);
  std::printf(
      "setting,value,own_rms_k,own_largest_k,all_rms_k,all_median_k,all_largest_k,"
      "us_a_cell\n");
  for (const Setting& setting : all_settings()) {
    const auto with = [&](double value) {
      HeatModel model = make_model(1.0);
      model.sun = make_track(600.0, 1.0);
      setting.change(model, value);
      return solved(scene, model, hits);
    };
    const Solved fine = with(setting.fine);
    for (const double value : setting.values) {
      const Solved one = with(value);
      const Error own = error_of(one, fine), all = error_of(one, truth);
      std::printf("%s,%g,%.4f,%.4f,%.4f,%.4f,%.4f,%.1f\n", setting.name, value, own.rms,
                  own.largest, all.rms, all.median, all.largest, one.us);
    }
  }
  std::printf("everything fine,,,,0,0,0,%.1f\n", truth.us);
}

}  // namespace

int main(int argc, char** argv) {
  std::uint64_t cells = 1'000'000;
  int threads = 0;
  bool table = false;
  for (int i = 1; i < argc; ++i) {
    if (std::strcmp(argv[i], "--table") == 0) table = true;
    if (i + 1 < argc && std::strcmp(argv[i], "--cells") == 0)
      cells = std::strtoull(argv[i + 1], nullptr, 10);
    if (i + 1 < argc && std::strcmp(argv[i], "--threads") == 0) threads = std::atoi(argv[i + 1]);
  }
  using oneapi::tbb::global_control;
  const auto allowed = static_cast<std::size_t>(threads > 0 ? threads : 1024);
  const global_control control{global_control::max_allowed_parallelism, allowed};
  if (table) {
    print_table();
  } else {
    solve_many(cells);
  }
}
