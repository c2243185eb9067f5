#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "thermal/conduction/temperature_range.hpp"

namespace nadir::thermal {

/// A flux and how it changes with the surface's temperature.
struct SurfaceFlux {
  double w_m2 = 0.0;          ///< into the surface
  double per_k_w_m2_k = 0.0;  ///< derivative, <= 0
};

/// What the column beneath a surface asks for at its temperature T: conductance (T - adiabatic_k).
struct SurfaceDemand {
  double conductance_w_m2_k = 0.0;  ///< > 0
  double adiabatic_k = 0.0;         ///< temperature without flux

  [[nodiscard]] double flux_w_m2(double temperature_k) const noexcept {
    return conductance_w_m2_k * (temperature_k - adiabatic_k);
  }
};

/// Where flux and demand meet.
struct SurfaceRoot {
  double temperature_k = 0.0;
  double per_k_w_m2_k = 0.0;  ///< of the flux where it was asked for last

  /// Where they would meet if the same flux, run on linearly, met another demand.
  [[nodiscard]] double guess(const SurfaceDemand& own, const SurfaceDemand& other) const noexcept {
    return (other.conductance_w_m2_k * other.adiabatic_k + own.flux_w_m2(temperature_k) -
            per_k_w_m2_k * temperature_k) /
           (other.conductance_w_m2_k - per_k_w_m2_k);
  }
};

/// The root between the lowest and the highest temperature that are still possible.
class RootBracket {
 public:
  /// @param excess  demand less flux at t; it grows with t at least by the conductance
  void narrow(double t, double excess, double per_conductance) noexcept {
    const double other = t - excess * per_conductance;  // the root is no farther
    low_ = std::max(low_, std::min(t, other));
    high_ = std::min(high_, std::max(t, other));
  }
  [[nodiscard]] bool holds(double t) const noexcept { return t >= low_ && t <= high_; }
  [[nodiscard]] double middle() const noexcept { return 0.5 * (low_ + high_); }

 private:
  double low_ = -std::numeric_limits<double>::infinity();
  double high_ = std::numeric_limits<double>::infinity();
};

/// Solves demand(T) = flux(T) for a flux that never grows with T: Newton's iteration, held in a
/// bracket that the conductance alone gives from the first value on, with bisection wherever the
/// excess does not fall to half (kinks, jumps, derivatives that are wrong).
///
/// The flux is asked for within [2.7, 2000] K only and counts as constant beyond.
///
/// Ends when the next move, the last one shortened as it shortened the one before, would be below
/// 1e-9 T. Being superlinear it is far shorter: 1e-12 T is left where the flux is smooth
/// (conduction_surface_root_test.cpp).
/// @param start_k  a guess
template <class Flux>
[[nodiscard]] SurfaceRoot surface_root(const SurfaceDemand& demand, double start_k,
                                       const Flux& flux) {
  constexpr double least = least_temperature.value, greatest = greatest_temperature.value;
  constexpr double resolution = 1e-9;
  constexpr int most_moves = 120;  // bisection of 2000 K to one unit in the last place takes 53
  const double per_conductance = 1.0 / demand.conductance_w_m2_k;
  RootBracket bracket;
  double t = std::clamp(start_k, least, greatest);
  double last_excess = std::numeric_limits<double>::infinity();
  double last_move = 0.0;  // none: the next one is not taken for shorter than it is
  SurfaceFlux at;
  for (int i = 0; i < most_moves; ++i) {
    at = flux(t);
    const double excess = demand.flux_w_m2(t) - at.w_m2;
    if ((t == least && excess > 0.0) || (t == greatest && excess < 0.0)) {
      return {demand.adiabatic_k + at.w_m2 * per_conductance, 0.0};
    }
    if (std::isnan(excess)) return {excess, 0.0};
    bracket.narrow(t, excess, per_conductance);
    double next = t - excess / (demand.conductance_w_m2_k - std::min(at.per_k_w_m2_k, 0.0));
    const double size = std::abs(excess);
    const bool astray = size > 0.5 * last_excess || !bracket.holds(next);
    if (astray) next = bracket.middle();
    next = std::clamp(next, least, greatest);
    const double move = std::abs(next - t);
    t = next;
    const bool shortens = !astray && move < last_move;
    const double ahead = shortens ? move * (move / last_move) : move;
    if (ahead <= resolution * t) break;
    last_move = astray ? 0.0 : move;
    last_excess = size;
  }
  return {t, at.per_k_w_m2_k};
}

}  // namespace nadir::thermal
