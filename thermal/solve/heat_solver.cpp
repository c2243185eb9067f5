#include "thermal/solve/heat_solver.hpp"

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/enumerable_thread_specific.h>
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <tuple>

#include "core/error.hpp"
#include "thermal/solve/cell_store.hpp"
#include "thermal/solve/material_heat.hpp"
#include "thermal/solve/record_maker.hpp"

namespace nadir::thermal {
namespace {

struct CellKey {
  std::uint32_t material = 0;
  bool coarse = false;  ///< cut for rays between surfaces
  CellOfFacet cell;
  std::uint64_t draw = 0;  ///< of its rays: not of what it is but of how it is looked at

  [[nodiscard]] auto order() const noexcept {
    return std::make_tuple(cell.facet, material, coarse, cell.cell, cell.back);
  }
  friend bool operator<(const CellKey& a, const CellKey& b) noexcept {
    return a.order() < b.order();
  }
  friend bool operator==(const CellKey& a, const CellKey& b) noexcept {
    return a.order() == b.order();
  }
};

/// What it took to solve a cell.
struct CellCost {
  std::uint64_t rays = 0, steps = 0;
  SpinUp spin_up;
  bool held = false;
};

using Cells = oneapi::tbb::blocked_range<std::size_t>;

struct SolvedCell {
  CellKey key;
  float kelvin = 0.0F;
};

void raise_to(std::atomic<int>& most, int value) noexcept {
  int known = most.load(std::memory_order_relaxed);
  while (known < value && !most.compare_exchange_weak(known, value, std::memory_order_relaxed)) {
  }
}

}  // namespace

struct HeatSolver::Impl {
  struct SolvedMaterial {
    SolvedMaterial(const HeatModel& model, const HeatMaterial& material, const SharedStages& shared,
                   std::uint64_t facets)
        : heat{model, material, shared}, fine{facets}, coarse{facets} {}

    [[nodiscard]] CellStore& store(bool of_coarse) { return of_coarse ? coarse : fine; }

    MaterialHeat heat;
    CellStore fine, coarse;
    std::atomic<std::uint64_t> cells{0}, not_repeating{0}, held{0};
  };

  struct AtomicCounters {
    std::atomic<std::uint64_t> cells_ahead{0}, cells_on_demand{0}, rays{0}, steps{0};
    std::atomic<int> longest_spin_up_days{0};
  };

  Impl(geometry::Scene the_scene, HeatModel the_model, std::uint64_t the_seed);

  [[nodiscard]] SolvedMaterial& solved(std::uint32_t material) const;
  [[nodiscard]] CellKey key_of(const geometry::Hit& hit, bool coarse) const;
  /// Sun, sky and surroundings of a cell's side.
  std::uint64_t load_side(const CellKey& key, bool back, SideLoad& load, CellMemory& memory) const;
  /// Leaves in memory.temperature_k what the record begins with.
  CellCost begin(const CellKey& key, CellMemory& memory) const;
  /// Leaves there what it ends with.
  CellCost run(const CellKey& key, CellMemory& memory) const;
  float solve(const CellKey& key, bool ahead) const;
  /// Some of the fine cells that have a temperature, evenly in their order; to be looked at with
  /// other rays.
  [[nodiscard]] std::vector<SolvedCell> some_solved(std::size_t wanted) const;
  /// For a hit by way of another surface.
  float solve_coarse(const geometry::Hit& hit) const;

  geometry::Scene scene;
  HeatModel model;
  std::uint64_t seed;
  SharedStages shared;
  std::vector<std::unique_ptr<SolvedMaterial>> materials;  // null: not solved
  mutable oneapi::tbb::enumerable_thread_specific<CellMemory> memories;
  mutable AtomicCounters counters;
};

HeatSolver::Impl::Impl(geometry::Scene the_scene, HeatModel the_model, std::uint64_t the_seed)
    : scene{std::move(the_scene)}, model{std::move(the_model)}, seed{the_seed} {
  check(model);
  shared = make_shared_stages(model);
  for (const auto& material : model.materials) {
    materials.push_back(
        material ? std::make_unique<SolvedMaterial>(model, *material, shared, scene.facets())
                 : nullptr);
  }
  for (std::size_t i = 0; i < model.surroundings.size(); ++i) {
    const auto* own = std::get_if<OfItsHeatBalance>(&model.surroundings[i].temperature);
    if (own == nullptr) continue;
    const std::size_t whose = own->whose.value_or(static_cast<std::uint32_t>(i));
    shared.surroundings[i] = materials[whose]->heat.emission();
  }
}

HeatSolver::Impl::SolvedMaterial& HeatSolver::Impl::solved(std::uint32_t material) const {
  if (material >= materials.size() || !materials[material]) {
    throw std::logic_error{"material " + std::to_string(material) + " has no heat balance"};
  }
  return *materials[material];
}

CellKey HeatSolver::Impl::key_of(const geometry::Hit& hit, bool coarse) const {
  SolvedMaterial& material = solved(hit.material);
  CellKey key;
  key.material = hit.material;
  key.coarse = coarse;
  key.cell.facet = hit.facet;
  // Both sides of an open sheet are one cell, that of its outward side.
  key.cell.back = hit.back_face && !material.heat.open();
  const HeatSettings& settings = model.settings;
  const double length_m = settings.resolution_m * (coarse ? settings.indirect_factor : 1.0);
  const auto known = material.store(coarse).grid(hit.facet);
  key.cell.grid = known ? *known : cut(scene.facet_size(hit.facet), length_m);
  key.cell.cell = key.cell.grid.cell_at(hit.uv);
  return key;
}

std::uint64_t HeatSolver::Impl::load_side(const CellKey& key, bool back, SideLoad& load,
                                          CellMemory& memory) const {
  const SurfaceCell cell{&scene, key.cell.facet, back, key.cell.grid, key.cell.cell};
  const std::uint64_t rays = seed + key.draw * 0x9E3779B97F4A7C15ULL;
  expose(scene, cell, model.sun, model.settings.exposure, rays, memory.exposure);
  find_load(model, shared, memory.exposure, cell.place({0.5, 0.5}).normal.z, load);
  return memory.exposure.rays;
}

CellCost HeatSolver::Impl::begin(const CellKey& key, CellMemory& memory) const {
  const MaterialHeat& heat = solved(key.material).heat;
  CellCost cost;
  cost.rays = load_side(key, key.cell.back, memory.sides[0], memory);
  if (heat.open()) cost.rays += load_side(key, true, memory.sides[1], memory);
  heat.balance_stages(shared, memory);
  cost.spin_up = heat.find_begin(model, shared, memory);
  cost.steps = static_cast<std::uint64_t>(cost.spin_up.days) * shared.grid.day_steps +
               memory.long_stages.size() / 2;
  return cost;
}

CellCost HeatSolver::Impl::run(const CellKey& key, CellMemory& memory) const {
  CellCost cost = begin(key, memory);
  ColumnRun record = solved(key.material).heat.run(memory);
  // The record's first day is the one that repeats: known, to spin_up_k of which the days that
  // follow leave nothing.
  if (cost.spin_up.ends_as_begun && shared.grid.steps >= 2 * shared.grid.day_steps) {
    record = record.after(shared.grid.day_steps);
  }
  cost.held = record.march(memory.temperature_k) > 0;
  cost.steps += record.steps();
  return cost;
}

float HeatSolver::Impl::solve(const CellKey& key, bool ahead) const {
  SolvedMaterial& material = solved(key.material);
  CellMemory& memory = memories.local();
  const CellCost cost = run(key, memory);
  const auto kelvin = static_cast<float>(memory.temperature_k.front());
  if (!material.store(key.coarse).store(key.cell, kelvin)) return kelvin;  // another was quicker
  constexpr auto relaxed = std::memory_order_relaxed;
  (ahead ? counters.cells_ahead : counters.cells_on_demand).fetch_add(1, relaxed);
  counters.rays.fetch_add(cost.rays, relaxed);
  counters.steps.fetch_add(cost.steps, relaxed);
  material.cells.fetch_add(1, relaxed);
  if (!cost.spin_up.repeats) material.not_repeating.fetch_add(1, relaxed);
  if (cost.held) material.held.fetch_add(1, relaxed);
  raise_to(counters.longest_spin_up_days, cost.spin_up.days);
  return kelvin;
}

float HeatSolver::Impl::solve_coarse(const geometry::Hit& hit) const {
  const CellKey key = key_of(hit, true), direct = key_of(hit, false);
  if (direct.cell.grid.cells() > 1) return solve(key, false);
  // A facet that is one cell for all rays is solved once for all of them.
  SolvedMaterial& material = solved(hit.material);
  const auto known = material.fine.find(hit.facet, hit.uv, key.cell.back);
  const float kelvin = known ? *known : solve(direct, false);
  material.coarse.store(key.cell, kelvin);
  return kelvin;
}

std::vector<SolvedCell> HeatSolver::Impl::some_solved(std::size_t wanted) const {
  // Counted first: the order alone says which, so that neither threads nor who asked matter.
  std::size_t all = 0;
  for (const auto& material : materials) {
    if (material) material->fine.for_each([&all](const CellOfFacet&, float) { ++all; });
  }
  const std::size_t count = std::min(wanted, all);
  std::vector<SolvedCell> result;
  std::size_t number = 0;
  for (std::uint32_t i = 0; i < materials.size(); ++i) {
    if (!materials[i]) continue;
    materials[i]->fine.for_each([&](CellOfFacet cell, float kelvin) {
      // The n-th wanted is the first whose number is n all / count.
      if (result.size() == count || number++ < result.size() * all / count) return;
      if (cell.grid.cells() == 1) {
        cell.grid = cut(scene.facet_size(cell.facet), model.settings.resolution_m);
      }
      result.push_back({{i, false, cell, 1}, kelvin});
    });
  }
  return result;
}

HeatSolver::HeatSolver(geometry::Scene scene, HeatModel model, std::uint64_t seed)
    : impl_{std::make_unique<Impl>(std::move(scene), std::move(model), seed)} {}
HeatSolver::~HeatSolver() = default;

Kelvin HeatSolver::at(const geometry::Hit& hit) const {
  Impl::SolvedMaterial& material = impl_->solved(hit.material);
  const bool back = hit.back_face && !material.heat.open();
  if (const auto known = material.store(hit.indirect).find(hit.facet, hit.uv, back)) {
    return Kelvin{static_cast<double>(*known)};
  }
  const float kelvin =
      hit.indirect ? impl_->solve_coarse(hit) : impl_->solve(impl_->key_of(hit, false), false);
  return Kelvin{static_cast<double>(kelvin)};
}

void HeatSolver::solve_ahead(std::span<const geometry::Hit> hits) const {
  std::vector<CellKey> cells;
  for (const geometry::Hit& hit : hits) {
    if (hit.material >= impl_->materials.size() || !impl_->materials[hit.material]) continue;
    const CellKey key = impl_->key_of(hit, hit.indirect);
    if (!impl_->materials[hit.material]->store(key.coarse).has(key.cell)) cells.push_back(key);
  }
  std::sort(cells.begin(), cells.end());
  cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
  // Each cell depends on nothing but the scene: any order gives the same. Neighbours' rays meet the
  // same parts of it, so a thread gets several.
  constexpr std::size_t at_a_time = 16;
  oneapi::tbb::parallel_for(Cells{0, cells.size(), at_a_time}, [&](const Cells& range) {
    for (std::size_t i = range.begin(); i < range.end(); ++i) impl_->solve(cells[i], true);
  });
}

HeatRecord HeatSolver::record(const geometry::Hit& hit) const {
  const CellKey key = impl_->key_of(hit, false);
  const SharedStages& shared = impl_->shared;
  const MaterialHeat& heat = impl_->solved(hit.material).heat;
  CellMemory memory;
  HeatRecord record;
  record.place = hit.position;
  record.normal = hit.normal;
  record.spin_up_days = impl_->begin(key, memory).spin_up.days;
  const bool other = heat.open() && hit.back_face;
  const SideLoad& own = memory.sides[other ? 1 : 0];
  record.sky_fraction = own.sky_fraction.back();
  RecordMaker{heat, shared, memory, own}.fill(record);
  return record;
}

HeatCounters HeatSolver::counters() const {
  const Impl::AtomicCounters& now = impl_->counters;
  HeatCounters result{.cells_ahead = now.cells_ahead.load(),
                      .cells_on_demand = now.cells_on_demand.load(),
                      .rays = now.rays.load(),
                      .steps = now.steps.load(),
                      .longest_spin_up_days = now.longest_spin_up_days.load()};
  for (const auto& material : impl_->materials) {
    if (!material) continue;
    const MaterialHeat::References& references = material->heat.references();
    result.not_repeating += material->not_repeating.load();
    result.held += material->held.load();
    result.references_not_repeating += static_cast<std::uint64_t>(references.not_repeating);
    result.references_held += static_cast<std::uint64_t>(references.held);
  }
  return result;
}

HeatError HeatSolver::error(std::size_t cells) const {
  const std::vector<SolvedCell> chosen = impl_->some_solved(cells);
  std::vector<double> apart_k(chosen.size());
  oneapi::tbb::parallel_for(Cells{0, chosen.size(), 1}, [&](const Cells& range) {
    CellMemory& memory = impl_->memories.local();
    for (std::size_t i = range.begin(); i < range.end(); ++i) {
      impl_->run(chosen[i].key, memory);
      apart_k[i] = std::abs(memory.temperature_k.front() - static_cast<double>(chosen[i].kelvin));
    }
  });
  HeatError result;
  result.cells = chosen.size();
  if (chosen.empty()) return result;
  double squares = 0.0;
  for (const double k : apart_k) squares += k * k;
  result.rms_k = std::sqrt(0.5 * squares / static_cast<double>(chosen.size()));
  result.largest_k = *std::max_element(apart_k.begin(), apart_k.end()) / std::numbers::sqrt2;
  return result;
}

std::vector<std::string> HeatSolver::cautions(const std::vector<std::string>& names) const {
  std::vector<std::string> result;
  const std::string after = std::to_string(impl_->model.settings.spin_up_days) + " days of spin-up";
  for (std::size_t i = 0; i < impl_->materials.size(); ++i) {
    if (!impl_->materials[i]) continue;
    const Impl::SolvedMaterial& material = *impl_->materials[i];
    const std::string name = "material " + (i < names.size() ? names[i] : std::to_string(i)) + ": ";
    const auto tell = [&](std::uint64_t some, std::uint64_t all, const std::string& what) {
      if (some == 0) return;
      result.push_back(name + std::to_string(some) + " of " + std::to_string(all) + what);
    };
    const MaterialHeat::References& references = material.heat.references();
    const std::string held =
        " reached 2.7 or 2000 K and were held there, the rest of their heat lost";
    const std::string not_repeating = " did not come to repeat their day within " + after;
    const auto cells = material.cells.load();
    tell(material.held.load(), cells, " solved cells" + held);
    tell(material.not_repeating.load(), cells, " solved cells" + not_repeating);
    constexpr const char* level = " level places, as others see it,";
    tell(static_cast<std::uint64_t>(references.held), 2, level + held);
    tell(static_cast<std::uint64_t>(references.not_repeating), 2, level + not_repeating);
  }
  return result;
}

const HeatModel& HeatSolver::model() const noexcept { return impl_->model; }

}  // namespace nadir::thermal
