#pragma once

#include <cstdint>

#include "core/random.hpp"
#include "core/sampler.hpp"

namespace nadir::radiometry {

/// The random numbers of one journey through volumes, in the order in which they are asked for. The
/// first decisions, which matter most, get low-discrepancy points; a thick grid asks thousands
/// of times, and the rest comes from a counter that a further point seeds.
class Draws {
 public:
  explicit Draws(const Sampler& numbers) noexcept : numbers_{numbers} {}

  [[nodiscard]] Vec2 next() noexcept {
    constexpr std::uint32_t points = 6;
    if (used_ < points) return numbers_.point(used_++);
    if (used_ == points) {
      const Vec2 seed = numbers_.point(used_++);
      // 32 bits of resolution each
      rng_ = Rng{static_cast<std::uint64_t>(seed.x * 0x1.0p32),
                 static_cast<std::uint64_t>(seed.y * 0x1.0p32)};
    }
    const double x = rng_.next();
    return {x, rng_.next()};
  }

 private:
  Sampler numbers_;
  std::uint32_t used_ = 0;
  Rng rng_{0};
};

}  // namespace nadir::radiometry
