#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "geometry/scene.hpp"
#include "thermal/solve/heat_model.hpp"

namespace nadir::thermal {

/// What solving has cost so far.
struct HeatCounters {
  std::uint64_t cells_ahead = 0;      ///< solved before the picture, in a batch
  std::uint64_t cells_on_demand = 0;  ///< solved when a ray first needed one
  std::uint64_t rays = 0;
  std::uint64_t steps = 0;          ///< spin-up included
  int longest_spin_up_days = 0;     ///< the first one, of long steps, not counted
  std::uint64_t not_repeating = 0;  ///< cells whose spin-up ended at its limit
  std::uint64_t held = 0;  ///< cells of which a node was stopped at 2.7 or 2000 K in the record
  std::uint64_t references_not_repeating = 0;  ///< level places, two a material, likewise
  std::uint64_t references_held = 0;
};

/// What the rays of a cell leave undecided of its temperature: that of the same cell, solved with
/// other rays, differs by sqrt(2) of it.
struct HeatError {
  double rms_k = 0.0, largest_k = 0.0;  ///< statistical error of a cell: difference / sqrt(2)
  std::size_t cells = 0;                ///< that were compared; with none the rest says nothing
};

/// The heat balance of one cell through time.
struct HeatRecord {
  struct Row {
    double time_s = 0.0;
    double surface_k = 0.0, back_k = 0.0;
    BalanceTerms terms;       ///< at the end of the step
    double conducted = 0.0;   ///< into the layers, W m^-2: the terms' sum but for the step's length
    double sun_cosine = 0.0;  ///< shadow counted
    WeatherState weather;
  };
  std::vector<Row> rows;  ///< one a step of the history
  double sky_fraction = 1.0;
  Vec3 place, normal;
  double spin_up_days = 0.0;
  double stored_j_m2 = 0.0;    ///< heat gained by the layers over the history
  double received_j_m2 = 0.0;  ///< through surface and back, and released within: the same
};

/// Temperatures of a scene's surfaces from their heat balance: each cell is solved when it is first
/// asked for, once, from any thread. The result does not depend on who asks first.
class HeatSolver {
 public:
  /// Solves the level open and shaded places of each material, which others see.
  /// @throws InputError whatever check(model) refuses
  HeatSolver(geometry::Scene scene, HeatModel model, std::uint64_t seed = 1);
  ~HeatSolver();

  /// Surface temperature at a hit whose material (maps resolved) has a heat balance. Rays between
  /// surfaces (Hit::indirect) go everywhere and blur what they meet: for them facets are cut into
  /// cells that are indirect_factor times longer.
  [[nodiscard]] Kelvin at(const geometry::Hit& hit) const;
  /// Solves the cells of these hits in parallel (oneTBB). Hits of other materials are passed over.
  void solve_ahead(std::span<const geometry::Hit> hits) const;
  /// The whole history of the cell at a hit.
  [[nodiscard]] HeatRecord record(const geometry::Hit& hit) const;
  [[nodiscard]] HeatCounters counters() const;
  /// Solves some cells again with other rays, in parallel, and compares. Of the cells that rays
  /// asked for directly so far, `cells` are taken, evenly in the order of materials and facets (all
  /// if there are fewer). Nothing that has been solved changes; counters do not count this.
  [[nodiscard]] HeatError error(std::size_t cells) const;
  /// What of the temperatures is not what the model asks for, in words, with the material's name
  /// (or index) and counts, in the order of materials: cells and level places that were held at a
  /// limit of temperature, and those that do not repeat themselves at the end of spin-up.
  /// @param names  of the materials, by index; empty: their indices are told
  [[nodiscard]] std::vector<std::string> cautions(const std::vector<std::string>& names = {}) const;
  [[nodiscard]] const HeatModel& model() const noexcept;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace nadir::thermal
