#include "core/sobol.hpp"

#include "core/random.hpp"

namespace nadir {
namespace {

constexpr std::uint32_t reversed(std::uint32_t v) noexcept {
  v = ((v >> 1) & 0x55555555U) | ((v & 0x55555555U) << 1);
  v = ((v >> 2) & 0x33333333U) | ((v & 0x33333333U) << 2);
  v = ((v >> 4) & 0x0F0F0F0FU) | ((v & 0x0F0F0F0FU) << 4);
  v = ((v >> 8) & 0x00FF00FFU) | ((v & 0x00FF00FFU) << 8);
  return (v >> 16) | (v << 16);
}

/// Owen scrambling of a bit-reversed number: every output bit depends only on lower input bits.
constexpr std::uint32_t permuted_from_low_bits(std::uint32_t v, std::uint32_t seed) noexcept {
  v ^= v * 0x3D20ADEAU;
  v += seed;
  v *= (seed >> 16) | 1U;
  v ^= v * 0x05526C56U;
  v ^= v * 0x53A22864U;
  return v;
}

/// Second Sobol coordinate of an index, bit-reversed. Its digit j after the binary point is the
/// sum over i of binomial(i, j) times bit i of the index, modulo 2. The binomial is odd where the
/// bits of j are among those of i (Lucas), so five xor-shifts replace 32 table rows.
constexpr std::uint32_t second_dimension(std::uint32_t index) noexcept {
  std::uint32_t v = index;
  v ^= (v & 0xAAAAAAAAU) >> 1;
  v ^= (v & 0xCCCCCCCCU) >> 2;
  v ^= (v & 0xF0F0F0F0U) >> 4;
  v ^= (v & 0xFF00FF00U) >> 8;
  v ^= (v & 0xFFFF0000U) >> 16;
  return v;
}

constexpr double unit_from_reversed(std::uint32_t v) noexcept {
  return static_cast<double>(reversed(v)) * 0x1.0p-32;
}

/// The index as the key shuffles it. The first Sobol coordinate is the bit-reversed index.
constexpr std::uint32_t shuffled_index(std::uint32_t index, std::uint64_t a) noexcept {
  return reversed(permuted_from_low_bits(reversed(index), static_cast<std::uint32_t>(a)));
}

constexpr double first_coordinate(std::uint32_t shuffled, std::uint64_t a) noexcept {
  // Reversed once more it is the index.
  return unit_from_reversed(permuted_from_low_bits(shuffled, static_cast<std::uint32_t>(a >> 32)));
}

}  // namespace

Vec2 scrambled_sobol_2d(std::uint32_t index, std::uint64_t key) noexcept {
  const std::uint64_t a = mix(key, 0), b = mix(key, 1);
  const std::uint32_t shuffled = shuffled_index(index, a);
  const std::uint32_t y =
      permuted_from_low_bits(second_dimension(shuffled), static_cast<std::uint32_t>(b));
  return {first_coordinate(shuffled, a), unit_from_reversed(y)};
}

double scrambled_sobol_1d(std::uint32_t index, std::uint64_t key) noexcept {
  const std::uint64_t a = mix(key, 0);
  return first_coordinate(shuffled_index(index, a), a);
}

}  // namespace nadir
