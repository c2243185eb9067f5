#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <variant>

#include "core/error.hpp"
#include "core/vec.hpp"
#include "geometry/shapes.hpp"
#include "sim/scenario/spectral_input.hpp"

// Lamps as a scenario describes them: plain data, files named but not yet read.

namespace nadir::sim {

/// Alike in all directions, or as a photometric file says.
struct PointLampInput {
  std::optional<std::filesystem::path> ies;
};
struct SpotLampInput {
  double half_angle_deg = 90.0;
  double cosine_power = 0.0;
};
struct AreaLampInput {
  /// In the lamp's own axes: z towards where it shines, x towards its azimuth.
  std::variant<geometry::Disc, geometry::Plane, geometry::Sphere> surface;
  int material = 0;
};

struct LampInput {
  std::string name;
  SourceLocation where;
  Vec3 position_m;
  bool on_terrain = false;
  Vec3 axis{0.0, 0.0, -1.0};  ///< unit; where it shines, unless `aim_m` says
  std::optional<Vec3> aim_m;  ///< the place that it shines at
  double yaw_deg = 0.0;       ///< azimuth of its side, clockwise from north
  std::variant<PointLampInput, SpotLampInput, AreaLampInput> form;
  /// Either flux in W um^-1, or lumens and a colour temperature; lumens may also come from the
  /// form's photometric file, and both from the list.
  std::optional<SpectralInput> flux;
  std::optional<double> lumens;
  std::optional<double> colour_temperature_k;
  /// Places that lamp once for every row; its own position, axis and aim are then in the row's
  /// axes.
  std::optional<std::filesystem::path> list;
};

}  // namespace nadir::sim
