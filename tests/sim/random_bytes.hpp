#pragma once

#include <cstddef>
#include <cstdint>

namespace nadir::sim::support {

/// The small generator of G. Marsaglia, "Xorshift RNGs", J. Stat. Softw. 8(14), 2003: tests that
/// damage files need the same bytes on every machine.
class RandomBytes {
 public:
  explicit RandomBytes(std::uint32_t seed) : state_{seed} {}
  std::uint32_t below(std::size_t bound) {
    state_ ^= state_ << 13U;
    state_ ^= state_ >> 17U;
    state_ ^= state_ << 5U;
    return state_ % static_cast<std::uint32_t>(bound);
  }

 private:
  std::uint32_t state_;
};

}  // namespace nadir::sim::support
