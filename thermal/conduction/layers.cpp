#include "thermal/conduction/layers.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "core/error.hpp"
#include "thermal/conduction/temperature_range.hpp"

namespace nadir::thermal {
namespace {

void check_positive(double value, const std::string& what) {
  if (!(std::isfinite(value) && value > 0.0)) {
    throw InputError(what + " must be positive and finite, not " + std::to_string(value));
  }
}

void check_temperature(Kelvin temperature, const std::string& what) {
  if (!(temperature >= least_temperature && temperature <= greatest_temperature)) {
    throw InputError(what + " must be within 2.7 and 2000 K, not " +
                     std::to_string(temperature.value) + " K");
  }
}

void check_layer(const Layer& layer, std::size_t number) {
  const std::string of = " of layer " + std::to_string(number);
  check_positive(layer.substance.conductivity_w_m_k, "the conductivity" + of);
  check_positive(layer.substance.density_kg_m3, "the density" + of);
  check_positive(layer.substance.specific_heat_j_kg_k, "the specific heat" + of);
  check_positive(layer.thickness_m, "the thickness" + of);
  if (!std::isfinite(layer.heat_w_m2)) {
    throw InputError("the heat released" + of + " must be finite");
  }
}

double resistance_m2_k_w(const Layer& layer) {
  return layer.thickness_m / layer.substance.conductivity_w_m_k;
}

double resistance_m2_k_w(const LayerStack& stack) {
  double sum = 0.0;
  for (const Layer& layer : stack.layers) sum += resistance_m2_k_w(layer);
  return sum;
}

struct CheckBack {
  const LayerStack& stack;

  void operator()(const AdiabaticBack&) const {}
  void operator()(const FixedBack& back) const {
    check_temperature(back.temperature, "the temperature of the back");
  }
  void operator()(const RoomBack& back) const {
    check_positive(back.film_w_m2_k, "the film coefficient of the room");
    if (back.temperature) check_temperature(*back.temperature, "the temperature of the room");
    if (!std::isfinite(back.offset_k)) {
      throw InputError("the offset of the room from the air must be finite");
    }
  }
  void operator()(const OpenBack&) const {
    // Biot number of a plate with both faces in the air: of half its thickness (Incropera, section
    // 5.2: below 0.1 it has one temperature to some 5 %), at a brisk 25 W m^-2 K^-1.
    constexpr double film_w_m2_k = 25.0, biot_limit = 0.1;
    const double biot = 0.5 * film_w_m2_k * resistance_m2_k_w(stack);
    if (biot > biot_limit) {
      throw InputError(
          "an open back needs a sheet thin enough to have one temperature: thickness / "
          "conductivity is " +
          std::to_string(2.0 * biot / film_w_m2_k) + " m2 K/W, at most " +
          std::to_string(2.0 * biot_limit / film_w_m2_k));
    }
  }
};

/// Resistance between the deepest face and what lies behind it; none: nothing passes.
struct ResistanceBehind {
  std::optional<double> operator()(const AdiabaticBack&) const { return std::nullopt; }
  std::optional<double> operator()(const FixedBack&) const { return 0.0; }
  std::optional<double> operator()(const RoomBack& back) const { return 1.0 / back.film_w_m2_k; }
  std::optional<double> operator()(const OpenBack&) const { return std::nullopt; }
};

}  // namespace

void check(const LayerStack& stack) {
  if (stack.layers.empty()) throw InputError("a stack needs at least one layer");
  for (std::size_t i = 0; i < stack.layers.size(); ++i) check_layer(stack.layers[i], i + 1);
  std::visit(CheckBack{stack}, stack.back);
}

Metres damping_depth(const Substance& substance, Seconds period) {
  const double omega = 2.0 * std::numbers::pi / period.value;
  return Metres{std::sqrt(2.0 * substance.diffusivity_m2_s() / omega)};
}

Seconds memory_of(const LayerStack& stack, double film_w_m2_k) {
  const bool open = std::holds_alternative<OpenBack>(stack.back);
  const double outside = 1.0 / (open ? 2.0 * film_w_m2_k : film_w_m2_k);
  const std::optional<double> behind = std::visit(ResistanceBehind{}, stack.back);
  const double across = resistance_m2_k_w(stack);
  double above = 0.0, discharge_s = 0.0, root_diffusion = 0.0;
  for (const Layer& layer : stack.layers) {
    const double own = resistance_m2_k_w(layer);
    const double heat = layer.substance.heat_capacity_j_m3_k() * layer.thickness_m;
    const double up = outside + above + 0.5 * own;
    const double down = behind ? across - above - 0.5 * own + *behind : 0.0;
    discharge_s += heat * (behind ? up * down / (up + down) : up);
    root_diffusion += layer.thickness_m / std::sqrt(layer.substance.diffusivity_m2_s());
    above += own;
  }
  return Seconds{std::max(discharge_s, root_diffusion * root_diffusion)};
}

}  // namespace nadir::thermal
