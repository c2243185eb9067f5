#include <fmt/format.h>

#include "sim/scenario/build_context.hpp"

namespace nadir::sim {
namespace {

/// The materials of all libraries that the scenario lists, the first of a name counting.
struct Libraries {
  std::map<std::string, LibraryMaterial> by_name;
  std::vector<std::string> names;
  std::vector<std::filesystem::path> files;
  bool complete = true;  ///< false: one could not be read, so a missing name means nothing
  bool any = false;
};

Libraries read_libraries(const BuildContext& context, const CheckedElement& element) {
  Libraries libraries;
  for (const CheckedElement& child : element.children) {
    if (child.type->name != "library") continue;
    libraries.any = true;
    const auto file = child.find<std::filesystem::path>("file");
    std::error_code error;
    // A file that does not exist was told when the document was checked.
    const bool exists = file && std::filesystem::is_regular_file(*file, error);
    const std::size_t before = context.issues.count();
    const auto materials = exists ? read_library(*file, context.issues) : std::nullopt;
    libraries.complete &= materials && context.issues.count() == before;
    if (!materials) continue;
    libraries.files.push_back(*file);
    for (const LibraryMaterial& material : *materials) {
      if (libraries.by_name.emplace(material.name, material).second) {
        libraries.names.push_back(material.name);
      }
    }
  }
  return libraries;
}

/// Spectra of the library's material that the element asks for.
void take_from_library(const BuildContext& context, const CheckedElement& element,
                       const Libraries& libraries, MaterialInput& material) {
  const bool named = element.gives("from");
  const std::string wanted = named ? element.value<std::string>("from") : material.name;
  if (wanted.empty()) return;
  const auto found = libraries.by_name.find(wanted);
  if (found != libraries.by_name.end()) {
    material.reflectance = found->second.reflectance;
    material.emissivity = found->second.emissivity;
    if (material.description.empty()) material.description = found->second.description;
    return;
  }
  if (!libraries.complete) return;
  if (!libraries.any) {
    context.mistake(element.where("from"),
                    fmt::format("material \"{}\" has neither reflectance nor emissivity, and no "
                                "library is listed to take them from",
                                material.name),
                    "write <library file=\"library:materials.xml\"/> in <materials>");
    return;
  }
  context.mistake(element.where("from"),
                  fmt::format("no library has a material \"{}\"{}", wanted,
                              named ? "" : ", and it has neither reflectance nor emissivity here"),
                  suggestion(wanted, libraries.names));
}

MaterialInput build_material(const BuildContext& context, const CheckedElement& element,
                             const Libraries& libraries, const Scenario& scenario,
                             double default_temperature_k) {
  MaterialInput material{element.value<std::string>("name"),
                         element.value<std::string>("description"),
                         element.find<SpectralInput>("reflectance"),
                         element.find<SpectralInput>("emissivity"),
                         element.find<double>("temperature_k").value_or(default_temperature_k),
                         std::nullopt};
  if (const CheckedElement* solver = element.child("solver")) {
    material.solver = build_solver(*solver, scenario.solver);
  }
  const bool own = element.gives("reflectance") || element.gives("emissivity");
  if (own && element.gives("from")) {
    context.mistake(element.where("from"),
                    "give either from, or reflectance and emissivity, not both");
  } else if (!own) {
    take_from_library(context, element, libraries, material);
  }
  if (auto mistake = energy_mistake(material.reflectance, material.emissivity);
      own && !mistake.empty()) {
    context.mistake(element.where("emissivity"), std::move(mistake));
  }
  return material;
}

}  // namespace

MaterialNames build_materials(const BuildContext& context, const CheckedElement& element,
                              Scenario& scenario) {
  const Libraries libraries = read_libraries(context, element);
  const double default_temperature_k = element.number("default_temperature_k");
  MaterialNames names;
  names.set_library_names(libraries.names);
  scenario.libraries = libraries.files;
  std::vector<const CheckedElement*> declared;
  for (const CheckedElement& child : element.children) {
    if (child.type->name != "material") continue;
    declared.push_back(&child);
    names.add(child.value<std::string>("name"), child.offset);
    scenario.materials.push_back(
        build_material(context, child, libraries, scenario, default_temperature_k));
  }
  context.check_unique(declared, "material");
  return names;
}

}  // namespace nadir::sim
