#pragma once

#include <cstdint>

namespace nadir {

/// Mixes a counter into a key: a bijection of 64 bits for each key with good avalanche.
/// Source: finaliser of SplitMix64, Stafford's variant 13 (Steele, Lea, Flood, OOPSLA 2014).
[[nodiscard]] constexpr std::uint64_t mix(std::uint64_t key, std::uint64_t counter) noexcept {
  std::uint64_t z = key + 0x9E3779B97F4A7C15ULL * (counter + 1);
  z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ULL;
  z = (z ^ (z >> 27)) * 0x94D049BB133111EBULL;
  return z ^ (z >> 31);
}

/// The upper 53 bits as a double in [0, 1).
[[nodiscard]] constexpr double to_unit(std::uint64_t bits) noexcept {
  return static_cast<double>(bits >> 11) * 0x1.0p-53;
}

/// Counter-based random numbers: number n of stream `key` is a pure function of (key, n).
/// Used where numbers are drawn in sequence (tests, set-up); rays use core/sampler.hpp.
class Rng {
 public:
  constexpr explicit Rng(std::uint64_t seed, std::uint64_t stream = 0) noexcept
      : key_{mix(mix(0, seed), stream)} {}
  constexpr std::uint64_t next_bits() noexcept { return mix(key_, counter_++); }
  constexpr double next() noexcept { return to_unit(next_bits()); }  ///< uniform in [0, 1)

 private:
  std::uint64_t key_;
  std::uint64_t counter_ = 0;
};

}  // namespace nadir
