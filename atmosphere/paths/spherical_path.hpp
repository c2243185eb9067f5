#pragma once

#include <vector>

#include "core/vec.hpp"

namespace nadir::atmosphere {

/// Mean radius of the earth, m (IUGG R1); the air's shells are spheres about its centre.
inline constexpr double earth_radius_m = 6371008.8;

// Straight lines over a sphere. With r the distance from the earth's centre and t = r mu the signed
// way from the line's lowest point, r^2 - t^2 is the same all along. Everything here is written in
// differences of r^2, (h - h0) (2 R + h + h0), and of roots as their quotients, so that nothing
// cancels: neither for a vertical way nor for one that grazes a level, from 1 mm to 36,000 km.

/// A place on a straight line, and how steeply the line passes it.
struct PathPoint {
  double height_m = 0.0;  ///< above sea level
  double mu = 0.0;        ///< cosine of the local zenith angle of the direction of travel
};

/// The point at a way from another. Relative error of the height's change below 1e-14.
[[nodiscard]] PathPoint advanced(PathPoint start, double way_m) noexcept;

/// Way to where a line that goes down first reaches a height at or below its start; negative if it
/// never does (or goes up).
[[nodiscard]] double way_down_to_m(PathPoint start, double height_m) noexcept;
/// Way to where a line finally rises through a height; negative if it lies above that all along or
/// leaves it at once.
[[nodiscard]] double way_up_to_m(PathPoint start, double height_m) noexcept;
/// Cosine of the zenith angle of the horizon from a height: directions with a lower one meet the
/// ground. 0 on the ground and below it.
[[nodiscard]] double horizon_mu(double ground_m, double height_m) noexcept;

/// A straight line through the shells between levels: which layer it crosses, for how long and how
/// steeply. Pieces come in order from the start; where the line has its lowest point inside a
/// layer, it is cut there too, so that height is monotonic along every piece. None has length 0.
struct PathPiece {
  int layer = 0;
  double length_m = 0.0;
  double height_in_m = 0.0, height_out_m = 0.0;  ///< of the piece's ends, above sea level
  double mu_in = 0.0, mu_out = 0.0;  ///< cosine of the local zenith angle of the direction away
                                     ///< from the start, at both ends
  double start_m = 0.0;              ///< way from the start to the piece's first end
};

/// @param level_height_m  descending; the path is cut where it leaves the top or meets the last
/// @param height_m        of the start, within the levels; on a level the line begins in the layer
///                        that it goes into. A level line (mu = 0) goes up.
/// @param mu              cosine of the zenith angle at the start
/// @param length_m        of the way, may be infinite
[[nodiscard]] std::vector<PathPiece> path_through(const std::vector<double>& level_height_m,
                                                  double height_m, double mu, double length_m);

/// Way from a start to where it leaves the air (or meets the ground, a sphere through the last
/// level), m. 0 at the ground (or below it) going down, at the top going up, and where a line from
/// above the top misses the air.
[[nodiscard]] double way_to_end_m(double top_m, double ground_m, double height_m,
                                  double mu) noexcept;

/// Optical depth of the way from each level out to a body at a zenith angle (cosine mu0 at the
/// ground level, and so at all levels above it): infinite where the earth is in the way. mu0 may be
/// below 0.
[[nodiscard]] std::vector<double> slant_depths(const std::vector<double>& level_height_m,
                                               const std::vector<double>& layer_depth, double mu0);

}  // namespace nadir::atmosphere
