#pragma once

#include <cstddef>
#include <vector>

#include "atmosphere/make/direction_grid.hpp"

namespace nadir::atmosphere {

/// One end of a step along a path.
struct StepEnd {
  double top = 0.0;  ///< share of the layer's upper edge in this height; of the lower: 1 - top
  MuWeights travel;  ///< direction in which the light seen travels here
  /// Sine and cosine of the arc from the path's anchor to here: a body at zenith angle z0 over the
  /// anchor and azimuth phi from the path stands at mu0 = away sin(z0) cos(phi) + up cos(z0) here.
  double away = 0.0, up = 1.0;
};

/// A piece of a path within one layer, short enough for its source to run evenly.
struct PathStep {
  int layer = 0;
  double slant = 0.0;  ///< length over the layer's thickness
  StepEnd in, out;
  int share = -1;  ///< the node of share that ends here
};

/// A line of sight, cut into steps, all that does not depend on wavelength.
struct ViewPath {
  double zenith_rad = 0.0;  ///< of the direction looked in, at the start
  /// Arc about the earth's centre from the start to the anchor, the place that the scene's bodies
  /// stand over. From the top of the air, where the eye may be anywhere above, that is what is
  /// looked at: the path's end on the ground, or its lowest point. From within the air, near the
  /// scene, it is the start.
  double anchor_rad = 0.0;
  bool meets_ground = false;
  double measure_m = 0.0;  ///< of the whole way
  int start_layer = 0;
  double start_density = 1.0;      ///< measure per metre where it starts
  double start_thickness_m = 1.0;  ///< of the layer there
  StepEnd start;
  std::size_t empty_shares = 0;  ///< nodes of share, the first ones, that lie at the start
  std::vector<PathStep> steps;

  /// Zenith angle of the same direction over the anchor, where the bodies' places are given.
  [[nodiscard]] double scene_zenith_rad() const noexcept { return zenith_rad - anchor_rad; }
};

/// The air's shells that paths run through.
struct Shells {
  std::vector<double> level_m;  ///< descending
  DirectionGrid directions;

  [[nodiscard]] double top_m() const { return level_m.front(); }
  [[nodiscard]] double ground_m() const { return level_m.back(); }
};

/// Which side of the horizon a direction exactly on it belongs to.
enum class Side { above, below };

[[nodiscard]] ViewPath view_path(const Shells& shells, double height_m, double zenith_rad,
                                 Side side, const std::vector<double>& shares);

/// Zenith angles for a height: `nodes` on either side of its horizon, denser towards it; the
/// horizon twice. From the top of the air, where nothing lies above the level line, the nodes above
/// the horizon but one lie below that line.
struct ZenithAxis {
  std::vector<double> above, below;  ///< ascending; above ends and below begins on the horizon
};
[[nodiscard]] ZenithAxis zenith_axis(const Shells& shells, double height_m, int nodes);

/// Shares of a way, 0 to 1: denser where what is seen lies, near the eye for one near the ground,
/// near the ground for one high up.
[[nodiscard]] std::vector<double> share_axis(const Shells& shells, double height_m, int nodes);

}  // namespace nadir::atmosphere
