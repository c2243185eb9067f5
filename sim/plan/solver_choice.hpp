#pragma once

#include <string>

#include "materials/solver_settings.hpp"
#include "radiometry/method.hpp"
#include "sim/plan/effect_plan.hpp"
#include "sim/plan/scene_facts.hpp"

namespace nadir::sim {

/// The solver that a stated accuracy calls for, by the rules of docs/solver-settings.md.
struct SolverChoice {
  radiometry::Method method = radiometry::Method::path;
  int path_max_bounces = 0;
  materials::SolverSettings settings;  ///< of the generic solver
  std::string reason;                  ///< one or two sentences
};
[[nodiscard]] SolverChoice choose_solver(const SceneFacts& facts, const EffectPlan& effects);

/// Systematic errors that sampling does not show, of one band, relative to max(radiance, floor);
/// each an upper bound or the largest error known.
struct BiasTerms {
  double dropped_effects = 0.0;
  double bounce_limit = 0.0;
  double thresholds = 0.0;
  double wavelengths = 0.0;  ///< the band's quadrature
  double air_table = 0.0;    ///< sky and paths, interpolated
  [[nodiscard]] double total() const noexcept {
    return dropped_effects + bounce_limit + thresholds + wavelengths + air_table;
  }
};
/// By array and band.
using BiasByBand = std::vector<std::vector<BiasTerms>>;

/// @param wavelength_error    of the wavelength plan, by band, relative
/// @param air_table_error     of the air's interpolation, relative to the air's own light
[[nodiscard]] BiasByBand bias_terms(const SceneFacts& facts, const EffectPlan& effects,
                                    const SolverChoice& solver, const ByBand& wavelength_error,
                                    double air_table_error);

}  // namespace nadir::sim
