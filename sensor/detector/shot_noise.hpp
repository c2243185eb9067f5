#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "core/normal_pair.hpp"
#include "core/random.hpp"
#include "core/vec.hpp"

// Random counts and amplitudes, each a pure function of random bits: no state, no distribution of
// the standard library (their sequences differ from one implementation to the next).

namespace nadir::sensor {

/// Two independent standard normal numbers of two words of bits. |z| <= 8.6.
[[nodiscard]] inline Vec2 normal_pair(std::uint64_t a, std::uint64_t b) noexcept {
  return nadir::normal_pair(Vec2{to_unit(a), to_unit(b)});
}

/// Below this mean counts are drawn from the Poisson distribution by summing its terms.
inline constexpr double exact_poisson_mean = 32.0;

/// Reciprocals of the counts that sums can need: beyond 128 less than 1e-30 is left at a mean of
/// 32.
inline constexpr auto reciprocals = [] {
  std::array<double, 128> r{};
  for (std::size_t i = 1; i < r.size(); ++i) r[i] = 1.0 / static_cast<double>(i);
  return r;
}();

/// A Poisson count by inversion of the distribution function. Exact to 1e-15.
/// @param mean  in [0, exact_poisson_mean)   @param u  in [0, 1)
[[nodiscard]] inline double poisson_by_sum(double mean, double u) noexcept {
  double term = std::exp(-mean), sum = term;
  std::size_t count = 0;
  while (u >= sum && count + 1 < reciprocals.size()) {
    ++count;
    term *= mean * reciprocals[count];
    sum += term;
  }
  return static_cast<double>(count);
}

/// A Poisson count of a large mean by the asymptotic expansion of the inverse distribution function
///
///     N = floor(mean + sqrt(mean) z + (z^2 + 2) / 6 - (2 z + z^3) / (72 sqrt(mean)))
///
/// At a mean of 32, the least, its mean is right to 1e-6, its variance to 6e-6 and its third moment
/// to 0.6 % of the distribution's (from there on they improve with the mean); the count is off by
/// one in less than 3 of 1000 draws.
/// Source: Giles, ACM Trans. Math. Softw. 42(1), 7 (2016), doi:10.1145/2699466.
/// @param mean  >= exact_poisson_mean   @param z  standard normal
[[nodiscard]] inline double poisson_by_normal(double mean, double z) noexcept {
  const double root = std::sqrt(mean);
  const double count =
      std::floor(mean + root * z + (z * z + 2.0) * (1.0 / 6.0) - z * (2.0 + z * z) / (72.0 * root));
  return count > 0.0 ? count : 0.0;
}

}  // namespace nadir::sensor
