#pragma once
// Private to this folder: loops over lanes, in whole groups of eight so that they vectorise without
// a remainder.

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "spectral/lanes.hpp"

namespace nadir::atmosphere {

inline constexpr std::size_t lane_group = 8;

/// Lanes in whole groups.
[[nodiscard]] constexpr std::size_t padded_lanes(std::size_t lanes) noexcept {
  return (lanes + lane_group - 1) / lane_group * lane_group;
}

struct LaneBuffer {
  alignas(64) std::array<float, spectral::lane_capacity> value;
};

/// Rows of lanes and their weights: N corners of a cell of a table.
template <std::size_t N>
struct Corners {
  std::array<const float*, N> row;
  std::array<float, N> weight;
};

template <std::size_t N>
[[nodiscard]] inline Corners<2 * N> both(const Corners<N>& a, const Corners<N>& b) noexcept {
  Corners<2 * N> all;
  for (std::size_t k = 0; k < N; ++k) {
    all.row[k] = a.row[k];
    all.row[N + k] = b.row[k];
    all.weight[k] = a.weight[k];
    all.weight[N + k] = b.weight[k];
  }
  return all;
}

/// out = or += sum of weight * row over n lanes.
template <bool add, std::size_t N>
inline void mix(float* __restrict out, const Corners<N>& c, std::size_t n) noexcept {
  for (std::size_t i = 0; i < n; ++i) {
    float sum = c.weight[0] * c.row[0][i];
    for (std::size_t k = 1; k < N; ++k) sum += c.weight[k] * c.row[k][i];
    out[i] = add ? out[i] + sum : sum;
  }
}

/// out += (sum of weight * row) * (sum of weight * row)
template <std::size_t N>
inline void mix_product(float* __restrict out, const Corners<N>& a, const Corners<2>& b,
                        std::size_t n) noexcept {
  for (std::size_t i = 0; i < n; ++i) {
    float sum = a.weight[0] * a.row[0][i];
    for (std::size_t k = 1; k < N; ++k) sum += a.weight[k] * a.row[k][i];
    out[i] += sum * (b.weight[0] * b.row[0][i] + b.weight[1] * b.row[1][i]);
  }
}

// Floats that are not negative rank as their bits do. Said so, g++ vectorises these; the plain
// comparison it turns into branches.
[[nodiscard]] inline float least_of_positive(float a, float b) noexcept {
  return std::bit_cast<float>(
      std::min(std::bit_cast<std::int32_t>(a), std::bit_cast<std::int32_t>(b)));
}
[[nodiscard]] inline float positive_part(float a) noexcept {
  return std::bit_cast<float>(std::max(std::bit_cast<std::int32_t>(a), std::int32_t{0}));
}

/// exp(-x) and 1 - exp(-x), both to a relative 3e-7, for x >= 0; from 87 on as at 87, where the
/// first is 1.6e-38. With -x = n ln 2 + r, n whole and |r| <= ln 2 / 2, exp(-x) = 2^n exp(r);
/// exp(r) - 1 by its Taylor series to r^7 / 7!, whose rest is below 2e-8 of r.
struct Decay {
  float left, lost;
};
[[nodiscard]] inline Decay decay(float x) noexcept {
  constexpr float per_ln2 = 1.44269504F, ln2_hi = 0.693359375F, ln2_lo = -2.12194440e-4F;
  constexpr float rounds = 12582912.0F;  // 1.5 * 2^23: what is added to it becomes whole
  const float capped = least_of_positive(x, 87.0F);
  const float shifted = rounds - capped * per_ln2;
  const float n = shifted - rounds;  // -(x / ln 2), rounded
  const float r = (-capped - n * ln2_hi) - n * ln2_lo;
  const float grown =
      r * (1.0F +
           r * (1.0F / 2 +
                r * (1.0F / 6 + r * (1.0F / 24 + r * (1.0F / 120 + r * (1.0F / 720 + r / 5040))))));
  // 2^n: the low bits of `shifted` are n in two's complement
  const auto power_bits = (std::bit_cast<std::uint32_t>(shifted) << 23U) + 0x3F800000U;
  const float power = std::bit_cast<float>(power_bits);
  return {power + power * grown, (1.0F - power) - power * grown};
}

}  // namespace nadir::atmosphere
