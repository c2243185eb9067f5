#include "sim/scenario/build_temperature.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "core/constants.hpp"

namespace nadir::sim {
namespace {

/// An attribute or child of a material that says where its temperature comes from.
struct SourcePlace {
  std::size_t offset = 0;
  std::string name;
  const CheckedElement* child = nullptr;
};

/// In the order of the file.
std::vector<SourcePlace> sources_in(const CheckedElement& element) {
  std::vector<SourcePlace> found;
  for (const char* attribute : {"temperature_k", "temperature_c"}) {
    if (element.gives(attribute)) found.push_back({element.where(attribute), attribute});
  }
  if (element.flag("solve")) found.push_back({element.where("solve"), "solve"});
  for (const CheckedElement& child : element.children) {
    const std::string& kind = child.type->name;
    if (kind == "heat_balance" || kind.find("temperature") != std::string::npos) {
      found.push_back({child.offset, "<" + kind + ">", &child});
    }
  }
  std::sort(found.begin(), found.end(),
            [](const SourcePlace& a, const SourcePlace& b) { return a.offset < b.offset; });
  return found;
}

VertexTemperatureInput build_vertices(const BuildContext& context, const CheckedElement& element) {
  return {element.number("gain"), element.number("offset_k"),
          context.source.locate(element.offset)};
}

TemperatureInput build_child(const BuildContext& context, const CheckedElement& child) {
  const std::string& kind = child.type->name;
  if (kind == "heat_balance") return build_heat_balance(context, child);
  if (kind == "temperature_raster") return build_temperature_raster(context, child);
  if (kind == "vertex_temperature") return build_vertices(context, child);
  if (kind == "air_temperature") return AirTemperatureInput{child.number("offset_k")};
  return TemperatureTableInput{child.value<std::filesystem::path>("file"),
                               child.value<std::string>("column"),
                               context.source.locate(child.offset)};
}

bool takes_vertices(const MaterialInput& material) {
  return std::holds_alternative<VertexTemperatureInput>(material.temperature);
}

/// The materials that a map lays out.
std::vector<int> materials_of(const MaterialMapInput& map) {
  std::vector<int> all;
  if (const auto* choices = std::get_if<ChoicesInput>(&map.rule)) {
    for (const auto& choice : choices->choices) all.push_back(choice.material);
  } else if (const auto* fractions = std::get_if<FractionsInput>(&map.rule)) {
    for (const auto& share : fractions->fractions) all.push_back(share.material);
  } else if (const auto* contrast = std::get_if<ContrastInput>(&map.rule)) {
    all = contrast->materials;
  }
  return all;
}

}  // namespace

bool gives_kelvin(const CheckedElement& element, const std::string& name) {
  return element.gives(name + "_k") || element.gives(name + "_c");
}

std::size_t where_kelvin(const CheckedElement& element, const std::string& name) {
  return element.where(name + (element.gives(name + "_k") ? "_k" : "_c"));
}

std::optional<double> build_kelvin(const BuildContext& context, const CheckedElement& element,
                                   const std::string& name) {
  const std::string kelvin = name + "_k", celsius = name + "_c";
  if (element.gives(kelvin) && element.gives(celsius)) {
    context.mistake(std::max(element.where(kelvin), element.where(celsius)),
                    fmt::format("give either {} or {}, not both", kelvin, celsius));
  }
  if (const auto value = element.find<double>(kelvin)) return value;
  const auto value = element.find<double>(celsius);
  return value ? std::optional{*value + si::zero_celsius} : std::nullopt;
}

void keep_for(const BuildContext& context, const CheckedElement& element,
              const std::vector<std::string>& attributes, const std::string& purpose) {
  for (const std::string& attribute : attributes) {
    if (!element.gives(attribute)) continue;
    context.mistake(element.where(attribute), fmt::format("{} is for {}", attribute, purpose));
  }
}

MaterialTemperatures::MaterialTemperatures(const BuildContext& context,
                                           const CheckedElement& materials, bool has_heat)
    : context_{context},
      list_{materials},
      has_heat_{has_heat},
      default_k_{build_kelvin(context, materials, "default_temperature")} {}

void MaterialTemperatures::add(const CheckedElement& element, MadeFrom made_from,
                               MaterialInput& material) {
  const std::vector<SourcePlace> places = sources_in(element);
  if (default_k_) material.temperature = ConstantTemperatureInput{*default_k_};
  if (places.empty() && !default_k_) without_.push_back(material.name);
  // From the last to the first, which counts, so that all are checked.
  for (std::size_t i = places.size(); i-- > 0;) {
    const SourcePlace& place = places[i];
    if (i > 0) {
      context_.mistake(place.offset,
                       fmt::format("a material has one source of temperature; {} stands in line {} "
                                   "already",
                                   places[0].name, context_.source.locate(places[0].offset).line));
    }
    if (place.child != nullptr) {
      material.temperature = build_child(context_, *place.child);
    } else if (place.name == "solve") {
      material.temperature = solved(element, made_from, material);
    } else {
      const double zero = place.name.ends_with("_c") ? si::zero_celsius : 0.0;
      material.temperature = ConstantTemperatureInput{element.number(place.name) + zero};
    }
    check_weather(place.offset, material);
  }
}

TemperatureInput MaterialTemperatures::solved(const CheckedElement& element, MadeFrom made_from,
                                              const MaterialInput& material) const {
  if (material.heat_balance) return *material.heat_balance;
  if (made_from == MadeFrom::unknown) return ConstantTemperatureInput{};
  const std::string problem =
      made_from == MadeFrom::itself
          ? fmt::format(
                "solve asks for the heat balance of a library's material, but \"{}\" is not "
                "from a library",
                material.name)
          : fmt::format("the library's material \"{}\" has no heat balance",
                        element.find<std::string>("from").value_or(material.name));
  context_.mistake(element.where("solve"), problem,
                   "in place of solve put <heat_balance><layer substance=\"...\"/></heat_balance> "
                   "into it");
  return ConstantTemperatureInput{};
}

void MaterialTemperatures::check_weather(std::size_t where, const MaterialInput& material) {
  const bool balance = std::holds_alternative<HeatBalanceInput>(material.temperature);
  if (!balance && !std::holds_alternative<AirTemperatureInput>(material.temperature)) return;
  if (!has_heat_ && !needs_heat_) {  // once: it is the scenario that lacks something
    context_.mistake(
        where,
        fmt::format("material \"{}\" {}, which needs weather, but the scenario has no "
                    "<heat>",
                    material.name, balance ? "has a heat balance" : "is as warm as the air"),
        "the shortest is <heat><clear_sky/></heat> in <scenario>");
  }
  needs_heat_ = true;
}

void MaterialTemperatures::finish(const CheckedElement* heat) const {
  if (heat != nullptr && !needs_heat_) {
    context_.warn(heat->offset,
                  "no material has a heat balance or the air's temperature: <heat> "
                  "changes nothing");
  }
  if (without_.empty() || gives_kelvin(list_, "default_temperature")) return;
  context_.mistake(list_.offset,
                   fmt::format("<materials> has no default temperature, and {} no source of it: {}",
                               without_.size() == 1 ? "one material has" : "some materials have",
                               fmt::join(without_, ", ")),
                   "write default_temperature_k=\"288.15\" or default_temperature_c=\"15\"");
}

void refuse_vertices(const BuildContext& context, const CheckedElement& element, int material,
                     const Scenario& scenario) {
  const std::size_t index = static_cast<std::size_t>(material);
  const std::size_t count = scenario.materials.size();
  std::vector<int> candidates = {material};
  if (index >= count) {
    if (index - count >= scenario.maps.size()) return;
    candidates = materials_of(scenario.maps[index - count]);
  }
  for (const int candidate : candidates) {
    if (static_cast<std::size_t>(candidate) >= count) continue;  // after other mistakes
    const MaterialInput& known = scenario.materials[static_cast<std::size_t>(candidate)];
    if (!takes_vertices(known)) continue;
    context.mistake(element.where("material"),
                    fmt::format("material \"{}\" takes its temperatures from a mesh's vertices, "
                                "which <{}> does not have",
                                known.name, element.type->name),
                    "a <mesh> from a PLY file may have them");
    return;
  }
}

}  // namespace nadir::sim
