#include "thermal/conduction/column.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/error.hpp"

namespace nadir::thermal {
namespace {

Seconds checked_step(Seconds step) {
  if (!(std::isfinite(step.value) && step.value > 0.0)) {
    throw InputError("the step of the heat balance must be positive and finite, not " +
                     std::to_string(step.value) + " s");
  }
  return step;
}

BackCoupling coupling_of(const Back& back) {
  BackCoupling coupling;
  if (const auto* room = std::get_if<RoomBack>(&back)) coupling.film_w_m2_k = room->film_w_m2_k;
  if (const auto* fixed = std::get_if<FixedBack>(&back)) {
    coupling.pinned_k = fixed->temperature.value;
  }
  return coupling;
}

std::optional<double> room_temperature_of(const Back& back) {
  const auto* room = std::get_if<RoomBack>(&back);
  if (room == nullptr) return 0.0;  // nothing couples to it, whatever the caller gives
  if (room->temperature) return room->temperature->value;
  return std::nullopt;
}

}  // namespace

Column::Column(const LayerStack& stack, const GridSettings& settings, Seconds step)
    : grid_(make_grid(stack, settings)),
      step_(checked_step(step)),
      back_(coupling_of(stack.back)),
      room_k_(room_temperature_of(stack.back)),
      stage_(grid_, back_, step * gamma),
      rest_(grid_, back_, step * (1.0 - gamma)) {}

void Column::extrapolate(const double* before, const NodeValues& after,
                         NodeValues& result) const noexcept {
  constexpr double reach = (1.0 - gamma) / gamma;
  const std::size_t count = nodes();
  for (std::size_t i = 0; i < count; ++i) result[i] = before[i] + reach * (after[i] - before[i]);
}

bool Column::within_range(const NodeValues& after) const noexcept {
  const std::size_t count = nodes();
  double least = after[0], greatest = after[0];
  for (std::size_t i = 1; i < count; ++i) {
    least = after[i] < least ? after[i] : least;
    greatest = after[i] > greatest ? after[i] : greatest;
  }
  return least >= least_temperature.value && greatest <= greatest_temperature.value;
}

void Column::keep(const NodeValues& after, std::span<double> result) const noexcept {
  std::copy_n(after.begin(), nodes(), result.begin());
}

double Column::back_flux(const NodeValues& after, double room_k) const noexcept {
  const std::size_t last = nodes() - 1;
  if (!back_.pinned_k) return back_.film_w_m2_k * (room_k - after[last]);
  return grid_.conductance_w_m2_k[last - 1] * (after[last] - after[last - 1]) -
         grid_.heat_w_m2[last];
}

double Column::heat_j_m2(std::span<const double> temperature_k) const noexcept {
  double heat = 0.0;
  for (std::size_t i = 0; i < nodes(); ++i) heat += grid_.capacity_j_m2_k[i] * temperature_k[i];
  return heat;
}

}  // namespace nadir::thermal
