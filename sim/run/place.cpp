#include "sim/run/place.hpp"

#include "sim/files/instance_list.hpp"

namespace nadir::sim {

Affine placed(const PlacementInput& input, const TerrainProbe& terrain) {
  Placement placement{input.position_m, input.yaw_deg, input.pitch_deg,
                      input.roll_deg,   input.scale,   0};
  if (input.on_terrain) placement.position = terrain.lifted(placement.position);
  return affine(placement);
}

}  // namespace nadir::sim
