#pragma once

#include "core/vec.hpp"

namespace nadir::sim {

/// Where an object stands: scene east, north, up; rotated by yaw (clockwise about up, seen from
/// above), then pitch (nose up about the object's x axis), then roll (about its y axis), scaled.
struct PlacementInput {
  Vec3 position_m;
  double yaw_deg = 0.0, pitch_deg = 0.0, roll_deg = 0.0;
  Vec3 scale{1.0, 1.0, 1.0};
  bool on_terrain = false;  ///< up counts from the terrain below (east, north)
};

}  // namespace nadir::sim
