#include "sim/scenario/schema_parts.hpp"

namespace nadir::sim {
namespace {

SpectralType fraction() { return {from_to(0.0, 1.0)}; }

const char* const reflectance_doc =
    "Directional-hemispherical reflectance. Where only one of reflectance and emissivity is given, "
    "the other is 1 minus it.";

}  // namespace

std::vector<ElementType> schema_of_materials() {
  return {
      {.id = "materials",
       .name = "materials",
       .doc = "What surfaces are made of.",
       .attributes = {required("default_temperature_k", temperature(), "K",
                               "Of materials that have none of their own.")},
       .content = Content::list,
       .children = {{"library"}, {"material"}},
       .at_least = 1},
      {.id = "library",
       .name = "library",
       .doc = "A file of materials to take spectra from. Where two libraries hold the same name, "
              "the one listed first counts.",
       .attributes = {required("file", PathType{{".xml"}}, "",
                               "Nadir's own is library:materials.xml.")}},
      {.id = "material",
       .name = "material",
       .doc = "A material that surfaces of this scenario may name. Without from, reflectance and "
              "emissivity its spectra are those of the library's material of the same name.",
       .attributes = {required("name", NameType{}, "", "Unique in the scenario."),
                      optional("description", TextType{}, "", "the library's, if it is from there",
                               "For people."),
                      optional("from", NameType{}, "",
                               "spectra from reflectance or emissivity, or "
                               "the library's material of the same name",
                               "Name of a library's material whose spectra to take."),
                      optional("reflectance", fraction(), "", "1 - emissivity", reflectance_doc),
                      optional("emissivity", fraction(), "", "1 - reflectance",
                               "Directional emissivity."),
                      optional("temperature_k", temperature(), "K",
                               "the list's default_temperature_k",
                               "Thermodynamic temperature; 0: it does not emit.")},
       .content = Content::record,
       .children = {{"lambertian"}, {"material_solver"}}},
      {.id = "lambertian",
       .name = "lambertian",
       .doc = "Scatters alike in all directions. What holds without a scattering model as well."},
      {.id = library_root,
       .name = "materials",
       .doc = "Root of a material library. Its paths count from the library's own folder.",
       .content = Content::list,
       .children = {{"library_material"}},
       .at_least = 1},
      {.id = "library_material",
       .name = "material",
       .doc = "A material of a library. At least one of reflectance and emissivity is needed.",
       .attributes = {required("name", NameType{}, "", "Unique in the library."),
                      optional("description", TextType{}, "", "none", "For people."),
                      optional("reflectance", fraction(), "", "1 - emissivity", reflectance_doc),
                      optional("emissivity", fraction(), "", "1 - reflectance",
                               "Directional emissivity.")},
       .content = Content::record,
       .children = {{"lambertian"}}},
  };
}

}  // namespace nadir::sim
