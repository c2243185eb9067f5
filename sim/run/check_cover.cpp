#include <fmt/format.h>

#include <array>
#include <map>

#include "sim/run/load_maps.hpp"

namespace nadir::sim {
namespace {

using materials::MapFrame;

/// Places that are looked at, along each side of the scene.
constexpr int cover_places = 32;

/// What was seen of one map: at how many places, and at how many of them it had nothing to
/// say.
struct CoverSeen {
  int at = 0, outside = 0, without_texture = 0;
};

bool lies_outside(const MapFrame& frame, Vec2 place) {
  const Vec2 p = frame.pixels(place);
  // A hundredth of a pixel: edges of map and ground that are meant to be the same.
  const auto beyond = [](double position, int count) {
    return position < -0.01 || position > count + 0.01;
  };
  return !frame.repeats && (beyond(p.x, frame.columns) || beyond(p.y, frame.rows));
}

void look(const MapFrame& frame, const geometry::Hit& hit, CoverSeen& seen) {
  ++seen.at;
  if (frame.by == MapFrame::By::texture) {
    const bool none = hit.tangent == Vec3{} && hit.texture == Vec2{};
    seen.without_texture += none ? 1 : 0;
    if (!none && lies_outside(frame, hit.texture)) ++seen.outside;
  } else if (lies_outside(frame, {hit.position.x, hit.position.y})) {
    ++seen.outside;
  }
}

std::string text_of(const std::string& name, const CoverSeen& seen) {
  if (seen.without_texture > 0) {
    return fmt::format(
        "{} follows texture coordinates, but lies on a surface that has none: all of "
        "it shows one pixel",
        name);
  }
  return fmt::format(
      "{} does not reach as far as the surfaces that it lies on ({:.0f} % of what is "
      "seen from above is outside): its edge pixels go on there",
      name, 100.0 * seen.outside / seen.at);
}

}  // namespace

void check_cover(const Scenario& scenario, const radiometry::SceneDescription& scene,
                 Diagnostics& diagnostics) {
  std::map<std::string, CoverSeen> seen;
  const geometry::Bounds box = scene.geometry.bounds();
  const Vec3 size = box.hi - box.lo;
  for (int j = 0; j < cover_places; ++j) {
    for (int i = 0; i < cover_places; ++i) {
      const Vec3 from{box.lo.x + size.x * (i + 0.5) / cover_places,
                      box.lo.y + size.y * (j + 0.5) / cover_places, box.hi.z + 1.0};
      const auto hit = scene.geometry.intersect({from, {0.0, 0.0, -1.0}});
      if (!hit) continue;
      if (hit->material >= scene.materials.size()) {
        const std::size_t map = hit->material - scene.materials.size();
        look(scene.maps[map].frame, *hit, seen["map " + scenario.maps[map].name]);
        continue;
      }
      const materials::Material& material = scene.materials[hit->material];
      if (material.relief) {
        look(material.relief->frame, *hit, seen["the relief of material " + material.name]);
      }
      if (const MapFrame* frame = scene.temperature.map_frame(hit->material)) {
        look(*frame, *hit, seen["the raster of temperatures of material " + material.name]);
      }
    }
  }
  for (const auto& [name, what] : seen) {
    if (what.outside > 0 || what.without_texture > 0) diagnostics.warn(text_of(name, what));
  }
}

}  // namespace nadir::sim
