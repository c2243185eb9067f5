#include <fmt/format.h>

#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <variant>

#include "core/transform.hpp"
#include "sim/run/error_list.hpp"
#include "sim/run/load_lamps.hpp"

namespace nadir::sim {
namespace {

/// Faces and corners of a cube, turned a little so that none runs along the edges and diagonals of
/// a box.
std::array<Vec3, 14> directions() {
  const Mat3 turn = rotation(normalised({0.36, 0.48, 0.8}), 0.2);
  std::array<Vec3, 14> all;
  std::size_t n = 0;
  for (const double s : {-1.0, 1.0}) {
    for (const Vec3 v : {Vec3{s, 0, 0}, Vec3{0, s, 0}, Vec3{0, 0, s}, Vec3{s, 1, 1}, Vec3{s, 1, -1},
                         Vec3{s, -1, 1}, Vec3{s, -1, -1}}) {
      all[n++] = turn * normalised(v);
    }
  }
  return all;
}

/// Where the light that goes into `direction` starts; none where the lamp sends none there.
std::optional<Vec3> start(const radiometry::Lamp& lamp, Vec3 direction) {
  if (const auto* point = std::get_if<radiometry::PointLamp>(&lamp.form)) return point->position;
  const auto& area = std::get<radiometry::AreaLamp>(lamp.form);
  const auto beyond = [](double size) { return 1e-3 * size; };  // off the lamp's own surface
  if (const auto* sphere = std::get_if<geometry::Sphere>(&area.surface)) {
    return area.centre + (sphere->radius + beyond(sphere->radius)) * direction;
  }
  const Vec3 normal = cross(area.axis_x, area.axis_y);
  if (dot(normal, direction) < 0.1) return std::nullopt;
  const auto* disc = std::get_if<geometry::Disc>(&area.surface);
  const double size =
      disc != nullptr ? disc->radius : std::get<geometry::Plane>(area.surface).size_x;
  return area.centre + beyond(size) * normal;
}

bool lets_light_through(const MaterialInput& material) {
  if (material.transmittance) return true;
  if (std::holds_alternative<ClearSheetInput>(material.scattering)) return true;
  if (const auto* facets = std::get_if<MicrofacetInput>(&material.scattering)) {
    return facets->transmits;
  }
  if (const auto* mixture = std::get_if<MixtureInput>(&material.scattering)) {
    for (const auto& part : mixture->parts) {
      if (part.material && lets_light_through(*part.material)) return true;
    }
  }
  return false;
}

/// What rays from a lamp meet.
struct Surroundings {
  int rays = 0;     ///< sent out
  int behind = 0;   ///< met the back of something opaque
  int front = 0;    ///< met a front, or something that light passes
  int terrain = 0;  ///< of those behind
  std::uint32_t object = 0;
};

class LampChecker {
 public:
  LampChecker(const geometry::Scene& scene, const Scenario& scenario, Diagnostics& diagnostics)
      : scene_{&scene}, scenario_{&scenario}, diagnostics_{&diagnostics} {}

  void check(const radiometry::Lamp& lamp) const {
    constexpr int suspicious = 4;  // fewer may be leaves that happen to turn away
    const Surroundings seen = look_around(lamp);
    if (seen.front > 0 || seen.behind < suspicious) return;
    const std::string name = name_of(seen.object);
    const std::string& who = lamp.name;
    if (seen.terrain == seen.behind) {
      throw error(lamp, fmt::format("lamp {} is buried: it lies below {}", who, name));
    }
    if (seen.behind == seen.rays) {
      throw error(lamp, fmt::format("lamp {} is inside {}, an opaque solid that shuts its light in",
                                    who, name));
    }
    diagnostics_->warn(
        fmt::format("lamp {} sees only the back of {}: does it stand inside?", who, name));
  }

 private:
  [[nodiscard]] Surroundings look_around(const radiometry::Lamp& lamp) const {
    static const std::array<Vec3, 14> around = directions();
    Surroundings seen;
    for (const Vec3& direction : around) {
      const auto from = start(lamp, direction);
      if (!from) continue;
      ++seen.rays;
      const auto hit = scene_->intersect({*from, direction});
      if (!hit) continue;
      if (!hit->back_face || is_clear(*hit)) {
        ++seen.front;
        continue;
      }
      ++seen.behind;
      if (is_terrain(hit->object)) ++seen.terrain;
      seen.object = hit->object;
    }
    return seen;
  }

  [[nodiscard]] bool is_clear(const geometry::Hit& hit) const {
    const auto& materials = scenario_->materials;
    return hit.material < materials.size() && lets_light_through(materials[hit.material]);
  }
  [[nodiscard]] bool is_terrain(std::uint32_t object) const {
    const auto& objects = scenario_->geometry;
    return object < objects.size() && std::holds_alternative<TerrainInput>(objects[object]);
  }
  [[nodiscard]] std::string name_of(std::uint32_t object) const {
    if (object >= scenario_->geometry.size()) return "another lamp";
    return fmt::format("object \"{}\"", std::visit([](const auto& named) { return named.name; },
                                                   scenario_->geometry[object]));
  }
  static InputError error(const radiometry::Lamp& lamp, std::string message) {
    return InputError{InputIssue{lamp.where, std::move(message), {}, {}}};
  }

  const geometry::Scene* scene_;
  const Scenario* scenario_;
  Diagnostics* diagnostics_;
};

}  // namespace

void check_lamps(const geometry::Scene& scene, const Scenario& scenario,
                 const std::vector<radiometry::Lamp>& lamps, Diagnostics& diagnostics) {
  const LampChecker checker{scene, scenario, diagnostics};
  ErrorList errors;
  for (const radiometry::Lamp& lamp : lamps) errors.attempt([&] { checker.check(lamp); });
  errors.throw_if_any();
}

}  // namespace nadir::sim
