#pragma once

#include <cstdint>

#include "core/vec.hpp"

namespace nadir {

/// Point `index` of the first two Sobol dimensions, nested-uniform (Owen) scrambled and shuffled
/// by `key`. Any power-of-two prefix of an aligned block is a (0, m, 2)-net in base 2.
///
/// @param index  0 .. 2^32 - 1
/// @param key    any 64 bits: independent scramblings
/// @return       coordinates in [0, 1), 32 bits of resolution
/// Source: Burley, "Practical Hash-based Owen Scrambling", JCGT 9(4), 2020; the hash is Vegdahl's
/// improved Laine-Karras permutation (2021). Tested against the net property.
[[nodiscard]] Vec2 scrambled_sobol_2d(std::uint32_t index, std::uint64_t key) noexcept;
/// The first coordinate of that point alone, for half the work.
[[nodiscard]] double scrambled_sobol_1d(std::uint32_t index, std::uint64_t key) noexcept;

}  // namespace nadir
