#include "sim/run/temperature_at.hpp"

#include <fmt/format.h>

#include "core/error.hpp"
#include "sim/run/world.hpp"
#include "sim/scenario/read_scenario.hpp"

namespace nadir::sim {
namespace {

geometry::Hit surface_at(const World& world, const PlaceQuestion& question) {
  const geometry::Bounds box = world.scene.geometry.bounds();
  const Vec3 from{question.east_m, question.north_m, question.up_m.value_or(box.hi.z + 1.0)};
  auto hit = world.scene.geometry.intersect({from, question.direction});
  if (!hit) {
    throw InputError{fmt::format(
        "nothing of the scene lies {} east {} m, north {} m, up {:.1f} m; it reaches from "
        "({:.0f}, {:.0f}, {:.0f}) to ({:.0f}, {:.0f}, {:.0f}) m",
        question.direction.z < -0.999 ? "below" : "along the look from", from.x, from.y, from.z,
        box.lo.x, box.lo.y, box.lo.z, box.hi.x, box.hi.y, box.hi.z)};
  }
  // Where a map mixes materials at random, one draw stands for the place.
  constexpr std::uint64_t draw = 0x706C616365;  // "place"
  radiometry::resolve_map(world.scene, *hit, Sampler{draw, 0});
  return *hit;
}

std::string object_name(const Scenario& scenario, std::uint32_t object) {
  if (object >= scenario.geometry.size()) return "lamp";
  return std::visit([](const auto& named) { return named.name; }, scenario.geometry[object]);
}

}  // namespace

TemperatureAt temperature_at(const std::filesystem::path& file, const PlaceQuestion& question) {
  Diagnostics diagnostics;
  InputFiles inputs;
  Scenario scenario = read_scenario(file, diagnostics);
  scenario.products.truth_temperature = true;  // whatever the camera sees
  const World world = load_world(scenario, inputs, diagnostics);
  const geometry::Hit hit = surface_at(world, question);
  TemperatureAt found;
  found.title = scenario.title.empty() ? scenario.name : scenario.title;
  found.time = scenario.time;
  found.place = hit.position;
  found.normal = hit.normal;
  found.object = object_name(scenario, hit.object);
  found.material = world.scene.materials[hit.material].name;
  found.temperature = world.scene.temperature.at(hit);
  if (world.scene.temperature.solved(hit.material)) {
    found.heat = world.heat->model().materials[hit.material];
    found.record = world.heat->record(hit);
  }
  found.warnings = diagnostics.messages();
  return found;
}

}  // namespace nadir::sim
