#pragma once

#include <optional>

#include "geometry/scene.hpp"

namespace nadir::sim {

/// Finds the terrain's height below a place in scene axes.
class TerrainProbe {
 public:
  TerrainProbe() = default;  ///< no terrain: every question is an error
  explicit TerrainProbe(geometry::Scene terrain) : terrain_{std::move(terrain)} {}

  /// The place with its `z` counted from the terrain at its (x, y).
  /// @throws InputError where there is no terrain below
  [[nodiscard]] Vec3 lifted(Vec3 place) const;

 private:
  std::optional<geometry::Scene> terrain_;
};

}  // namespace nadir::sim
