#include "sim/scenario/schema_parts.hpp"

namespace nadir::sim {
namespace {

/// What a material of a scenario and one of a library have in common.
std::vector<Attribute> optical() {
  return {optional("reflectance", fraction(), "", "1 - emissivity - transmittance",
                   "Directional-hemispherical reflectance. Where only one of reflectance and "
                   "emissivity is given, the other follows. Models that bring their own spectra "
                   "take neither."),
          optional("emissivity", fraction(), "", "1 - reflectance - transmittance",
                   "Directional emissivity."),
          optional("transmittance", fraction(), "", "opaque",
                   "Directional-hemispherical transmittance, of leaf and clear_sheet.")};
}

std::vector<Child> scattering_and(std::vector<Child> others) {
  std::vector<Child> children = scattering_children();
  children.insert(children.end(), others.begin(), others.end());
  return children;
}

ElementType material() {
  ElementType type{
      .id = "material",
      .name = "material",
      .doc =
          "A material that surfaces of this scenario may name. Without from, reflectance, "
          "emissivity and a model with spectra of its own it is the library's material of the "
          "same name. At most one scattering model; without one the library's, or lambertian. At "
          "most one source of temperature, as an attribute or as a child; without one the list's "
          "default temperature.",
      .attributes = {required("name", NameType{}, "", "Unique in the scenario, maps included."),
                     optional("description", TextType{}, "", "the library's, if it is from there",
                              "For people."),
                     optional("from", NameType{}, "",
                              "spectra from reflectance or emissivity, or "
                              "the library's material of the same name",
                              "Name of a library's material whose spectra to take.")},
      .content = Content::record,
      .children = scattering_and({{"relief"}, {"material_solver"}})};
  for (Attribute& attribute : optical()) type.attributes.push_back(std::move(attribute));
  for (Attribute& attribute : temperature_pair("temperature", "the list's default",
                                               "Of the whole material; 0 K: it does not emit.")) {
    type.attributes.push_back(std::move(attribute));
  }
  type.attributes.push_back(defaulted("solve", boolean(), "", "false",
                                      "Takes the heat balance of the library's material."));
  for (Child& child : temperature_children()) type.children.push_back(std::move(child));
  return type;
}

ElementType library_material() {
  ElementType type{
      .id = "library_material",
      .name = "material",
      .doc =
          "A material of a library. At least one of reflectance and emissivity is "
          "needed, unless its scattering model brings spectra of its own. Its heat balance is for "
          "scenarios that say solve=\"true\".",
      .attributes = {required("name", NameType{}, "", "Unique in the library."),
                     optional("description", TextType{}, "", "none", "For people.")},
      .content = Content::record,
      .children = scattering_and({{"relief"}, {"heat_balance"}})};
  for (Attribute& attribute : optical()) type.attributes.push_back(std::move(attribute));
  return type;
}

}  // namespace

std::vector<ElementType> schema_of_materials() {
  return {
      {.id = "materials",
       .name = "materials",
       .doc = "What surfaces are made of.",
       .attributes =
           temperature_pair("default_temperature", "every material has a source of temperature",
                            "Of materials that have no source of temperature."),
       .content = Content::list,
       .children = {{"library"}, {"material"}, {"material_map"}, {"contrast_map"}},
       .at_least = 1},
      {.id = "library",
       .name = "library",
       .doc = "A file of materials to take spectra from. Where two libraries hold the same name, "
              "the one listed first counts.",
       .attributes = {required("file", PathType{{".xml"}}, "",
                               "Nadir's own is library:materials.xml.")}},
      material(),
      {.id = library_root,
       .name = "materials",
       .doc = "Root of a material library. Its paths count from the library's own folder.",
       .content = Content::list,
       .children = {{"library_material"}},
       .at_least = 1},
      library_material(),
  };
}

}  // namespace nadir::sim
