#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/vec.hpp"

namespace nadir::materials {

/// Both directions on one side of the surface: an opaque model scatters only then.
[[nodiscard]] inline bool on_one_side(Vec3 wi, Vec3 wo) noexcept { return wi.z * wo.z > 0.0; }

/// Density |cos| / pi on one side of the surface, drawn after Malley: a uniform point of the disc,
/// lifted to the hemisphere. The result lies on the side of `toward_z`.
[[nodiscard]] inline Vec3 draw_cosine(Vec2 u, double toward_z) noexcept {
  const double radius = std::sqrt(u.x), azimuth = 2.0 * std::numbers::pi * u.y;
  const double z = std::sqrt(1.0 - u.x);  // u.x < 1: never 0
  return {radius * std::cos(azimuth), radius * std::sin(azimuth), std::copysign(z, toward_z)};
}
[[nodiscard]] inline double cosine_pdf(Vec3 wi) noexcept {
  return std::abs(wi.z) * std::numbers::inv_pi;
}

/// Stretches the part [first, first + width) of [0, 1) to the whole, for a number that has chosen
/// between cases and is used again within the case chosen.
[[nodiscard]] inline double reused(double choice, double first, double width) noexcept {
  constexpr double below_one = 1.0 - 0x1.0p-53;
  return std::clamp((choice - first) / width, 0.0, below_one);
}

}  // namespace nadir::materials
