// What does a ray cost against raw Embree on the same rays? README.md says how to read the rows.

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <functional>
#include <memory>

#include "bench_scene.hpp"
#include "core/error.hpp"
#include "radiometry/generic_solver.hpp"
#include "radiometry/path_solver.hpp"
#include "ray_tape.hpp"

namespace nadir::bench {
namespace {

constexpr int rounds = 25;  // the fastest counts: other programs can only slow a round down

/// Processor time of this thread, s: what other programs take does not count.
double thread_time_s() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double time_of_s(const std::function<void()>& work) {
  const double start = thread_time_s();
  work();
  return thread_time_s() - start;
}

/// What is timed, and the same rays for raw Embree.
struct Subject {
  std::function<void()> work;
  std::uint64_t rays = 0;  ///< that one run of `work` traces
  int lanes = 0;           ///< 0: no radiometry
  RayTape tape;
};
using SubjectPtr = std::shared_ptr<const Subject>;

/// Times subject and raw Embree in turn, so that both see the same caches, clock and neighbours.
void run(benchmark::State& state, const Subject& subject) {
  double fastest_s = 1e9, embree_s = 1e9;
  for ([[maybe_unused]] auto _ : state) {
    embree_s =
        std::min(embree_s, time_of_s([&] { benchmark::DoNotOptimize(subject.tape.replay()); }));
    const double taken_s = time_of_s(subject.work);
    fastest_s = std::min(fastest_s, taken_s);
    state.SetIterationTime(taken_s);
  }
  const auto rays = static_cast<double>(subject.rays);
  state.counters["rays"] = rays;
  state.counters["embree_calls"] = static_cast<double>(subject.tape.calls()) / rays;
  state.counters["rays_per_s"] = rays / fastest_s;
  state.counters["ns_per_ray"] = 1e9 * fastest_s / rays;
  state.counters["ratio_to_embree"] = fastest_s / embree_s;
  if (subject.lanes > 0) {
    state.counters["ns_per_ray_lane"] = 1e9 * fastest_s / rays / subject.lanes;
  }
}

void add_row(const std::string& name, SubjectPtr subject) {
  benchmark::RegisterBenchmark(name.c_str(),
                               [subject](benchmark::State& state) { run(state, *subject); })
      ->UseManualTime()
      ->Iterations(rounds)
      ->Unit(benchmark::kMillisecond);
}

/// Raw Embree and the geometry module on one kind of rays; `trace` asks Scene about one ray.
template <class Trace>
void add_rays(const std::string& name, const std::vector<geometry::Ray>& rays, Trace trace) {
  auto nadir = std::make_shared<Subject>();
  nadir->work = [&rays, trace] {
    std::uint64_t hits = 0;
    for (const geometry::Ray& ray : rays) hits += trace(ray) ? 1 : 0;
    benchmark::DoNotOptimize(hits);
  };
  nadir->rays = rays.size();
  {
    const Recording recording{nadir->tape};
    nadir->work();
  }
  auto embree = std::make_shared<Subject>();
  {
    const Recording recording{embree->tape};
    benchmark::DoNotOptimize(nadir->tape.replay());
  }
  embree->rays = embree->tape.rays();
  embree->work = [tape = &embree->tape] { benchmark::DoNotOptimize(tape->replay()); };
  add_row(name + "/embree", embree);
  add_row(name + "/geometry", nadir);
}

/// Every path of the scene from the aperture on, with all the rays that it starts.
template <class Solver>
void add_solver(const BenchScene& scene, const std::string& name, int lanes) {
  auto subject = std::make_shared<Subject>();
  auto lit = std::make_shared<const radiometry::LitScene>(lit_at(scene.world, lanes));
  const auto walk = [&scene, lit] {
    Solver solver{*lit};
    for (const PixelPath& path : scene.paths) {
      const auto hit = lit->intersect(path.ray, path.numbers);
      const auto radiance = solver.aperture_radiance(path.ray, hit, path.numbers.child(0));
      benchmark::DoNotOptimize(radiance[0]);
    }
    return solver.counters().rays();
  };
  {
    const Recording recording{subject->tape};
    subject->rays = walk();
  }
  subject->work = [walk] { walk(); };
  subject->lanes = lanes;
  add_row(scene.name + "/" + name + "/" + std::to_string(lanes) + "_lanes", subject);
}

void add_scene(const BenchScene& scene) {
  const geometry::Scene& surfaces = scene.world.scene.geometry;
  const auto first_hit = [&surfaces](const auto& ray) {
    return surfaces.intersect(ray).has_value();
  };
  const auto any_hit = [&surfaces](const auto& ray) { return surfaces.occluded(ray); };
  add_rays(scene.name + "/primary", scene.primary, first_hit);
  add_rays(scene.name + "/to_sun", scene.to_sun, any_hit);
  add_rays(scene.name + "/bounce", scene.bounces, first_hit);
  for (const int lanes : {8, 16, 64}) {
    add_solver<radiometry::GenericSolver>(scene, "generic", lanes);
    add_solver<radiometry::PathSolver>(scene, "path", lanes);
  }
}

int run_all(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  const std::filesystem::path root{NADIR_SOURCE_DIR};
  const BenchScene village = load_scene("village", root / "scenes/jacksboro/day.xml");
  const BenchScene bare = load_scene("terrain", root / "bench/data/terrain.xml");
  add_scene(village);
  add_scene(bare);
  benchmark::AddCustomContext("threads", "1; times are processor time of that thread");
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}

}  // namespace
}  // namespace nadir::bench

int main(int argc, char** argv) {
  try {
    return nadir::bench::run_all(argc, argv);
  } catch (const nadir::InputError& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
