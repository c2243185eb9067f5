// One temperature for each cell, whoever asks first.
#include <oneapi/tbb/global_control.h>

#include <algorithm>
#include <atomic>
#include <thread>
#include <vector>

#include "support/catch.hpp"
#include "thermal/heat_scene.hpp"
#include "thermal/solve/cell_store.hpp"
#include "thermal/solve/heat_solver.hpp"

namespace nadir::thermal {
namespace {

using namespace test;

/// Ground, a box on it, a sheet: facets that are one cell and facets that are cut.
geometry::Scene mixed_scene() {
  return scene_of({surface(ground(8.0), of_soil),
                   {geometry::Box{{-2, -2, 0}, {2, 2, 3}}, {of_soil}, geometry::always},
                   surface({{3, -3, 0.5}, {1, 0, 1}, {0, 1, 0}}, of_sheet)});
}
HeatModel mixed_model() {
  HeatModel model = model_of({14.0});
  model.settings.resolution_m = 2.5;
  model.settings.step_s = 1800.0;
  return model;
}
std::vector<geometry::Hit> mixed_hits(const geometry::Scene& scene) {
  std::vector<geometry::Hit> hits;
  for (int i = 0; i < 15; ++i) {
    for (int j = 0; j < 15; ++j) {
      hits.push_back(from_above(scene, -7.0 + i + 0.013 * j, -7.0 + j));
    }
    hits.push_back(looking(scene, {20.0, -7.0 + i, 6.0}, {0.0, 0.02 * i, 1.0}));
  }
  return hits;
}
std::vector<double> temperatures(const HeatSolver& solver, const std::vector<geometry::Hit>& hits) {
  std::vector<double> result;
  for (const auto& hit : hits) result.push_back(solver.at(hit).value);
  return result;
}

TEST_CASE("temperatures depend neither on threads nor on the order of asking",
          "[thermal][heat_solver]") {
  const auto scene = mixed_scene();
  const auto hits = mixed_hits(scene);
  const HeatSolver one{scene, mixed_model()};
  const std::vector<double> expected = temperatures(one, hits);
  const HeatCounters alone = one.counters();
  CHECK(alone.cells_ahead == 0);
  CHECK(alone.cells_on_demand > 50);
  CHECK(alone.cells_on_demand < hits.size());
  CHECK(*std::max_element(expected.begin(), expected.end()) >
        *std::min_element(expected.begin(), expected.end()) + 5.0);

  SECTION("ahead, in two threads") {
    oneapi::tbb::global_control two{oneapi::tbb::global_control::max_allowed_parallelism, 2};
    const HeatSolver solver{scene, mixed_model()};
    solver.solve_ahead(hits);
    solver.solve_ahead(hits);  // nothing is left to do
    CHECK(temperatures(solver, hits) == expected);
    const HeatCounters counters = solver.counters();
    CHECK(counters.cells_on_demand == 0);
    CHECK(counters.cells_ahead == alone.cells_on_demand);
    CHECK(counters.rays == alone.rays);
    CHECK(counters.steps == alone.steps);
    CHECK(counters.longest_spin_up_days == alone.longest_spin_up_days);
  }
  SECTION("on demand, from behind") {
    const HeatSolver solver{scene, mixed_model()};
    const std::vector<geometry::Hit> backwards{hits.rbegin(), hits.rend()};
    std::vector<double> found = temperatures(solver, backwards);
    std::reverse(found.begin(), found.end());
    CHECK(found == expected);
  }
  SECTION("four threads that ask for the same cells at once") {
    const HeatSolver solver{scene, mixed_model()};
    std::vector<std::vector<double>> found(4);
    std::vector<std::thread> threads;
    for (auto& one_found : found) {
      threads.emplace_back([&] { one_found = temperatures(solver, hits); });
    }
    for (auto& thread : threads) thread.join();
    for (const auto& one_found : found) CHECK(one_found == expected);
    CHECK(solver.counters().cells_on_demand == alone.cells_on_demand);
    CHECK(solver.counters().steps == alone.steps);
  }
  SECTION("another seed looks along other rays") {
    const HeatSolver solver{scene, mixed_model(), 2};
    CHECK(temperatures(solver, hits) != expected);
  }
}

TEST_CASE("materials without a heat balance are passed over ahead and refused when asked for",
          "[thermal][heat_solver]") {
  const auto scene = scene_of({surface(ground(8.0), of_wall)});
  const HeatSolver solver{scene, mixed_model()};
  const std::vector<geometry::Hit> hits{from_above(scene, 1.0, 2.0)};
  solver.solve_ahead(hits);
  CHECK(solver.counters().cells_ahead == 0);
  CHECK_THROWS_AS(solver.at(hits[0]), std::logic_error);
}

TEST_CASE("the store keeps sides and pieces apart", "[thermal][heat_solver]") {
  CellStore store{10'000};
  const CellGrid whole{1, 1, true}, pieces{70, 70, true};
  CHECK_FALSE(store.find(9'999, {0.2, 0.2}, false).has_value());
  CHECK(store.store({9'999, true, whole, 0}, 281.5F));
  CHECK_FALSE(store.store({9'999, true, whole, 0}, 281.5F));
  CHECK(store.find(9'999, {0.2, 0.2}, true) == 281.5F);
  CHECK_FALSE(store.find(9'999, {0.2, 0.2}, false).has_value());
  CHECK(store.store({9'999, false, whole, 0}, 1999.0F));
  CHECK(store.find(9'999, {0.6, 0.1}, false) == 1999.0F);
  CHECK(store.find(9'999, {0.6, 0.1}, true) == 281.5F);

  for (std::uint32_t cell = 0; cell < pieces.cells(); ++cell) {
    for (const bool back : {false, true}) {
      REQUIRE(store.store({5, back, pieces, cell}, 3.0F + static_cast<float>(2 * cell + back)));
    }
  }
  REQUIRE(store.grid(5).has_value());
  CHECK(store.grid(5)->cells() == pieces.cells());
  CHECK_FALSE(store.grid(6).has_value());
  for (std::uint32_t cell = 0; cell < pieces.cells(); ++cell) {
    const Vec2 uv = pieces.place_in(cell, {0.3, 0.3});
    REQUIRE(store.find(5, uv, false) == 3.0F + static_cast<float>(2 * cell));
    REQUIRE(store.find(5, uv, true) == 4.0F + static_cast<float>(2 * cell));
    REQUIRE(store.has({5, true, pieces, cell}));
  }
}

TEST_CASE("threads that fill a store at once see what each stored", "[thermal][heat_solver]") {
  CellStore store{100'000};
  const CellGrid pieces{9, 9, true};
  std::atomic<int> fresh{0};
  std::vector<std::thread> threads;
  for (std::uint64_t begin = 0; begin < 4; ++begin) {
    threads.emplace_back([&, begin] {
      for (std::uint64_t i = 0; i < 8000; ++i) {
        const std::uint64_t facet = (begin * 2000 + i) % 8000 * 12;
        const auto cell = static_cast<std::uint32_t>(i % 7);
        if (store.store({facet, false, pieces, cell}, 250.0F)) ++fresh;
      }
    });
  }
  for (auto& thread : threads) thread.join();
  // Each thread stores one piece of each facet: i differs by 2000 between threads, which is 5 mod 7
  CHECK(fresh == 4 * 8000);
}

}  // namespace
}  // namespace nadir::thermal
