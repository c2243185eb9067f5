#include "materials/maps/material_map.hpp"

#include <algorithm>

namespace nadir::materials {

std::uint32_t MaterialMap::at(Vec2 place, double u) const noexcept {
  const std::size_t pixel = frame.pixel_at(frame.pixels(place));
  if (!choice.empty()) return materials[choice[pixel]];
  const std::size_t layers = materials.size();
  const float* const first = cumulative.data() + pixel * layers;
  const auto drawn = static_cast<float>(u);
  // Materials are few and most pixels have one or two, so a walk is as quick as a search. A layer
  // without a share ends where it begins and is passed over. A number below 1 may round to 1 in
  // float, which no sum exceeds: it belongs to the first layer that reaches the end.
  const float* const found =
      std::find_if(first, first + layers, [&](float end) { return drawn < end || end >= 1.0F; });
  return materials[std::min(static_cast<std::size_t>(found - first), layers - 1)];
}

}  // namespace nadir::materials
