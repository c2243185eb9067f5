#include "sim/scenario/material_library.hpp"

#include <fmt/format.h>

#include <map>

#include "sim/scenario/build_material.hpp"
#include "sim/scenario/build_temperature.hpp"
#include "sim/scenario/read_root.hpp"

namespace nadir::sim {
namespace {

MaterialInput build(const BuildContext& context, const CheckedElement& element) {
  MaterialInput material = build_material_data(context, element);
  if (const CheckedElement* balance = element.child("heat_balance")) {
    material.heat_balance = build_heat_balance(context, *balance);
  }
  if (!element.gives("reflectance") && !element.gives("emissivity") &&
      !brings_spectra(material.scattering)) {
    context.mistake(
        element.offset,
        fmt::format("material \"{}\" has neither reflectance nor emissivity", material.name));
  }
  return material;
}

/// Mixtures of a library mix materials of the same library.
void resolve(const BuildContext& context, const std::vector<const CheckedElement*>& elements,
             std::vector<MaterialInput>& materials) {
  std::map<std::string, std::size_t> numbers;
  std::vector<std::string> names;
  for (const MaterialInput& material : materials) {
    numbers.emplace(material.name, names.size());
    names.push_back(material.name);
  }
  const FindPart find = [&](const CheckedElement& part) -> std::optional<std::size_t> {
    const auto name = part.find<std::string>("material");
    if (!name) return std::nullopt;
    if (const auto found = numbers.find(*name); found != numbers.end()) return found->second;
    context.mistake(part.where("material"),
                    fmt::format("the library has no material \"{}\"", *name),
                    suggestion(*name, names));
    return std::nullopt;
  };
  resolve_mixtures(context, elements, find, materials);
}

}  // namespace

std::optional<std::vector<LibraryMaterial>> read_library(const std::filesystem::path& file,
                                                         Issues& issues) {
  return read_root(file, library_root, issues,
                   [](const BuildContext& context, const CheckedElement& root) {
                     std::vector<MaterialInput> materials;
                     std::vector<const CheckedElement*> elements;
                     for (const CheckedElement& element : root.children) {
                       elements.push_back(&element);
                       materials.push_back(build(context, element));
                     }
                     context.check_unique(elements, "material");
                     resolve(context, elements, materials);
                     return materials;
                   });
}

std::vector<LibraryMaterial> read_material_library(const std::filesystem::path& file) {
  Issues issues;
  auto materials = read_library(file, issues);
  issues.throw_if_any();
  return std::move(*materials);
}

}  // namespace nadir::sim
