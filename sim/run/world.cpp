#include "sim/run/world.hpp"

#include "sim/plan/array_plan.hpp"
#include "sim/run/error_list.hpp"
#include "sim/run/load_camera.hpp"
#include "sim/run/load_geometry.hpp"
#include "sim/run/load_light.hpp"
#include "sim/run/load_materials.hpp"

namespace nadir::sim {
namespace {

thermal::TemperatureField temperatures(const Scenario& scenario) {
  std::vector<thermal::TemperatureSource> sources;
  for (const MaterialInput& material : scenario.materials) {
    sources.emplace_back(thermal::ConstantTemperature{Kelvin{material.temperature_k}});
  }
  return thermal::TemperatureField{std::move(sources)};
}

}  // namespace

World load_world(const Scenario& scenario, InputFiles& files, Diagnostics& diagnostics) {
  files.note(scenario.file);
  for (const auto& library : scenario.libraries) files.note(library);
  const geometry::LocalFrame frame{scenario.origin};
  std::vector<materials::Material> materials;
  std::optional<LoadedGeometry> geometry;
  ephemeris::Illumination illumination;
  atmosphere::Atmosphere air;
  Camera camera;

  ErrorList errors;
  errors.attempt([&] { materials = load_materials(scenario, files); });
  errors.attempt([&] { illumination = load_illumination(scenario, files, diagnostics); });
  errors.attempt([&] { air = load_atmosphere(scenario, files); });
  errors.attempt([&] { geometry = load_geometry(scenario, frame, files); });
  if (geometry) {
    errors.attempt([&] { camera = load_camera(scenario, frame, geometry->terrain, files); });
  }
  errors.throw_if_any();
  return {{geometry->scene, std::move(materials), temperatures(scenario), std::move(illumination),
           std::move(air), scenario.solver},
          std::move(camera)};
}

void check_spectra(const World& world, const SamplingInput& sampling, Diagnostics& diagnostics) {
  ErrorList errors;
  for (const sensor::DetectorArray& array : world.camera.arrays) {
    for (const auto& lanes : plan_array(array, sampling.wavelengths_per_band).lanes.blocks) {
      errors.attempt([&] { const radiometry::LitScene lit{world.scene, lanes, diagnostics}; });
    }
  }
  errors.throw_if_any();
}

}  // namespace nadir::sim
