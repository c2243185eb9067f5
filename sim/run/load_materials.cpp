#include "sim/run/load_materials.hpp"

#include "sim/run/error_list.hpp"
#include "sim/run/read_curves.hpp"

namespace nadir::sim {

materials::Material load_material(const MaterialInput& input, InputFiles& files) {
  materials::Material material;
  material.name = input.name;
  material.description = input.description;
  if (input.reflectance) {
    material.reflectance =
        curve_of(*input.reflectance, SpectrumQuantity::reflectance, spectral::Outside::hold, files);
  }
  if (input.emissivity) {
    material.emissivity =
        curve_of(*input.emissivity, SpectrumQuantity::emissivity, spectral::Outside::hold, files);
  }
  material.solver = input.solver;
  return material;
}

std::vector<materials::Material> load_materials(const Scenario& scenario, InputFiles& files) {
  std::vector<materials::Material> all;
  ErrorList errors;
  for (const MaterialInput& input : scenario.materials) {
    errors.attempt([&] { all.push_back(load_material(input, files)); });
  }
  errors.throw_if_any();
  return all;
}

}  // namespace nadir::sim
