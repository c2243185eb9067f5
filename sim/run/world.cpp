#include "sim/run/world.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>

#include "sim/run/air_stage_check.hpp"
#include "sim/run/drop_effects.hpp"
#include "sim/run/epochs.hpp"
#include "sim/run/error_list.hpp"
#include "sim/run/gather_facts.hpp"
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

using radiometry::Effect;

/// Which arrays need temperatures, whatever they cost.
std::vector<bool> arrays_asking(const Scenario& scenario, const Camera& camera,
                                const ephemeris::Illumination& bodies, const EffectPlan& plan) {
  std::vector<bool> asking;
  const Kelvin warmest = warmest_solved(scenario);
  const bool stated = scenario.effects.of(Effect::thermal_solve) == EffectState::on;
  for (std::size_t i = 0; i < camera.arrays.size(); ++i) {
    const bool solves = plan.by_array[i].has(Effect::thermal_solve);
    const bool seen = stated || (plan.by_array[i].has(Effect::surface_emission) &&
                                 sees_heat(camera.arrays[i], bodies, warmest));
    asking.push_back(scenario.products.truth_temperature || (solves && seen));
  }
  return asking;
}

/// Light of sun and moon comes through the air, whatever else of it is left out.
bool wants_air(radiometry::EffectSet effects) {
  for (const Effect effect : {Effect::solar_reflection, Effect::lunar_reflection,
                              Effect::sky_scattering, Effect::sky_emission, Effect::path_scattering,
                              Effect::path_emission, Effect::path_transmittance}) {
    if (effects.has(effect)) return true;
  }
  return false;
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

namespace {

/// What is read before effects are decided.
struct Foundations {
  std::vector<materials::Material> materials;
  std::vector<materials::MaterialMap> maps;
  atmosphere::Atmosphere air;
  std::optional<AirTask> air_task;
  std::optional<Epochs> epochs;
  std::optional<LoadedGeometry> geometry;
  Camera camera;
};

/// Reads one thing after the other; each may find mistakes, which are told together.
class WorldLoader {
 public:
  WorldLoader(const Scenario& scenario, InputFiles& files, Diagnostics& diagnostics)
      : scenario_{scenario},
        kept_{scenario},
        frame_{scenario.origin},
        files_{files},
        diagnostics_{diagnostics} {}

  World load(std::uint64_t seed) {
    // What the scenario forbids is not even looked at.
    radiometry::EffectSet allowed = radiometry::EffectSet::all();
    for (std::size_t i = 0; i < radiometry::effect_count; ++i) {
      const auto effect = static_cast<radiometry::Effect>(i);
      if (scenario_.effects.of(effect) == EffectState::off) allowed = allowed.without(effect);
    }
    drop_effects(kept_, allowed);
    lay_foundations();
    decide_effects();
    load_light_and_volumes();
    load_temperature(seed);
    return assemble();
  }

 private:
  void lay_foundations() {
    Foundations& f = base_;
    const bool have_materials =
        errors_.attempt([&] { f.materials = load_materials(kept_, frame_, files_, diagnostics_); });
    // Contrast maps compare the spectra of materials: without those each would be a mistake more.
    errors_.attempt([&] {
      if (have_materials) f.maps = load_maps(kept_, f.materials, frame_, files_, diagnostics_);
    });
    errors_.attempt([&] {
      f.air = load_atmosphere(kept_, files_);
      f.air_task = load_air_task(kept_, files_, diagnostics_);
    });
    errors_.attempt([&] { f.epochs.emplace(kept_); });
    errors_.attempt([&] {
      if (f.epochs) f.geometry = load_geometry(kept_, frame_, *f.epochs, files_);
    });
    if (f.geometry) {
      errors_.attempt([&] { f.camera = load_camera(kept_, frame_, f.geometry->terrain, files_); });
      errors_.attempt([&] { check_extent(f.geometry->scene, diagnostics_); });
    }
    if (errors_.any()) load_light_and_volumes();  // for their mistakes; throws
  }

  void decide_effects() {
    const Foundations& f = base_;
    facts_ = gather_facts(kept_, {f.materials, *f.geometry, f.camera, f.air, f.air_task});
    plan_ = plan_effects(scenario_.effects, scenario_.accuracy, facts_);
    drop_effects(kept_, plan_.any);
    if (!wants_air(plan_.any)) {
      base_.air = atmosphere::None{};
      base_.air_task.reset();
    }
    if (!plan_.any.has(Effect::lamps)) base_.geometry->lamps.clear();
    drop_effects(base_.camera, plan_.by_array);
  }

  void load_light_and_volumes() {
    const std::optional<LoadedGeometry>& geometry = base_.geometry;
    errors_.attempt([&] { illumination_ = load_illumination(kept_, files_, diagnostics_); });
    errors_.attempt([&] {
      if (geometry) volumes_ = load_volumes(kept_, geometry->terrain, files_);
    });
    errors_.attempt([&] {
      if (geometry) check_lamps(geometry->scene, kept_, geometry->lamps, diagnostics_);
    });
    errors_.attempt([&] {
      if (geometry && base_.air_task) {
        fit_air(kept_, *geometry, base_.air, illumination_, base_.camera, *base_.air_task,
                diagnostics_);
      }
    });
    errors_.throw_if_any();
  }

  void load_temperature(std::uint64_t seed) {
    const Foundations& f = base_;
    errors_.attempt([&] {
      asking_ = arrays_asking(kept_, f.camera, illumination_, plan_);
      const bool asked = std::find(asking_.begin(), asking_.end(), true) != asking_.end();
      temperatures_ = load_temperatures(
          kept_,
          {f.geometry->scene, f.materials, f.maps, *f.epochs, frame_, f.geometry->hottest_vertex_k},
          asked, seed, files_, diagnostics_);
    });
    errors_.throw_if_any();
  }

  World assemble() {
    Foundations& f = base_;
    warn_of_bright_night(kept_, illumination_, f.air, diagnostics_);
    std::vector<std::string> names = object_names(kept_, f.geometry->lamps);
    World world{
        scenario_.file,
        {f.geometry->scene, std::move(f.materials), std::move(temperatures_->field),
         std::move(illumination_), std::move(f.air), kept_.solver, std::move(f.maps),
         std::move(volumes_), std::move(f.geometry->lamps), kept_.method, kept_.path_max_bounces},
        std::move(f.camera),
        std::move(f.air_task),
        std::move(temperatures_->solver),
        std::move(asking_),
        frame_,
        std::move(names),
        std::move(facts_),
        std::move(plan_)};
    check_cover(kept_, world.scene, diagnostics_);
    return world;
  }

  const Scenario& scenario_;
  Scenario kept_;  // without what is dropped
  geometry::LocalFrame frame_;
  InputFiles& files_;
  Diagnostics& diagnostics_;
  ErrorList errors_;
  Foundations base_;
  SceneFacts facts_;
  EffectPlan plan_;
  ephemeris::Illumination illumination_;
  std::vector<radiometry::Volume> volumes_;
  std::optional<LoadedTemperatures> temperatures_;
  std::vector<bool> asking_;
};

}  // namespace

World load_world(const Scenario& scenario, InputFiles& files, Diagnostics& diagnostics,
                 std::uint64_t seed) {
  files.note(scenario.file);
  for (const auto& library : scenario.libraries) files.note(library);
  return WorldLoader{scenario, files, diagnostics}.load(seed);
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
