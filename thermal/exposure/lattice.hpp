#pragma once

#include <cstdint>

#include "core/vec.hpp"

// Private to this folder: points at even steps round the unit square. Begun at a random point each
// of them is uniform, and they cost a tenth of scrambled Sobol points, which are better where the
// number is large or the dimensions are many.

namespace nadir::thermal {

/// Steps for any number of points of the plane.
/// Source: M. Roberts, "The unreasonable effectiveness of quasirandom sequences" (2018): 1 / p and
/// 1 / p^2, p^3 = p + 1.
inline constexpr Vec2 plane_step{0.7548776662466927, 0.5698402909980532};
/// With 1 / n along the other axis n points are a lattice like Fibonacci's (n = 8 has its 5 / 8).
inline constexpr double golden_step = 0.6180339887498949;  // (sqrt(5) - 1) / 2
/// For points that go with those: fractions of the square roots of 2, 3 and of 5, 7. Source: R. D.
/// Richtmyer, LA-1342 (1951).
inline constexpr Vec2 roots_step{0.41421356237309515, 0.7320508075688772};
inline constexpr Vec2 next_roots_step{0.2360679774997898, 0.6457513110645906};

/// Point `number` of those that begin at `first`, in [0, 1)^2.
[[nodiscard]] inline Vec2 stepped(Vec2 first, Vec2 step, std::uint32_t number) noexcept {
  // Of what is not negative the integer part is the floor, without a call.
  const auto fraction = [](double x) { return x - static_cast<double>(static_cast<long long>(x)); };
  return {fraction(first.x + number * step.x), fraction(first.y + number * step.y)};
}

}  // namespace nadir::thermal
