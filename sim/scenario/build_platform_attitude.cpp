#include <fmt/format.h>

#include <cmath>

#include "sim/scenario/build_platform.hpp"

namespace nadir::sim {
namespace {

/// Whether a target is the place where the platform stands still.
bool looks_at_itself(const PlatformInput& platform, const PlaceInput& target,
                     const geometry::Geodetic& origin) {
  if (!platform.stands_still() || platform.on_terrain != target.on_terrain) return false;
  const geometry::LocalFrame frame{origin};
  const auto local = [&](const auto& place) {
    const auto* geodetic = std::get_if<geometry::Geodetic>(&place);
    return geodetic != nullptr ? frame.enu(*geodetic) : std::get<Vec3>(place);
  };
  constexpr double nearest_m = 1e-3;  // a line of sight needs a length that rounding cannot turn
  return length(local(platform.position) - local(target.where)) < nearest_m;
}

sensor::Reference reference_of(const CheckedElement& element) {
  const auto name = element.value<std::string>("reference");
  if (name == "earth") return sensor::Reference::earth;
  if (name == "local") return sensor::Reference::local;
  return name == "orbit" ? sensor::Reference::orbit : sensor::Reference::scene;
}

QuaternionInput quaternion_of(const BuildContext& context, const CheckedElement& element) {
  const auto w = element.find<double>("w"), x = element.find<double>("x"),
             y = element.find<double>("y"), z = element.find<double>("z");
  if (!w || !x || !y || !z) return {};
  constexpr double slack = 1e-3;  // of the length: more is no rounding
  const Quaternion q{*w, *x, *y, *z};
  const double norm = std::hypot(std::hypot(q.w, q.x), std::hypot(q.y, q.z));
  if (!(std::abs(norm - 1.0) <= slack)) {
    context.mistake(element.offset,
                    fmt::format("<quaternion> has length {:.6g}, expected 1 within 0.001", norm));
    return {};
  }
  return {reference_of(element), {q.w / norm, q.x / norm, q.y / norm, q.z / norm}};
}

sensor::TrackAttitude track_attitude_of(const CheckedElement& element) {
  using Aim = sensor::TrackAttitude::Aim;
  return {element.type->name == "nadir" ? Aim::nadir : Aim::velocity, element.flag("inertial"),
          degrees(element.number("yaw_deg")), degrees(element.number("pitch_deg")),
          degrees(element.number("roll_deg"))};
}

AttitudeInput attitude_of(const BuildContext& context, const CheckedElement& element) {
  const std::string& kind = element.type->name;
  if (kind == "euler") {
    return EulerInput{element.number("yaw_deg"), element.number("pitch_deg"),
                      element.number("roll_deg")};
  }
  if (kind == "quaternion") return quaternion_of(context, element);
  if (kind == "attitude_table") {
    return AttitudeTableInput{element.value<std::filesystem::path>("file"), reference_of(element),
                              element.find<double>("max_gap_s")};
  }
  return track_attitude_of(element);
}

/// What follows the way needs one.
void check_way(const BuildContext& context, const CheckedElement& element,
               const PlatformInput& platform) {
  const std::string& kind = element.type->name;
  const bool follows = kind == "nadir" || kind == "velocity";
  const bool in_orbit = element.value<std::string>("reference") == "orbit";
  if (!platform.stands_still() || !(follows || in_orbit)) return;
  if (context.issues.count() > 0) return;  // the position may have been refused
  context.mistake(
      in_orbit ? element.where("reference") : element.offset,
      fmt::format("<{}> follows the platform's way, but the platform stands still", kind),
      "a camera that stands still looks by <look_at> or <euler>");
}

}  // namespace

void PlatformBuilder::build_attitude(const CheckedElement& attitude,
                                     const geometry::Geodetic& origin,
                                     PlatformInput& platform) const {
  const CheckedElement* element = only_child(attitude);
  if (element == nullptr) return;
  platform.attitude_where = context.source.locate(element->offset);
  if (element->type->name != "look_at") {
    platform.attitude = attitude_of(context, *element);
    check_way(context, *element, platform);
    return;
  }
  const auto target = build_place(*element);
  if (!target) return;
  platform.attitude = LookAtInput{target->where, target->on_terrain, element->number("roll_deg")};
  // After other mistakes the numbers may be placeholders that mean nothing.
  if (context.issues.count() == 0 && looks_at_itself(platform, *target, origin)) {
    context.mistake(element->offset, "<look_at> names the place where the camera itself is");
  }
}

}  // namespace nadir::sim
