#include "sim/run/terrain_probe.hpp"

#include <fmt/format.h>

#include "core/error.hpp"

namespace nadir::sim {

Vec3 TerrainProbe::lifted(Vec3 place) const {
  if (!terrain_) throw InputError{"a height counts from the terrain, but there is no terrain"};
  const double top = terrain_->bounds().hi.z + 1.0;
  const auto hit = terrain_->intersect({{place.x, place.y, top}, {0.0, 0.0, -1.0}});
  if (!hit) {
    throw InputError{fmt::format(
        "{:.3f} m east, {:.3f} m north lies outside the terrain that its height counts from",
        place.x, place.y)};
  }
  return {place.x, place.y, hit->position.z + place.z};
}

}  // namespace nadir::sim
