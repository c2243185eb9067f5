#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "thermal/conduction/column.hpp"
#include "thermal/conduction/temperature_range.hpp"
#include "thermal/surface/surface_balance.hpp"

// Private to this folder.

namespace nadir::thermal {

/// One column under given loads: a balance for each stage, two stages a step, and as many
/// temperatures of the room behind.
struct ColumnRun {
  const Column* column = nullptr;
  std::span<const BalanceAt> stages;
  std::span<const double> room_k;

  [[nodiscard]] std::size_t steps() const noexcept { return stages.size() / 2; }
  [[nodiscard]] ColumnRun first(std::size_t steps) const noexcept {
    return {column, stages.first(2 * steps), room_k.first(2 * steps)};
  }
  [[nodiscard]] ColumnRun after(std::size_t steps) const noexcept {
    return {column, stages.subspan(2 * steps), room_k.subspan(2 * steps)};
  }

  /// Takes the nodes' temperatures through all steps; seen(step, StepFlux) after each. Where hardly
  /// anything takes away what the sun or a source brings they stop at 2000 K, and the rest of the
  /// heat is lost; so at 2.7 K where more is taken out than comes.
  /// @return  steps after which a node was stopped
  template <class Seen>
  std::size_t march(std::span<double> temperature_k, const Seen& seen) const {
    std::size_t held = 0;
    for (std::size_t step = 0; step < steps(); ++step) {
      const BalanceAt* const at = stages.data() + 2 * step;
      const std::span<const double, 2> room{room_k.data() + 2 * step, 2};
      const StepFlux flux = column->advance(
          temperature_k, [at](int stage, double t) { return at[stage](t); }, room);
      if (!flux.within_range) {
        hold(temperature_k);
        ++held;
      }
      seen(step, flux);
    }
    return held;
  }
  std::size_t march(std::span<double> temperature_k) const {
    return march(temperature_k, [](std::size_t, const StepFlux&) {});
  }

 private:
  static void hold(std::span<double> temperature_k) noexcept {
    for (double& kelvin : temperature_k) {
      kelvin = std::clamp(kelvin, least_temperature.value, greatest_temperature.value);
    }
  }
};

/// How a day answers to the temperatures that it begins with, about one day: T_end = M T_begin + c.
///
/// The day repeats itself where T_end = T_begin. Newton's step towards that, from a day that was
/// not so, is (I - M)^-1 (T_end - T_begin). M depends on the loads only by the slope of radiation
/// and convection, so that one matrix serves all places of a material; the step's error is its
/// length times the relative difference of the slopes, and the next day shows what is left.
class DayMap {
 public:
  /// Measures M by a day for each node. Where nothing leaves the column, so that I - M cannot be
  /// inverted, or where it would magnify a difference more than a hundred thousand times, steps go
  /// from day to day.
  DayMap(const ColumnRun& day, std::span<const double> begin_k);

  /// Whether steps lead to the day that repeats, not just to the next day.
  [[nodiscard]] bool steps_far() const noexcept { return !inverse_.empty(); }
  /// Writes the step for what the day changed.
  void step(std::span<const double> change_k, std::span<double> result) const noexcept;

 private:
  std::size_t nodes_ = 0;
  std::vector<double> inverse_;  // of I - M, row after row; empty: unity
};

struct SpinUpLimits {
  double spin_up_k = 0.05;
  int most_days = 30;
};
struct SpinUp {
  int days = 0;
  bool repeats = false;
  /// The day that repeats has been seen: it ends where it begins to spin_up_k, and was held
  /// nowhere.
  bool ends_as_begun = false;
};
/// Takes Newton's step after a day that need not be the very one, such as one of long steps.
/// @param memory  2 nodes() values to work in
void approach(const ColumnRun& day, const DayMap& map, std::span<double> temperature_k,
              std::span<double> memory);
/// Brings the temperatures to the begin of a day that repeats itself. What a step leaves is told by
/// the shortening from the step before to it, after the first one by what a day's answer M is
/// wrong: it must be spin_up_k at most at every node. Where steps do not lead far, the day must end
/// as near to where it began.
/// @param memory  2 nodes() values to work in
SpinUp spin_up(const ColumnRun& day, const DayMap& map, const SpinUpLimits& limits,
               std::span<double> temperature_k, std::span<double> memory);

}  // namespace nadir::thermal
