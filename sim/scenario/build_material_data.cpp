#include <fmt/format.h>

#include "sim/scenario/build_material.hpp"

namespace nadir::sim {
namespace {

ReliefInput build_relief(const BuildContext& context, const CheckedElement& element) {
  return {element.value<std::filesystem::path>("file"),
          element.value<std::string>("kind") == "normals", element.number("strength"),
          build_map_place(context, element), context.source.locate(element.offset)};
}

/// Whether the model sends the material's transmittance through.
bool takes_transmittance(const ScatteringInput& model) {
  const auto* sheet = std::get_if<ClearSheetInput>(&model);
  return std::holds_alternative<materials::Leaf>(model) || (sheet != nullptr && !sheet->n);
}

void check_spectra(const BuildContext& context, const CheckedElement& element,
                   const MaterialInput& material) {
  const CheckedElement* model = scattering_element(element);
  const std::string name = model != nullptr ? model->type->name : "lambertian";
  if (brings_spectra(material.scattering)) {
    for (const char* attribute : {"reflectance", "emissivity", "transmittance"}) {
      if (!element.gives(attribute)) continue;
      context.mistake(element.where(attribute),
                      fmt::format("{} has no place beside <{}>, which brings its own spectra",
                                  attribute, name));
    }
  } else if (model != nullptr || element.gives("reflectance") || element.gives("emissivity")) {
    check_transmittance(context, element, material);  // otherwise a library's model decides
  }
  const auto mistake = energy_mistake(material);
  if (mistake.empty()) return;
  const char* last = element.gives("emissivity") ? "emissivity" : "transmittance";
  context.mistake(element.where(last), mistake);
}

}  // namespace

void check_transmittance(const BuildContext& context, const CheckedElement& element,
                         const MaterialInput& material) {
  if (!element.gives("transmittance") || takes_transmittance(material.scattering)) return;
  context.mistake(element.where("transmittance"),
                  "the material's scattering model lets no light through by it",
                  "<leaf/> does, and <clear_sheet/> without n");
}

std::string energy_mistake(const MaterialInput& material) {
  double sum = 0.0;
  std::string list;
  int count = 0;
  const auto add = [&](const char* name, const std::optional<SpectralInput>& input) {
    const double* value = input ? std::get_if<double>(&input->source) : nullptr;
    if (value == nullptr) return;
    sum += *value;
    list += fmt::format("{}{} {}", ++count > 1 ? " and " : "", name, *value);
  };
  add("reflectance", material.reflectance);
  add("transmittance", material.transmittance);
  add("emissivity", material.emissivity);
  // 1e-9: decimals such as 0.1 + 0.9 are not exact in binary
  return sum <= 1.0 + 1e-9 ? std::string{} : list + " sum to more than 1";
}

MaterialInput build_material_data(const BuildContext& context, const CheckedElement& element) {
  MaterialInput material;
  material.name = element.value<std::string>("name");
  material.description = element.value<std::string>("description");
  material.reflectance = element.find<SpectralInput>("reflectance");
  material.emissivity = element.find<SpectralInput>("emissivity");
  material.transmittance = element.find<SpectralInput>("transmittance");
  material.where = context.source.locate(element.offset);
  material.scattering =
      build_scattering(context, element).value_or(ScatteringInput{materials::Lambertian{}});
  if (const CheckedElement* relief = element.child("relief")) {
    material.relief = build_relief(context, *relief);
  }
  check_spectra(context, element, material);
  return material;
}

}  // namespace nadir::sim
