#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "sim/scenario/build_temperature.hpp"

namespace nadir::sim {
namespace {

constexpr std::array figure_names{"conductivity_w_m_k", "density_kg_m3", "specific_heat_j_kg_k"};

thermal::Roughness roughness_of(const CheckedElement& element) {
  // in the enumeration's order
  constexpr std::array names{"very_rough",    "rough",  "medium_rough",
                             "medium_smooth", "smooth", "very_smooth"};
  const auto text = element.find<std::string>("roughness");
  if (!text) return thermal::Tarp{}.roughness;
  const auto found = std::find(names.begin(), names.end(), *text);
  return static_cast<thermal::Roughness>(found - names.begin());
}

thermal::Convection convection_of(const BuildContext& context, const CheckedElement& element) {
  const auto kind = element.value<std::string>("convection");
  if (kind == "fixed") {
    keep_for(context, element, {"wind_factor"}, "convections that follow the wind, not for fixed");
    if (!element.gives("film_w_m2_k")) {
      context.mistake(element.where("convection"), "convection=\"fixed\" needs film_w_m2_k");
    }
  } else {
    keep_for(context, element, {"film_w_m2_k"}, "convection=\"fixed\"");
  }
  if (kind == "fixed" || kind == "mcadams") {
    keep_for(context, element, {"roughness"}, "convection=\"tarp\" and convection=\"simple\"");
  }
  if (kind == "fixed") return thermal::FixedFilm{element.number("film_w_m2_k")};
  if (kind == "mcadams") return thermal::McAdams{};
  if (kind == "simple") return thermal::SimpleByRoughness{roughness_of(element)};
  return thermal::Tarp{roughness_of(element)};
}

thermal::Back fixed_back(const BuildContext& context, const CheckedElement& element) {
  const auto kelvin = build_kelvin(context, element, "back_temperature");
  if (!gives_kelvin(element, "back_temperature")) {
    context.mistake(element.where("back"),
                    "back=\"fixed\" needs back_temperature_k or back_temperature_c");
  }
  return thermal::FixedBack{Kelvin{kelvin.value_or(0.0)}};
}

thermal::Back room_back(const BuildContext& context, const CheckedElement& element) {
  thermal::RoomBack room;
  if (const auto kelvin = build_kelvin(context, element, "room_temperature")) {
    room.temperature = Kelvin{*kelvin};
  }
  if (gives_kelvin(element, "room_temperature")) {
    keep_for(context, element, {"room_offset_k"}, "a room that follows the air outdoors");
  }
  room.offset_k = element.number("room_offset_k");
  room.film_w_m2_k = element.find<double>("room_film_w_m2_k").value_or(room.film_w_m2_k);
  return room;
}

thermal::Back back_of(const BuildContext& context, const CheckedElement& element) {
  const auto kind = element.value<std::string>("back");
  if (kind != "fixed") {
    keep_for(context, element, {"back_temperature_k", "back_temperature_c"}, "back=\"fixed\"");
  }
  if (kind != "room") {
    keep_for(context, element,
             {"room_temperature_k", "room_temperature_c", "room_offset_k", "room_film_w_m2_k"},
             "back=\"room\"");
  }
  if (kind == "fixed") return fixed_back(context, element);
  if (kind == "room") return room_back(context, element);
  if (kind == "open") return thermal::OpenBack{};
  return thermal::AdiabaticBack{};
}

/// Either a name of the table or all three figures.
void check_substance(const BuildContext& context, const CheckedElement& element) {
  std::vector<std::string> given, missing;
  for (const char* figure : figure_names)
    (element.gives(figure) ? given : missing).emplace_back(figure);
  if (element.gives("substance")) {
    keep_for(context, element, given, "a layer without substance, which brings its own");
  } else if (given.empty()) {
    context.mistake(element.offset, "<layer> says not what it is made of",
                    "write substance=\"...\", or conductivity_w_m_k, density_kg_m3 and "
                    "specific_heat_j_kg_k");
  } else if (!missing.empty()) {
    context.mistake(
        element.offset,
        fmt::format("<layer> lacks {}: give all three figures or a substance", missing.front()));
  }
}

LayerInput build_layer(const BuildContext& context, const CheckedElement& element) {
  check_substance(context, element);
  LayerInput layer;
  layer.substance = element.value<std::string>("substance");
  layer.layer.substance = {element.number(figure_names[0]), element.number(figure_names[1]),
                           element.number(figure_names[2])};
  layer.thickness_m = element.find<double>("thickness_m");
  layer.layer.thickness_m = layer.thickness_m.value_or(layer.layer.thickness_m);
  layer.layer.heat_w_m2 = element.number("heat_w_m2");
  layer.where = context.source.locate(element.offset);
  return layer;
}

void check_thickness(const BuildContext& context, const CheckedElement& balance) {
  const bool adiabatic = balance.value<std::string>("back") == "adiabatic";
  for (const CheckedElement& layer : balance.children) {
    if (layer.gives("thickness_m") || (adiabatic && &layer == &balance.children.back())) continue;
    context.mistake(layer.offset,
                    "<layer> lacks thickness_m: only the last one above an adiabatic back goes as "
                    "deep as a day's wave");
  }
}

}  // namespace

HeatBalanceInput build_heat_balance(const BuildContext& context, const CheckedElement& element) {
  HeatBalanceInput balance;
  balance.back = back_of(context, element);
  balance.solar_absorptance = element.find<double>("solar_absorptance");
  balance.emissivity = element.find<double>("emissivity");
  balance.convection = convection_of(context, element);
  balance.wind_factor = element.find<double>("wind_factor").value_or(balance.wind_factor);
  balance.wetness = element.number("wetness");
  balance.where = context.source.locate(element.offset);
  for (const CheckedElement& layer : element.children) {
    balance.layers.push_back(build_layer(context, layer));
  }
  check_thickness(context, element);
  return balance;
}

}  // namespace nadir::sim
