#include "sim/run/load_materials.hpp"

#include "sim/files/brdf_file.hpp"
#include "sim/run/error_list.hpp"
#include "sim/run/load_relief.hpp"
#include "sim/run/load_scattering.hpp"

namespace nadir::sim {

materials::Material MaterialReader::read(const MaterialInput& input) {
  const auto curve = [&](const std::optional<SpectralInput>& given, SpectrumQuantity quantity) {
    return given ? std::optional{curves_.read(*given, quantity, spectral::Outside::hold)}
                 : std::nullopt;
  };
  materials::Material material;
  material.name = input.name;
  material.description = input.description;
  material.reflectance = curve(input.reflectance, SpectrumQuantity::reflectance);
  material.transmittance = curve(input.transmittance, SpectrumQuantity::transmittance);
  material.emissivity = curve(input.emissivity, SpectrumQuantity::emissivity);
  material.scattering = read_scattering(input.scattering, *this);
  material.solver = input.solver;
  if (input.variant_of) material.shown_as = static_cast<std::uint32_t>(*input.variant_of);
  material.where = input.where;
  return material;
}

std::shared_ptr<const materials::Material> MaterialReader::part(
    const std::shared_ptr<const MaterialInput>& input) {
  auto& known = parts_[input.get()];
  if (!known) known = std::make_shared<const materials::Material>(read(*input));
  return known;
}

std::shared_ptr<const materials::BrdfTable> MaterialReader::table(
    const std::filesystem::path& file) {
  auto& known = tables_[file];
  if (!known) {
    known = std::make_shared<const materials::BrdfTable>(
        read_brdf_file(curves_.files().note(file)).table);
  }
  return known;
}

materials::Material load_material(const MaterialInput& input, InputFiles& files) {
  return MaterialReader{files}.read(input);
}

std::vector<materials::Material> load_materials(const Scenario& scenario,
                                                const geometry::LocalFrame& frame,
                                                InputFiles& files, Diagnostics& diagnostics) {
  MaterialReader reader{files};
  ReliefReader reliefs{frame, files, diagnostics};
  std::vector<materials::Material> all;
  ErrorList errors;
  for (const MaterialInput& input : scenario.materials) {
    errors.attempt([&] {
      all.push_back(reader.read(input));
      if (input.relief) all.back().relief = reliefs.read(*input.relief);
    });
  }
  errors.throw_if_any();
  return all;
}

}  // namespace nadir::sim
