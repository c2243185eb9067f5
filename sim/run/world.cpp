#include "sim/run/world.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>

#include "sim/run/air_stage_check.hpp"
#include "sim/run/epochs.hpp"
#include "sim/run/error_list.hpp"
#include "sim/run/load_air.hpp"
#include "sim/run/load_camera.hpp"
#include "sim/run/load_geometry.hpp"
#include "sim/run/load_heat.hpp"
#include "sim/run/load_lamps.hpp"
#include "sim/run/load_light.hpp"
#include "sim/run/load_maps.hpp"
#include "sim/run/load_materials.hpp"
#include "sim/run/load_volumes.hpp"

namespace nadir::sim {
namespace {

/// Which arrays need temperatures, whatever they cost.
std::vector<bool> arrays_asking(const Scenario& scenario, const Camera& camera,
                                const ephemeris::Illumination& bodies) {
  std::vector<bool> asking;
  const Kelvin warmest = warmest_solved(scenario);
  for (const sensor::DetectorArray& array : camera.arrays) {
    asking.push_back(scenario.products.truth_temperature || sees_heat(array, bodies, warmest));
  }
  return asking;
}

/// Objects in the order of the file, then the area lamps, of which a list may place many: as
/// load_geometry numbers them.
std::vector<std::string> object_names(const Scenario& scenario,
                                      const std::vector<radiometry::Lamp>& lamps) {
  std::vector<std::string> names;
  for (const GeometryInput& input : scenario.geometry) {
    names.push_back(std::visit([](const auto& part) { return part.name; }, input));
  }
  const auto area_lamps = std::count_if(lamps.begin(), lamps.end(), [](const auto& lamp) {
    return std::holds_alternative<radiometry::AreaLamp>(lamp.form);
  });
  names.insert(names.end(), static_cast<std::size_t>(area_lamps), "lamp");
  return names;
}

// Rays leave a surface lifted by a few units of float resolution of the scene's size: a shadow
// detail smaller than that is lost. (Lift at the edge of a scene of half extent S: 6 * 2^-23 S.)
constexpr double lift_per_extent = 6.0 * 0x1p-23;
constexpr double noticeable_m = 0.05;  // a kerb's shadow
constexpr double useless_m = 1.0;      // a person's shadow

// The sun's direction is that of the site; 100 km away it is off by a degree.
constexpr double farthest_from_site_m = 1e5;

void check_extent(const geometry::Scene& scene, Diagnostics& diagnostics) {
  const geometry::Bounds box = scene.bounds();
  const Vec3 half = (box.hi - box.lo) * 0.5;
  const double lift_m = lift_per_extent * std::max({half.x, half.y, half.z});
  const std::string reach =
      fmt::format("the scene reaches from ({:.0f}, {:.0f}, {:.0f}) to ({:.0f}, {:.0f}, {:.0f}) m",
                  box.lo.x, box.lo.y, box.lo.z, box.hi.x, box.hi.y, box.hi.z);
  if (lift_m > useless_m) {
    throw InputError{reach + "; in one this large shadows finer than a metre would be lost"};
  }
  if (lift_m > noticeable_m) {
    diagnostics.warn(fmt::format("{}; shadows finer than {:.2f} m may be lost", reach, lift_m));
  }
  const auto beyond = [](double lo, double hi) { return std::max({lo, -hi, 0.0}); };
  const Vec3 nearest{beyond(box.lo.x, box.hi.x), beyond(box.lo.y, box.hi.y),
                     beyond(box.lo.z, box.hi.z)};
  if (length(nearest) > farthest_from_site_m) {
    throw InputError{
        fmt::format("{}: its nearest surface is {:.0f} km from the site, whose sun "
                    "and horizon it has",
                    reach, length(nearest) * 1e-3)};
  }
}

}  // namespace

World load_world(const Scenario& scenario, InputFiles& files, Diagnostics& diagnostics,
                 std::uint64_t seed) {
  files.note(scenario.file);
  for (const auto& library : scenario.libraries) files.note(library);
  const geometry::LocalFrame frame{scenario.origin};
  std::vector<materials::Material> materials;
  std::optional<LoadedGeometry> geometry;
  ephemeris::Illumination illumination;
  atmosphere::Atmosphere air;
  std::optional<AirTask> air_task;
  std::vector<materials::MaterialMap> maps;
  std::vector<radiometry::Volume> volumes;
  Camera camera;
  std::optional<Epochs> epochs;
  std::optional<LoadedTemperatures> temperatures;
  std::vector<bool> asking;

  ErrorList errors;
  const bool have_materials =
      errors.attempt([&] { materials = load_materials(scenario, frame, files, diagnostics); });
  // Contrast maps compare the spectra of materials: without those each would be a mistake more.
  errors.attempt([&] {
    if (have_materials) maps = load_maps(scenario, materials, frame, files, diagnostics);
  });
  errors.attempt([&] { illumination = load_illumination(scenario, files, diagnostics); });
  errors.attempt([&] {
    air = load_atmosphere(scenario, files);
    air_task = load_air_task(scenario, files, diagnostics);
  });
  errors.attempt([&] { epochs.emplace(scenario); });
  errors.attempt([&] {
    if (epochs) geometry = load_geometry(scenario, frame, *epochs, files);
  });
  if (geometry) {
    errors.attempt([&] { camera = load_camera(scenario, frame, geometry->terrain, files); });
  }
  errors.attempt([&] {
    if (geometry) check_extent(geometry->scene, diagnostics);
  });
  errors.attempt([&] {
    if (geometry) volumes = load_volumes(scenario, geometry->terrain, files);
  });
  errors.attempt([&] {
    if (geometry) check_lamps(geometry->scene, scenario, geometry->lamps, diagnostics);
  });
  errors.attempt([&] {
    if (geometry && air_task) {
      fit_air(scenario, *geometry, air, illumination, camera, *air_task, diagnostics);
    }
  });
  errors.throw_if_any();
  errors.attempt([&] {
    asking = arrays_asking(scenario, camera, illumination);
    const bool asked = std::find(asking.begin(), asking.end(), true) != asking.end();
    temperatures = load_temperatures(
        scenario, {geometry->scene, materials, maps, *epochs, frame, geometry->hottest_vertex_k},
        asked, seed, files, diagnostics);
  });
  errors.throw_if_any();
  warn_of_bright_night(scenario, illumination, air, diagnostics);
  std::vector<std::string> names = object_names(scenario, geometry->lamps);
  World world{
      scenario.file,
      {geometry->scene, std::move(materials), std::move(temperatures->field),
       std::move(illumination), std::move(air), scenario.solver, std::move(maps),
       std::move(volumes), std::move(geometry->lamps), scenario.method, scenario.path_max_bounces},
      std::move(camera),
      std::move(air_task),
      std::move(temperatures->solver),
      std::move(asking),
      frame,
      std::move(names)};
  check_cover(scenario, world.scene, diagnostics);
  return world;
}

void check_memory(const Camera& camera, const AirDemand& air) {
  // Images stream to the disk: what memory holds of them is a strip (strips.hpp), at most some
  // hundred megabytes however many bands there are. The table of the air is held as a whole.
  constexpr double bytes_per_band = 8.0 * sizeof(float);
  constexpr double bytes_of_truth = 16.0 * sizeof(float) + 4.0 * sizeof(double);
  constexpr double strip_pixels = 2.0 * (1 << 17);
  double largest = 0.0;
  for (const sensor::DetectorArray& array : camera.arrays) {
    const double pixels = std::max(strip_pixels, 16.0 * array.samples);
    largest = std::max(largest, pixels * (bytes_per_band * static_cast<double>(array.bands.size()) +
                                          bytes_of_truth));
  }
  const double needed = air.bytes + largest;
  const double there =
      static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE));
  if (needed <= there) return;
  const std::string table =
      air.lanes > 0 ? fmt::format(" and the table of the air's {} lanes", air.lanes) : "";
  throw InputError{fmt::format("the images{} need {:.1f} GB of memory, this machine has {:.1f} GB",
                               table, needed * 1e-9, there * 1e-9)};
}

CameraPlan plan_camera(const World& world, const SamplingInput& sampling) {
  const std::vector<sensor::DetectorArray>& arrays = world.camera.arrays;
  const auto* air = std::get_if<atmosphere::Tabulated>(&world.scene.atmosphere);
  if (air == nullptr) return plan_camera(arrays, sampling.wavelengths_per_band);
  return at_element(world.air ? world.air->where : SourceLocation{}, [&] {
    return plan_camera(arrays, sampling.wavelengths_per_band, *air->table);
  });
}

void check_spectra(const World& world, const SamplingInput& sampling, Diagnostics& diagnostics) {
  // Air in layers is still to come (None) and knows all wavelengths that bands may have.
  const CameraPlan plan = plan_camera(world, sampling);
  ErrorList errors;
  for (std::size_t i = 0; i < plan.arrays.size(); ++i) {
    for (const auto& lanes : plan.arrays[i].lanes.blocks) {
      errors.attempt("array " + world.camera.arrays[i].name, world.file.string(), [&] {
        const radiometry::LitScene lit{world.scene, lanes, diagnostics};
      });
      if (world.air) errors.attempt([&] { check_air_spectra(*world.air, lanes); });
    }
  }
  errors.throw_if_any();
}

}  // namespace nadir::sim
