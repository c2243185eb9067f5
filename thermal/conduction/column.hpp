#pragma once

#include <array>
#include <span>

#include "thermal/conduction/depth_grid.hpp"
#include "thermal/conduction/elimination.hpp"
#include "thermal/conduction/layers.hpp"
#include "thermal/conduction/surface_root.hpp"

namespace nadir::thermal {

/// What a step did: heat gained = step (surface_w_m2 + back_w_m2 + heat released), to rounding.
struct StepFlux {
  double surface_w_m2 = 0.0;  ///< mean into the surface during the step, as the scheme weighs it
  double back_w_m2 = 0.0;     ///< mean into the column through its back
  bool within_range = true;   ///< all nodes are, after it
};

/// Heat in a column of layers, one step of fixed length after the other: -k dT/dz = q(T, t) at the
/// surface, q any flux that does not grow with T.
///
/// Time: SDIRK2 (R. Alexander, SIAM J. Numer. Anal. 14, 1006, 1977, doi:10.1137/0714068), gamma =
/// 1 - 1/sqrt(2): second order, L-stable, both stages implicit with the same matrix, so that it is
/// factored once for a stack and a step. Depth: finite volumes about the nodes, second order. The
/// matrix is eliminated from the back upwards, which leaves one equation for the surface's
/// temperature, solved by a guarded Newton iteration. Where the second-order result leaves
/// [2.7, 2000] K the step is repeated as two of backward Euler, to gamma and on to 1, which obey
/// the maximum principle; what heat released or taken out within does beyond it is told.
class Column {
 public:
  /// @throws InputError for a step that is not positive, whatever make_grid refuses
  Column(const LayerStack& stack, const GridSettings& settings, Seconds step);

  static constexpr double gamma = 0.29289321881345254;  ///< 1 - 1/sqrt(2): stages end at gamma, 1

  [[nodiscard]] std::size_t nodes() const noexcept { return grid_.nodes(); }
  [[nodiscard]] const DepthGrid& grid() const noexcept { return grid_; }
  [[nodiscard]] Seconds step() const noexcept { return step_; }

  /// Takes the temperatures of the nodes (surface first) over one step. Allocates nothing.
  /// @param temperature_k  nodes() values, changed
  /// @param flux           flux(stage, T): SurfaceFlux into the surface at the end of stage 0
  ///                       (after gamma step) and of stage 1 (after the step). Asked for within
  ///                       [2.7, 2000] K only
  /// @param back_k         of a room that follows the air: its temperature (offset counted) at the
  ///                       two stages; not looked at for other backs
  template <class Flux>
  StepFlux advance(std::span<double> temperature_k, const Flux& flux,
                   std::span<const double, 2> back_k) const;

  /// Heat above 0 K, J m^-2.
  [[nodiscard]] double heat_j_m2(std::span<const double> temperature_k) const noexcept;

 private:
  /// An implicit stage that has been solved.
  struct Solved {
    SurfaceDemand demand;
    SurfaceRoot root;
    StepFlux flux;  ///< at its end
  };
  /// @param start  of the search for the surface's temperature: start(demand)
  template <class Start, class Flux>
  Solved solve(const Elimination& matrix, const double* before, double room_k, const Start& start,
               const Flux& flux, NodeValues& after) const;

  /// Temperatures that stage 1 starts from: before + (1 - gamma) / gamma (after - before).
  void extrapolate(const double* before, const NodeValues& after,
                   NodeValues& result) const noexcept;
  [[nodiscard]] bool within_range(const NodeValues& after) const noexcept;
  void keep(const NodeValues& after, std::span<double> result) const noexcept;
  [[nodiscard]] double back_flux(const NodeValues& after, double room_k) const noexcept;

  DepthGrid grid_;
  Seconds step_;
  BackCoupling back_;
  std::optional<double> room_k_;
  Elimination stage_;  // of gamma step
  Elimination rest_;   // of (1 - gamma) step, where backward Euler is called for
};

template <class Start, class Flux>
Column::Solved Column::solve(const Elimination& matrix, const double* before, double room_k,
                             const Start& start, const Flux& flux, NodeValues& after) const {
  NodeValues partial;
  Solved result;
  result.demand = {matrix.surface_conductance(), matrix.prepare(before, room_k, partial)};
  result.root = surface_root(result.demand, start(result.demand), flux);
  matrix.finish(partial, result.root.temperature_k, after);
  result.flux = {result.demand.flux_w_m2(result.root.temperature_k), back_flux(after, room_k)};
  return result;
}

template <class Flux>
StepFlux Column::advance(std::span<double> temperature_k, const Flux& flux,
                         std::span<const double, 2> back_k) const {
  const auto mean = [](const StepFlux& a, const StepFlux& b, double of_b) {
    return StepFlux{(1.0 - of_b) * a.surface_w_m2 + of_b * b.surface_w_m2,
                    (1.0 - of_b) * a.back_w_m2 + of_b * b.back_w_m2};
  };
  const auto flux_0 = [&flux](double t) { return flux(0, t); };
  const auto flux_1 = [&flux](double t) { return flux(1, t); };
  double* const before = temperature_k.data();
  const double room_0 = room_k_.value_or(back_k[0]), room_1 = room_k_.value_or(back_k[1]);

  NodeValues first, start, second;
  const Solved a = solve(
      stage_, before, room_0, [before](const SurfaceDemand&) { return before[0]; }, flux_0, first);
  extrapolate(before, first, start);
  const Solved b = solve(
      stage_, start.data(), room_1,
      [&a](const SurfaceDemand& demand) { return a.root.guess(a.demand, demand); }, flux_1, second);
  if (within_range(second)) {
    keep(second, temperature_k);
    return mean(a.flux, b.flux, gamma);
  }

  const Solved c = solve(
      rest_, first.data(), room_1,
      [&a](const SurfaceDemand& demand) { return a.root.guess(a.demand, demand); }, flux_1, second);
  keep(second, temperature_k);
  StepFlux flux_of_both = mean(a.flux, c.flux, 1.0 - gamma);
  flux_of_both.within_range = within_range(second);
  return flux_of_both;
}

}  // namespace nadir::thermal
