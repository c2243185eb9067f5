#include "sim/scenario/material_library.hpp"

#include <fmt/format.h>

#include "sim/scenario/build_context.hpp"
#include "sim/scenario/check_document.hpp"

namespace nadir::sim {
namespace {

LibraryMaterial build(const BuildContext& context, const CheckedElement& element) {
  LibraryMaterial material{
      element.value<std::string>("name"), element.value<std::string>("description"),
      element.find<SpectralInput>("reflectance"), element.find<SpectralInput>("emissivity")};
  if (!element.gives("reflectance") && !element.gives("emissivity")) {
    context.mistake(
        element.offset,
        fmt::format("material \"{}\" has neither reflectance nor emissivity", material.name));
  }
  if (auto mistake = energy_mistake(material.reflectance, material.emissivity); !mistake.empty()) {
    context.mistake(element.where("emissivity"), std::move(mistake));
  }
  return material;
}

}  // namespace

std::string energy_mistake(const std::optional<SpectralInput>& reflectance,
                           const std::optional<SpectralInput>& emissivity) {
  if (!reflectance || !emissivity) return {};
  const double* rho = std::get_if<double>(&reflectance->source);
  const double* eps = std::get_if<double>(&emissivity->source);
  // 1e-9: decimals such as 0.1 + 0.9 are not exact in binary
  if (rho == nullptr || eps == nullptr || *rho + *eps <= 1.0 + 1e-9) return {};
  return fmt::format("reflectance {} and emissivity {} sum to more than 1", *rho, *eps);
}

std::optional<std::vector<LibraryMaterial>> read_library(const std::filesystem::path& file,
                                                         Issues& issues) {
  try {
    const SourceText source = read_source_text(file);
    const XmlElement xml = parse_xml(source);
    const CheckedElement root = check_document(xml, library_root, source, InputPaths{file}, issues);
    Diagnostics unused;  // a library has nothing to warn of
    const BuildContext context{source, issues, unused};
    std::vector<LibraryMaterial> materials;
    std::vector<const CheckedElement*> elements;
    for (const CheckedElement& element : root.children) {
      elements.push_back(&element);
      materials.push_back(build(context, element));
    }
    context.check_unique(elements, "material");
    return materials;
  } catch (const InputError& error) {
    issues.add(error);
    return std::nullopt;
  }
}

std::vector<LibraryMaterial> read_material_library(const std::filesystem::path& file) {
  Issues issues;
  auto materials = read_library(file, issues);
  issues.throw_if_any();
  return std::move(*materials);
}

}  // namespace nadir::sim
