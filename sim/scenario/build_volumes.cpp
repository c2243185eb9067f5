#include <fmt/format.h>

#include <array>

#include "sim/scenario/build_context.hpp"

namespace nadir::sim {
namespace {

namespace geo = nadir::geometry;

constexpr std::array shape_names{"box", "sphere", "cylinder"};
constexpr std::array phase_names{"henyey_greenstein", "rayleigh", "phase_table"};

/// The one child that has one of these names; a second one is a mistake.
template <std::size_t Count>
const CheckedElement* only_child(const BuildContext& context, const CheckedElement& element,
                                 const std::array<const char*, Count>& names,
                                 const std::string& what) {
  const CheckedElement* first = nullptr;
  for (const CheckedElement& child : element.children) {
    bool is_one = false;
    for (const char* const name : names) is_one = is_one || child.type->name == name;
    if (!is_one) continue;
    if (first != nullptr) {
      context.mistake(child.offset, fmt::format("<volume> has two {}: <{}> and <{}>", what,
                                                first->type->name, child.type->name));
      break;
    }
    first = &child;
  }
  return first;
}

geo::RegionShape shape_of(const BuildContext& context, const CheckedElement& volume) {
  const CheckedElement* child = only_child(context, volume, shape_names, "shapes");
  if (child == nullptr) {
    context.mistake(volume.offset, "<volume> has no shape",
                    "write <box lo_m=\"...\" hi_m=\"...\"/>, <sphere> or <cylinder> in it");
    return geo::Sphere{};
  }
  if (child->type->name == "box") return build_box(context, *child);
  if (child->type->name == "sphere") return geo::Sphere{{}, child->number("radius_m")};
  geo::Cylinder cylinder = build_cylinder(context, *child);
  cylinder.capped = true;
  return cylinder;
}

void set_phase(const BuildContext& context, const CheckedElement& element, VolumeInput& volume) {
  const CheckedElement* child = only_child(context, element, phase_names, "phase functions");
  if (child == nullptr) return;
  if (child->type->name == "rayleigh") {
    volume.phase = RayleighInput{};
  } else if (child->type->name == "phase_table") {
    volume.phase = PhaseTableInput{child->value<std::filesystem::path>("file")};
  } else {
    volume.phase = HenyeyGreensteinInput{child->value<SpectralInput>("g")};
  }
}

void set_grids(const BuildContext& context, const CheckedElement& element, VolumeInput& volume) {
  volume.density_grid = element.find<std::filesystem::path>("density_grid");
  volume.temperature = element.number("temperature_k");
  if (const auto grid = element.find<std::filesystem::path>("temperature_grid")) {
    volume.temperature = *grid;
  }
  if (element.gives("temperature_grid") && element.gives("temperature_k")) {
    context.mistake(element.where("temperature_k"),
                    "give either temperature_k or temperature_grid, not both");
  }
  if (std::holds_alternative<geo::Box>(volume.shape)) return;
  for (const char* const grid : {"density_grid", "temperature_grid"}) {
    if (!element.gives(grid)) continue;
    context.mistake(element.where(grid),
                    fmt::format("{} needs a volume whose shape is a <box>", grid));
  }
}

VolumeInput build_volume(const BuildContext& context, const CheckedElement& element,
                         bool has_terrain) {
  VolumeInput volume;
  volume.name = element.value<std::string>("name");
  volume.where = context.source.locate(element.offset);
  volume.shape = shape_of(context, element);
  volume.placement = build_placement(context, element, has_terrain);
  volume.absorption_per_m = element.value<SpectralInput>("absorption_per_m");
  volume.scattering_per_m = element.value<SpectralInput>("scattering_per_m");
  set_phase(context, element, volume);
  set_grids(context, element, volume);
  if (!element.gives("absorption_per_m") && !element.gives("scattering_per_m")) {
    context.mistake(element.offset,
                    "<volume> neither absorbs nor scatters: give absorption_per_m or "
                    "scattering_per_m");
  }
  return volume;
}

}  // namespace

void build_volumes(const BuildContext& context, const CheckedElement& element, bool has_terrain,
                   Scenario& scenario) {
  std::vector<const CheckedElement*> all;
  for (const CheckedElement& child : element.children) {
    all.push_back(&child);
    scenario.volumes.push_back(build_volume(context, child, has_terrain));
  }
  context.check_unique(all, "volume");
}

}  // namespace nadir::sim
