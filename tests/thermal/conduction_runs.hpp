#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "thermal/conduction/column.hpp"

namespace nadir::thermal::test {

/// A column, its temperatures and the heat that it was given.
struct Run {
  Run(const LayerStack& stack, const GridSettings& grid, double step_s, double start_k)
      : column(stack, grid, Seconds{step_s}), temperature(column.nodes(), start_k) {
    for (const double heat : column.grid().heat_w_m2) released_w_m2 += heat;
  }

  /// One step; flux(time_s, T).
  template <class Flux>
  StepFlux advance(const Flux& flux, std::array<double, 2> back_k = {}) {
    const double step_s = column.step().value, from_s = time_s;
    const StepFlux done = column.advance(
        temperature,
        [&](int stage, double t) {
          return flux(from_s + (stage == 0 ? Column::gamma : 1.0) * step_s, t);
        },
        back_k);
    received_j_m2 += step_s * (done.surface_w_m2 + done.back_w_m2 + released_w_m2);
    exchanged_j_m2 +=
        step_s * (std::abs(done.surface_w_m2) + std::abs(done.back_w_m2) + released_w_m2);
    ++steps;
    time_s = static_cast<double>(steps) * step_s;
    return done;
  }
  template <class Flux>
  void advance_to(double end_s, const Flux& flux) {
    while (time_s < end_s - 1e-6 * column.step().value) advance(flux);
  }

  [[nodiscard]] double heat_j_m2() const { return column.heat_j_m2(temperature); }
  [[nodiscard]] double surface_k() const { return temperature.front(); }
  /// Of the node nearest to a depth.
  [[nodiscard]] std::size_t node_at(double depth_m) const {
    std::size_t nearest = 0;
    for (std::size_t i = 0; i < column.nodes(); ++i) {
      const auto off = [&](std::size_t node) {
        return std::abs(column.grid().depth_m[node] - depth_m);
      };
      if (off(i) < off(nearest)) nearest = i;
    }
    return nearest;
  }

  Column column;
  std::vector<double> temperature;
  double released_w_m2 = 0.0, received_j_m2 = 0.0;
  double exchanged_j_m2 = 0.0;  // without regard to sign
  double time_s = 0.0;
  long steps = 0;
};

/// Intervals that all shrink together as growth nears 1; 1.3 is the default.
inline GridSettings graded(double growth) {
  return {.first_fraction = (growth - 1.0) / 6.0, .growth = growth, .least_per_layer = 1};
}

/// A film to air of a given temperature.
struct FilmFlux {
  double film_w_m2_k = 10.0, air_k = 300.0;
  SurfaceFlux operator()(double /*time_s*/, double t) const {
    return {film_w_m2_k * (air_k - t), -film_w_m2_k};
  }
};

}  // namespace nadir::thermal::test
