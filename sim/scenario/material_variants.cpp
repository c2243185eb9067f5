#include "sim/scenario/material_variants.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "sim/scenario/build_temperature.hpp"

namespace nadir::sim {
namespace {

/// Which attributes say a temperature of the element's own, in the order of the file.
std::vector<std::string> own_sources(const CheckedElement& element) {
  std::vector<std::string> given;
  for (const char* attribute : {"temperature_k", "temperature_c", "temperature_of"}) {
    if (element.gives(attribute)) given.emplace_back(attribute);
  }
  std::sort(given.begin(), given.end(), [&](const std::string& a, const std::string& b) {
    return element.where(a) < element.where(b);
  });
  return given;
}

}  // namespace

MaterialVariants::MaterialVariants(const BuildContext& context, const CheckedElement& geometry,
                                   MaterialNames& names, Scenario& scenario)
    : context_{context}, names_{names}, scenario_{scenario} {
  add_below(geometry, nullptr);
  names_.set_material_count(scenario_.materials.size());
}

int MaterialVariants::resolve(const CheckedElement& element) {
  const int material = names_.resolve(context_, element);
  const auto found = index_.find(&element);
  return found == index_.end() ? material : found->second;
}

void MaterialVariants::add_below(const CheckedElement& element, const CheckedElement* mesh) {
  for (const CheckedElement& child : element.children) {
    const bool own = !own_sources(child).empty();
    const CheckedElement* said = own ? &child : mesh;
    if (own) sources_.emplace(&child, source_of(child));
    if (said != nullptr) add(child, *said);
    const bool passes_on = child.type->name == "mesh" && own;
    add_below(child, passes_on ? &child : nullptr);
  }
}

void MaterialVariants::add(const CheckedElement& element, const CheckedElement& said) {
  const auto name = element.find<std::string>("material");
  if (!name) return;
  if (names_.is_map(*name)) {
    const bool itself = &said == &element;
    context_.mistake(
        itself ? said.where(own_sources(said).front()) : element.where("material"),
        fmt::format("\"{}\" is a map, whose materials have temperatures of their own", *name));
    return;
  }
  const std::optional<int> material = names_.number_of(*name);
  const std::optional<Source>& source = sources_.at(&said);
  if (!material || !source || source->of == material) return;
  index_[&element] = variant(*material, *source);
}

std::optional<MaterialVariants::Source> MaterialVariants::source_of(const CheckedElement& element) {
  const std::vector<std::string> given = own_sources(element);
  for (std::size_t i = 1; i < given.size(); ++i) {
    context_.mistake(element.where(given[i]),
                     fmt::format("<{}> has one temperature of its own; {} gives it already",
                                 element.type->name, given[0]));
  }
  if (given.size() > 1) return std::nullopt;
  if (given[0] == "temperature_of") {
    const auto other = names_.resolve_material(context_, element, given[0]);
    return other ? std::optional{Source{other, 0.0}} : std::nullopt;
  }
  const auto kelvin = build_kelvin(context_, element, "temperature");
  return kelvin ? std::optional{Source{std::nullopt, *kelvin}} : std::nullopt;
}

int MaterialVariants::variant(int material, const Source& source) {
  const int next = static_cast<int>(scenario_.materials.size());
  const auto [found, is_new] = variants_.emplace(std::pair{material, source}, next);
  if (!is_new) return found->second;
  MaterialInput copy = scenario_.materials[static_cast<std::size_t>(material)];
  copy.variant_of = material;
  if (source.of) {
    const MaterialInput& other = scenario_.materials[static_cast<std::size_t>(*source.of)];
    copy.temperature = other.temperature;
    copy.name += "@" + other.name;
  } else {
    copy.temperature = ConstantTemperatureInput{source.kelvin};
    copy.name += fmt::format("@{:.9g} K", source.kelvin);
  }
  scenario_.materials.push_back(std::move(copy));
  return next;
}

}  // namespace nadir::sim
