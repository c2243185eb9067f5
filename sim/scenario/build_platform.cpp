#include "sim/scenario/build_platform.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace nadir::sim {

std::optional<PlaceInput> PlatformBuilder::build_place(const CheckedElement& element) const {
  if (const CheckedElement* geodetic = element.child("geodetic")) {
    return PlaceInput{build_geodetic(*geodetic), false};
  }
  const CheckedElement* local = element.child("local");
  if (local == nullptr) return std::nullopt;
  const Vec3 position{local->number("east_m"), local->number("north_m"), local->number("up_m")};
  const bool on_terrain = local->flag("on_terrain");
  if (on_terrain && !has_terrain) {
    context.mistake(local->where("on_terrain"),
                    fmt::format("<local> of <{}> counts from the terrain, but <geometry> has no "
                                "<terrain>",
                                element.type->name));
  }
  return PlaceInput{position, on_terrain};
}

void build_platform(const BuildContext& context, const CheckedElement& element,
                    Scenario& scenario) {
  const bool has_terrain = std::any_of(
      scenario.geometry.begin(), scenario.geometry.end(),
      [](const GeometryInput& part) { return std::holds_alternative<TerrainInput>(part); });
  const PlatformBuilder builder{context, has_terrain};
  PlatformInput& platform = scenario.platform;
  platform.where = context.source.locate(element.offset);
  platform.position_where = platform.attitude_where = platform.where;
  platform.name = element.value<std::string>("name");
  if (const CheckedElement* position = element.child("position")) {
    builder.build_position(*position, platform);
  }
  if (const CheckedElement* attitude = element.child("attitude")) {
    builder.build_attitude(*attitude, scenario.origin, platform);
  }
  if (const CheckedElement* jitter = element.child("jitter")) {
    platform.jitter = builder.build_jitter(*jitter);
  }
  if (const CheckedElement* mounts = element.child("mounts")) {
    platform.mounts = builder.build_mounts(*mounts);
  }
}

}  // namespace nadir::sim
