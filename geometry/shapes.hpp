#pragma once

#include <variant>

#include "core/vec.hpp"

namespace nadir::geometry {

/// Shapes without a mesh. Lengths in metres, in the axes of the object that holds them.
struct Sphere {
  Vec3 centre;
  double radius = 1.0;
};
struct Disc {
  Vec3 centre;
  Vec3 normal{0.0, 0.0, 1.0};
  double radius = 1.0;
};
struct Box {
  Vec3 lo, hi;
};
/// A rectangle in the plane z = centre.z, sides along x and y.
struct Plane {
  Vec3 centre;
  double size_x = 1.0, size_y = 1.0;
};
/// Open at both ends unless capped.
struct Cylinder {
  Vec3 base, top;
  double radius = 1.0;
  bool capped = false;
};

using Shape = std::variant<Sphere, Disc, Box, Plane, Cylinder>;

}  // namespace nadir::geometry
