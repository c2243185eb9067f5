#pragma once

#include <optional>
#include <variant>
#include <vector>

#include "core/quantity.hpp"

namespace nadir::thermal {

/// What a layer is made of.
struct Substance {
  double conductivity_w_m_k = 1.0;
  double density_kg_m3 = 1000.0;
  double specific_heat_j_kg_k = 1000.0;

  [[nodiscard]] double heat_capacity_j_m3_k() const noexcept {
    return density_kg_m3 * specific_heat_j_kg_k;
  }
  [[nodiscard]] double diffusivity_m2_s() const noexcept {
    return conductivity_w_m_k / heat_capacity_j_m3_k();
  }
};

struct Layer {
  Substance substance;
  double thickness_m = 0.1;
  double heat_w_m2 = 0.0;  ///< released evenly within the layer, per area of surface; below 0:
                           ///< taken out, as by the pipes of a rink
};

/// Nothing passes.
struct AdiabaticBack {};
/// Deep soil, a cooled plate.
struct FixedBack {
  Kelvin temperature;
};
/// A room, through a film of still air: flux = film (T_room - T_back).
struct RoomBack {
  std::optional<Kelvin> temperature;  ///< none: that of the outdoor air,
  double offset_k = 0.0;              ///< plus this
  double film_w_m2_k = 8.3;  ///< convection and radiation; ASHRAE HOF 2005 ch. 25: still air, wall
};
/// A sheet with weather on both sides: leaves, signs, car bodies. All of it has one temperature.
struct OpenBack {};
using Back = std::variant<AdiabaticBack, FixedBack, RoomBack, OpenBack>;

/// What lies beneath a surface, from the surface inwards.
struct LayerStack {
  std::vector<Layer> layers;  ///< at least one
  Back back = AdiabaticBack{};
};

/// @throws InputError for no layer; for sizes and figures that are not positive and finite, heat
///         that is not finite, temperatures of the back outside [2.7, 2000] K; for an open back of
///         a stack too thick to have one temperature: Biot number of half its thickness above 0.1
///         at 25 W/m2/K
void check(const LayerStack& stack);

/// Depth at which a periodic wave has fallen to 1/e: sqrt(2 k / (rho c omega)).
/// Source: H. S. Carslaw and J. C. Jaeger, Conduction of Heat in Solids (2nd ed. 1959),
/// section 2.6.
[[nodiscard]] Metres damping_depth(const Substance& substance, Seconds period);

/// How long the stack remembers: the larger of two times.
///
/// Diffusion through all layers, (sum of L / sqrt(alpha))^2: L^2 / alpha of a single one, after
/// which the slowest wave of a slab with a closed back has fallen to exp(-pi^2 / 4) = 8 %.
///
/// Discharge, sum over layers of C_j R_j, R_j the resistance between the layer's middle and the
/// outside: through the layers above it and the surface's film 1 / film, with the way through the
/// back beside it where the back has a temperature of its own. Of a ladder of capacities and
/// resistances this is the sum of all its time constants (the trace of the inverse of its matrix),
/// so that the slowest is no longer; of a single thin layer it is C / film.
/// @param film_w_m2_k  convection and linearised radiation of the surface; both sides of a sheet
///                     with an open back have it
[[nodiscard]] Seconds memory_of(const LayerStack& stack, double film_w_m2_k = 15.0);

}  // namespace nadir::thermal
