#pragma once

#include <optional>

#include "core/vec.hpp"

namespace nadir::sensor {

/// Radial and tangential distortion of a lens (Brown-Conrady), of coordinates x, y on the focal
/// plane divided by the focal length, r2 = x^2 + y^2, from ideal to distorted:
///
///     x' = x (1 + k1 r2 + k2 r2^2 + k3 r2^3) + 2 p1 x y + p2 (r2 + 2 x^2)
///     y' = y (1 + k1 r2 + k2 r2^2 + k3 r2^3) + p1 (r2 + 2 y^2) + 2 p2 x y
///
/// x to image right, y to image down. Order of the coefficients in files: k1, k2, p1, p2, k3.
/// Source: D. C. Brown, Photogrammetric Engineering 32(3), 444 (1966), in the form that OpenCV and
/// the Community Sensor Model's `radtan` use.
struct Distortion {
  double k1 = 0.0, k2 = 0.0, p1 = 0.0, p2 = 0.0, k3 = 0.0;

  [[nodiscard]] bool is_none() const noexcept {
    return k1 == 0.0 && k2 == 0.0 && p1 == 0.0 && p2 == 0.0 && k3 == 0.0;
  }
};

[[nodiscard]] Vec2 distorted(const Distortion& lens, Vec2 ideal) noexcept;

/// The ideal place of a distorted one: Newton's method to 1e-13. Fast: called for every ray.
/// @param place  within the radius that `check` has passed
[[nodiscard]] Vec2 undistorted(const Distortion& lens, Vec2 place) noexcept;

/// @param reach  greatest distance from the axis that pixels have, over the focal length
/// @throws InputError where the distortion folds the image over itself within that reach
void check(const Distortion& lens, double reach);

}  // namespace nadir::sensor
