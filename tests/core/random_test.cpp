#include "core/random.hpp"

#include <array>
#include <bit>
#include <cmath>
#include <vector>

#include "support/catch.hpp"
#include "support/statistics.hpp"

using namespace nadir;

// mix(seed, n) is output n of SplitMix64. Published outputs: seed 0, the reference program of
// S. Vigna (prng.di.unimi.it/splitmix64.c); seed 1234567, Rosetta Code, "Pseudo-random numbers".
TEST_CASE("mix gives the published outputs of SplitMix64", "[core][random]") {
  CHECK(mix(0, 0) == 0xE220A8397B1DCDAFULL);
  CHECK(mix(0, 1) == 0x6E789E6AA1B965F4ULL);
  CHECK(mix(0, 2) == 0x06C45D188009454FULL);
  CHECK(mix(1234567, 0) == 6457827717110365317ULL);
  CHECK(mix(1234567, 1) == 3203168211198807973ULL);
  CHECK(mix(1234567, 4) == 16408922859458223821ULL);
}

// Results must not change from one version to the next without our noticing. Pinned values: from an
// independent implementation in Python integers.
TEST_CASE("the numbers of a stream are the same for ever", "[core][random]") {
  Rng rng{42, 7};
  CHECK(rng.next_bits() == mix(mix(mix(0, 42), 7), 0));
  CHECK(rng.next_bits() == mix(mix(mix(0, 42), 7), 1));
  Rng pinned{1};
  CHECK(pinned.next_bits() == 0x80ABE802AC1E182EULL);
  CHECK(pinned.next_bits() == 0x949F48C1E9EB8A36ULL);
  CHECK(pinned.next() == 0.12765422614041944);
}

TEST_CASE("unit numbers lie in the half-open interval", "[core][random]") {
  CHECK(to_unit(0) == 0.0);
  CHECK(to_unit(~std::uint64_t{0}) == 1.0 - 0x1.0p-53);
  CHECK(to_unit(std::uint64_t{1} << 63) == 0.5);
}

// Chi-square with 256 cells and 256,000 draws sees a cell that is 10 % off with near certainty.
// Pairs of successive numbers in 32 x 32 cells see a correlation between neighbours.
TEST_CASE("random numbers and pairs of them are uniform", "[core][random]") {
  const double alpha = support::sidak(1e-3, 8);
  for (std::uint64_t stream = 0; stream < 4; ++stream) {
    Rng rng{support::test_seed(), stream};
    std::vector<double> single(256, 0.0), pairs(1024, 0.0);
    for (int i = 0; i < 128'000; ++i) {
      const double u = rng.next(), v = rng.next();
      single[static_cast<std::size_t>(u * 256.0)] += 1.0;
      single[static_cast<std::size_t>(v * 256.0)] += 1.0;
      pairs[static_cast<std::size_t>(u * 32.0) * 32 + static_cast<std::size_t>(v * 32.0)] += 1.0;
    }
    CAPTURE(stream);
    CHECK(support::chi_square_p_value(single) > alpha);
    CHECK(support::chi_square_p_value(pairs) > alpha);
  }
}

// Sums of products of centred numbers, z-test: var((u - 1/2)(v - 1/2)) = 1/144.
TEST_CASE("streams that differ in one bit of seed or number are uncorrelated", "[core][random]") {
  constexpr int draws = 2000;
  const double alpha = support::sidak(1e-3, 128);
  for (unsigned bit = 0; bit < 64; ++bit) {
    Rng base{5, 9}, other_stream{5, 9 ^ (std::uint64_t{1} << bit)},
        other_seed{5 ^ (std::uint64_t{1} << bit), 9};
    double a = 0.0, b = 0.0;
    for (int i = 0; i < draws; ++i) {
      const double u = base.next() - 0.5;
      a += u * (other_stream.next() - 0.5);
      b += u * (other_seed.next() - 0.5);
    }
    const double scale = 12.0 / std::sqrt(double{draws});
    CAPTURE(bit);
    CHECK(support::normal_p_value(a * scale) > alpha);
    CHECK(support::normal_p_value(b * scale) > alpha);
  }
}

// Avalanche: of 64 output bits half flip. Over 1000 counters the mean of the flipped count has the
// standard deviation 4 / sqrt(1000) = 0.126: 0.7 is 5.5 of them.
TEST_CASE("each bit of key or counter flips half of the output", "[core][random]") {
  for (unsigned bit = 0; bit < 64; ++bit) {
    const std::uint64_t flip = std::uint64_t{1} << bit;
    double by_key = 0.0, by_counter = 0.0;
    for (std::uint64_t n = 0; n < 1000; ++n) {
      by_key += std::popcount(mix(77, n) ^ mix(77 ^ flip, n));
      by_counter += std::popcount(mix(77, n) ^ mix(77, n ^ flip));
    }
    CAPTURE(bit);
    CHECK(by_key / 1000.0 == Approx(32.0).margin(0.7));
    CHECK(by_counter / 1000.0 == Approx(32.0).margin(0.7));
  }
}
