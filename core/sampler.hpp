#pragma once

#include <cstdint>

#include "core/random.hpp"
#include "core/sobol.hpp"
#include "core/vec.hpp"

namespace nadir {

/// The random numbers of one path through the scene: Owen-scrambled Sobol points, addressed by
/// what they are used for, so that any pixel can be computed alone, in any order, on any thread.
///
/// `key` names the pixel, the replicate and the place in the tree of rays; `index` is the number of
/// the sample among those that are averaged. For one key the points of all indices are one
/// scrambled low-discrepancy set; different keys are independent.
class Sampler {
 public:
  constexpr Sampler(std::uint64_t key, std::uint32_t index) noexcept : key_{key}, index_{index} {}

  /// The 2-D point for the purpose `dimension`, in [0, 1)^2.
  [[nodiscard]] Vec2 point(std::uint32_t dimension) const noexcept {
    return scrambled_sobol_2d(index_, mix(key_, dimension));
  }
  /// The 1-D number for the purpose `dimension`, in [0, 1).
  [[nodiscard]] double number(std::uint32_t dimension) const noexcept {
    return scrambled_sobol_1d(index_, mix(key_, dimension));
  }

  /// The numbers of ray `branch` that leaves the present point.
  [[nodiscard]] constexpr Sampler child(std::uint32_t branch) const noexcept {
    return {mix(key_ ^ 0x5851F42D4C957F2DULL, branch), index_};
  }

 private:
  std::uint64_t key_;
  std::uint32_t index_;
};

}  // namespace nadir
