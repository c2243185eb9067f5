#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "thermal/solve/day_map.hpp"
#include "thermal/solve/shared_stages.hpp"
#include "thermal/solve/side_load.hpp"

// Private to this folder.

namespace nadir::thermal {

/// Memory to solve a cell in. Grows with the first one; after that nothing is allocated.
struct CellMemory {
  Exposure exposure;
  std::array<SideLoad, 2> sides;  ///< the outward side, and of an open sheet the other one
  std::vector<BalanceAt> stages, long_stages;
  std::vector<double> temperature_k, days;
};

/// What all cells of a material share: its layers, cut into nodes, and how a level place of it
/// fares in the open and in the shade.
class MaterialHeat {
 public:
  MaterialHeat(const HeatModel& model, const HeatMaterial& material, const SharedStages& shared);

  [[nodiscard]] const SurfaceProperties& surface() const noexcept { return material_.surface; }
  [[nodiscard]] const Column& column() const noexcept { return column_; }
  /// Both sides of a sheet count that is open to the weather.
  [[nodiscard]] bool open() const noexcept { return open_; }
  /// The reference places' emission through the record.
  [[nodiscard]] const EmissionSeries& emission() const noexcept { return emission_; }

  /// The film at a tilt in a wind of 1 m/s, its forced part as a share of that on level ground.
  [[nodiscard]] Film relative_film(double place_up) const noexcept;
  /// That film at a stage.
  [[nodiscard]] Film film_at(std::size_t stage, const Film& relative) const noexcept {
    return {relative.forced_w_m2_k * forced_level_[stage], relative.natural_warm_w_m2_k43,
            relative.natural_cold_w_m2_k43};
  }

  /// Fills memory.stages and memory.long_stages from memory.sides.
  void balance_stages(const SharedStages& shared, CellMemory& memory) const;
  [[nodiscard]] ColumnRun run(const CellMemory& memory) const noexcept {
    return {&column_, memory.stages, room_k_};
  }
  /// Of the level places that others see, two of each material.
  struct References {
    int not_repeating = 0;  ///< at the limit of spin-up
    int held = 0;           ///< at a limit of temperature
  };
  [[nodiscard]] const References& references() const noexcept { return references_; }
  /// Fills memory.temperature_k with what the repeating first day of the record begins with.
  SpinUp find_begin(const HeatModel& model, const SharedStages& shared, CellMemory& memory) const;

 private:
  /// A level place in the sun or in the shade.
  struct Reference {
    std::vector<double> begin_k;  ///< of the repeating day
    double flux_w_m2 = 0.0;       ///< mean_flux() at common_k_
  };
  void load_reference(const HeatModel& model, const SharedStages& shared, bool lit,
                      CellMemory& memory) const;
  void solve_references(const HeatModel& model, const SharedStages& shared);
  void set_steady(const SharedStages& shared, CellMemory& memory) const;
  void balance_long_stages(const SharedStages& shared, CellMemory& memory) const;
  void guess_begin(const SharedStages& shared, CellMemory& memory) const;

  HeatMaterial material_;
  Column column_;
  std::optional<Column> long_column_;  // of the long steps; none if there are none
  bool open_ = false;
  std::vector<double> forced_level_;  // film of forced convection on level ground, by stage
  std::vector<double> room_k_;        // behind the back, by stage; not looked at without a room
  std::vector<double> long_forced_level_, long_room_k_;  // by stage of the long steps
  double common_k_ = 288.15;
  double flux_per_k_ = -10.0;  // of mean_flux() at common_k_
  Reference shaded_, lit_;
  References references_;
  std::optional<DayMap> day_map_;
  EmissionSeries emission_;
};

}  // namespace nadir::thermal
