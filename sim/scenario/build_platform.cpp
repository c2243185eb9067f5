#include <fmt/format.h>

#include <algorithm>

#include "sim/scenario/build_context.hpp"

namespace nadir::sim {
namespace {

struct Place {
  std::variant<geometry::Geodetic, Vec3> where;
  bool on_terrain = false;
};

/// The place inside <position> or <look_at>; nothing after a mistake.
std::optional<Place> build_place(const BuildContext& context, const CheckedElement& element,
                                 bool has_terrain) {
  if (const CheckedElement* geodetic = element.child("geodetic")) {
    return Place{build_geodetic(*geodetic), false};
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
  return Place{position, on_terrain};
}

bool same_place(const Place& a, const Place& b, const geometry::Geodetic& origin) {
  if (a.on_terrain != b.on_terrain) return false;
  const geometry::LocalFrame frame{origin};
  const auto local = [&](const Place& place) {
    const auto* geodetic = std::get_if<geometry::Geodetic>(&place.where);
    return geodetic != nullptr ? frame.enu(*geodetic) : std::get<Vec3>(place.where);
  };
  constexpr double nearest_m = 1e-3;  // a line of sight needs a length that rounding cannot turn
  return length(local(a) - local(b)) < nearest_m;
}

void build_attitude(const BuildContext& context, const CheckedElement& attitude, bool has_terrain,
                    Scenario& scenario) {
  PlatformInput& platform = scenario.platform;
  if (const CheckedElement* euler = attitude.child("euler")) {
    platform.attitude = PlatformInput::Euler{euler->number("yaw_deg"), euler->number("pitch_deg"),
                                             euler->number("roll_deg")};
  }
  const CheckedElement* look_at = attitude.child("look_at");
  if (look_at == nullptr) return;
  const auto target = build_place(context, *look_at, has_terrain);
  if (!target) return;
  platform.attitude =
      PlatformInput::LookAt{target->where, target->on_terrain, look_at->number("roll_deg")};
  const std::size_t before = context.issues.count();
  const Place camera{platform.position, platform.on_terrain};
  // After other mistakes the numbers may be placeholders that mean nothing.
  if (before == 0 && same_place(camera, *target, scenario.origin)) {
    context.mistake(look_at->offset, "<look_at> names the place where the camera itself is");
  }
}

}  // namespace

void build_platform(const BuildContext& context, const CheckedElement& element,
                    Scenario& scenario) {
  const bool has_terrain = std::any_of(
      scenario.geometry.begin(), scenario.geometry.end(),
      [](const GeometryInput& part) { return std::holds_alternative<TerrainInput>(part); });
  scenario.platform.where = context.source.locate(element.offset);
  const CheckedElement* position = element.child("position");
  if (position != nullptr) {
    if (const auto place = build_place(context, *position, has_terrain)) {
      scenario.platform.position = place->where;
      scenario.platform.on_terrain = place->on_terrain;
    }
  }
  if (const CheckedElement* attitude = element.child("attitude")) {
    build_attitude(context, *attitude, has_terrain, scenario);
  }
}

}  // namespace nadir::sim
