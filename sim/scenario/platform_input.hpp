#pragma once

#include <filesystem>
#include <variant>
#include <vector>

#include "core/error.hpp"
#include "core/vec.hpp"
#include "geometry/earth.hpp"

// What a scenario says of where its camera is and how it moves.

namespace nadir::sim {

struct LookAtInput {
  std::variant<geometry::Geodetic, Vec3> target;
  bool on_terrain = false;
  double roll_deg = 0.0;  ///< clockwise about the line of sight; 0: image top as high as it goes
};
/// Yaw clockwise from north, pitch up from the horizon (-90: straight down), roll right side down.
struct EulerInput {
  double yaw_deg = 0.0, pitch_deg = 0.0, roll_deg = 0.0;
};
struct PlatformInput {
  using LookAt = LookAtInput;
  using Euler = EulerInput;
  std::variant<geometry::Geodetic, Vec3> position;  ///< geodetic, or local east, north, up in m
  bool on_terrain = false;                          ///< local up counts from the terrain
  std::variant<LookAt, Euler> attitude;
  SourceLocation where{};
};

}  // namespace nadir::sim
