#include <fmt/format.h>

#include "sim/scenario/build_material.hpp"
#include "sim/scenario/build_temperature.hpp"

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

/// Whether the element gives what its material is made of, so that no library is needed.
bool stands_alone(const CheckedElement& element, const MaterialInput& material) {
  return element.gives("reflectance") || element.gives("emissivity") ||
         brings_spectra(material.scattering);
}

/// What the library says about the material and the element does not.
void complete_from(const MaterialInput& library, const CheckedElement& element,
                   MaterialInput& material) {
  const bool own_model = scattering_element(element) != nullptr;
  if (material.description.empty()) material.description = library.description;
  material.reflectance = library.reflectance;
  material.emissivity = library.emissivity;
  if (!element.gives("transmittance")) material.transmittance = library.transmittance;
  if (!own_model) material.scattering = library.scattering;
  if (!material.relief) material.relief = library.relief;
  material.heat_balance = library.heat_balance;
}

/// A model that scales spectra which the library's material does not have.
void check_completed(const BuildContext& context, const CheckedElement& element,
                     const MaterialInput& material) {
  const CheckedElement* model = scattering_element(element);
  if (model == nullptr || material.reflectance || material.emissivity) return;
  context.mistake(model->offset,
                  fmt::format("<{}> needs a reflectance, but the library's material brings its "
                              "spectra with a scattering model of its own",
                              model->type->name));
}

/// Takes the library's material that the element asks for.
/// @return whether there is one
bool take_from_library(const BuildContext& context, const CheckedElement& element,
                       const Libraries& libraries, MaterialInput& material) {
  const bool named = element.gives("from");
  const std::string wanted = named ? element.value<std::string>("from") : material.name;
  if (wanted.empty()) return false;
  const auto found = libraries.by_name.find(wanted);
  if (found != libraries.by_name.end()) {
    complete_from(found->second, element, material);
    check_completed(context, element, material);
    if (scattering_element(element) == nullptr) check_transmittance(context, element, material);
    return true;
  }
  if (!libraries.complete) return false;
  if (!libraries.any) {
    context.mistake(element.where("from"),
                    fmt::format("material \"{}\" has neither reflectance nor emissivity, and no "
                                "library is listed to take them from",
                                material.name),
                    "write <library file=\"library:materials.xml\"/> in <materials>");
    return false;
  }
  context.mistake(element.where("from"),
                  fmt::format("no library has a material \"{}\"{}", wanted,
                              named ? "" : ", and it has neither reflectance nor emissivity here"),
                  suggestion(wanted, libraries.names));
  return false;
}

struct BuiltMaterial {
  MaterialInput material;
  MadeFrom made_from = MadeFrom::itself;
};

BuiltMaterial build_material(const BuildContext& context, const CheckedElement& element,
                             const Libraries& libraries, const Scenario& scenario) {
  BuiltMaterial built{build_material_data(context, element)};
  MaterialInput& material = built.material;
  if (const CheckedElement* solver = element.child("solver")) {
    material.solver = build_solver(*solver, scenario.solver);
  }
  if (!stands_alone(element, material)) {
    const bool found = take_from_library(context, element, libraries, material);
    built.made_from = found ? MadeFrom::library : MadeFrom::unknown;
  } else if (element.gives("from")) {
    const bool own = brings_spectra(material.scattering);
    context.mistake(element.where("from"),
                    own ? fmt::format("<{}> brings its own spectra: from has no place beside it",
                                      scattering_element(element)->type->name)
                        : "give either from, or reflectance and emissivity, not both");
  }
  return built;
}

}  // namespace

MaterialNames build_materials(const BuildContext& context, const CheckedElement& root,
                              Scenario& scenario) {
  const CheckedElement& element = *root.child("materials");
  const Libraries libraries = read_libraries(context, element);
  MaterialTemperatures temperatures{context, element, scenario.heat.has_value()};
  MaterialNames names;
  names.set_library_names(libraries.names);
  scenario.libraries = libraries.files;
  std::vector<const CheckedElement*> declared, all;
  for (const CheckedElement& child : element.children) {
    const std::string& kind = child.type->name;
    if (kind == "library") continue;
    all.push_back(&child);
    if (kind != "material") {
      names.add_map(child.value<std::string>("name"), child.offset);
      continue;
    }
    declared.push_back(&child);
    names.add(child.value<std::string>("name"), child.offset);
    BuiltMaterial built = build_material(context, child, libraries, scenario);
    temperatures.add(child, built.made_from, built.material);
    scenario.materials.push_back(std::move(built.material));
  }
  temperatures.finish(root.child("heat"));
  context.check_unique(all, "material");
  const FindPart find = [&](const CheckedElement& part) -> std::optional<std::size_t> {
    const auto found = names.resolve_material(context, part);
    return found ? std::optional{static_cast<std::size_t>(*found)} : std::nullopt;
  };
  resolve_mixtures(context, declared, find, scenario.materials);
  build_maps(context, element, names, scenario);
  names.set_material_count(scenario.materials.size());
  return names;
}

}  // namespace nadir::sim
