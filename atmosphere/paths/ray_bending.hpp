#pragma once

#include <optional>
#include <vector>

#include "atmosphere/paths/refractivity.hpp"
#include "atmosphere/paths/spherical_path.hpp"
#include "core/vec.hpp"

namespace nadir::atmosphere {

// Rays through air that lies in spherical shells. With mu the cosine of the local zenith angle,
//
//     dh/ds = mu,   dmu/ds = (1 - mu^2) (1 / (R + h) + d ln n / dh),
//
// which keeps n (R + h) sin(zenith) (Bouguer). Steps of Runge & Kutta's fourth order end on the
// levels, where d ln n / dh jumps.

struct BentPoint {
  Vec3 position;       ///< scene axes
  double way_m = 0.0;  ///< along the curve from the eye
};

/// A ray as a chain of straight pieces.
struct BentPath {
  std::vector<BentPoint> points;  ///< the eye first; at least two unless the reach is 0
  Vec3 end_direction;             ///< of travel, unit
};

/// How far the chain may lie from the curve: the greater of 1 cm and 1e-7 of the reach.
inline constexpr double bent_path_tolerance_m = 0.01, bent_path_tolerance_share = 1e-7;

/// The way of a ray from an eye. Scene axes, whose origin lies `ground_m` above sea level. One
/// wavelength stands for all that the ray carries.
/// @param reach_m  of way. Above the air the ray runs on straight; an infinite reach ends at the
/// top.
///                 The path ends where it comes 500 m below the ground: what it meets is the
///                 caller's to find
[[nodiscard]] BentPath bent_path(const Refractivity& air, double ground_m, Vec3 eye, Vec3 direction,
                                 double reach_m);

/// By how much the air lifts a body at infinity that *appears* in a direction: the angle between
/// that and the ray outside the air, radians, >= 0 in air that thins out upwards. Nothing where the
/// ray meets the ground.
/// Accuracy: the integration's, 2e-6 of it, 5 milliarcseconds at the limb (tested by Bouguer's
/// law).
[[nodiscard]] std::optional<double> lift_rad(const Refractivity& air, double ground_m,
                                             PathPoint eye);

}  // namespace nadir::atmosphere
